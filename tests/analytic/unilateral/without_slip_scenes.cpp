// Compares law unilateral with law consistent over seeded random scenes: without_slip_scenes [COUNT [FIRST]].
// Prints a line for each scene in which the motions part without a reason or deviate too much, and a summary;
// fails where there is one.

#include <cstdio>
#include <cstdlib>

#include "tests/analytic/unilateral/two_laws.hpp"

int main(int arguments, char** values) {
  const std::uint64_t count = arguments > 1 ? std::strtoull(values[1], nullptr, 10) : 10000;
  const std::uint64_t first = arguments > 2 ? std::strtoull(values[2], nullptr, 10) : 0;
  rockstack::testing::LawTally tally;
  bool explained = true;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string words = tally.add(seed, rockstack::testing::gripping_scene(seed));
    if (words.empty()) continue;
    explained = false;
    std::printf("%s\n", words.c_str());
    std::fflush(stdout);
  }
  std::printf("%s\n", tally.summary().c_str());
  return explained ? 0 : 1;
}
