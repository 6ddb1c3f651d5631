#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>

#include "tests/analytic/scene/ground/records/mutations.hpp"
#include "tests/analytic/scene/input/scene_mutations.hpp"

/// fuzz_scenes SECONDS SEED: reads mutated scene files until the time is up. Exit code 1 on the first wrong
/// outcome.
int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: fuzz_scenes SECONDS SEED\n", stderr);
    return 2;
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(std::strtoul(argv[1], nullptr, 10));
  try {
    const rockstack::TemporaryFolder folder;
    std::mt19937_64 random(std::strtoull(argv[2], nullptr, 10));
    unsigned long read = 0;
    unsigned long refused = 0;
    while (Clock::now() < end) {
      for (const auto& text : rockstack::scenes_with_every_key()) {
        ++(rockstack::is_read(folder, rockstack::mutated(text, random)) ? read : refused);
      }
    }
    std::printf("%lu read, %lu refused\n", read, refused);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wrong: %s\n", error.what());
    return 1;
  }
}
