// Compares the solver with the reference over seeded random scenes: reference_scenes [COUNT [FIRST
// [linear]]]. Prints a line for each scene whose events are not those of the reference, and a summary; fails
// where a scene does not itself answer a rounding of its input with other events.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/analytic/reference/random_scenes.hpp"

int main(int arguments, char** values) {
  using namespace rockstack::testing;
  const std::uint64_t count = arguments > 1 ? std::strtoull(values[1], nullptr, 10) : 10000;
  const std::uint64_t first = arguments > 2 ? std::strtoull(values[2], nullptr, 10) : 0;
  const bool linear = arguments > 3 && std::string(values[3]) == "linear";
  const rockstack::Equations equations =
      linear ? rockstack::Equations::linear : rockstack::Equations::nonlinear;
  Tally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string words = tally.add(seed, equations);
    if (!words.empty()) std::printf("%s\n", words.c_str());
    std::fflush(stdout);
  }
  std::printf("%s\n", tally.summary().c_str());
  return tally.unexplained == 0 ? 0 : 1;
}
