#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>

#include "tests/analytic/scene/ground/records/mutations.hpp"

/// fuzz_records SECONDS SEED: reads mutated records until the time is up. Exit code 1 on the first wrong
/// outcome.
int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: fuzz_records SECONDS SEED\n", stderr);
    return 2;
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(std::strtoul(argv[1], nullptr, 10));
  try {
    std::mt19937_64 random(std::strtoull(argv[2], nullptr, 10));
    const auto texts = rockstack::one_of_each_layout();
    unsigned long read = 0;
    unsigned long refused = 0;
    while (Clock::now() < end) {
      for (const auto& text : texts) {
        const auto outcome = rockstack::outcome_of(rockstack::mutated(text, random));
        ++(outcome == rockstack::Outcome::record ? read : refused);
      }
    }
    std::printf("%lu read, %lu refused\n", read, refused);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wrong: %s\n", error.what());
    return 1;
  }
}
