// Compares stacks of equal width with those of nearly equal width and with time steps:
// equal_width_scenes [COUNT [FIRST [SHARE [STEP]]]]. Prints a line for each scene that parts from its limits
// untold, or from time steps, and summaries; fails where there is no reason.

#include <cstdio>
#include <cstdlib>

#include "tests/analytic/unilateral/equal_widths.hpp"

int main(int arguments, char** values) {
  const std::uint64_t count = arguments > 1 ? std::strtoull(values[1], nullptr, 10) : 250;
  const std::uint64_t first = arguments > 2 ? std::strtoull(values[2], nullptr, 10) : 0;
  const double share = arguments > 3 ? std::strtod(values[3], nullptr) : 1e-9;
  const double step = arguments > 4 ? std::strtod(values[4], nullptr) : 1e-4;
  rockstack::testing::LimitTally limits;
  rockstack::testing::StepTally steps;
  bool explained = true;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string parted = limits.add(seed, share);
    explained = explained && parted.empty();
    for (const std::string& words : {parted, steps.add(seed, step)})
      if (!words.empty()) std::printf("%s\n", words.c_str());
    std::fflush(stdout);
  }
  std::printf("limits agree: %zu, part: %zu\ntime steps\n%s", limits.agree, limits.part,
              steps.summary().c_str());
  return explained && steps.scenes.back() == 0 ? 0 : 1;
}
