// Compares the solver with the reference over seeded random scenes: reference_scenes [COUNT [FIRST
// [linear | unilateral | compliant | bed]]]. Prints a line for each scene whose events are not those of the
// reference, and a summary; fails where a scene does not itself answer a rounding of its input with other
// events.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/analytic/reference/random_scenes.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"

int main(int arguments, char** values) {
  using namespace rockstack::testing;
  const std::uint64_t count = arguments > 1 ? std::strtoull(values[1], nullptr, 10) : 10000;
  const std::uint64_t first = arguments > 2 ? std::strtoull(values[2], nullptr, 10) : 0;
  const std::string kind = arguments > 3 ? values[3] : "";
  const rockstack::Equations equations =
      kind == "linear" ? rockstack::Equations::linear : rockstack::Equations::nonlinear;
  Tally tally;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const rockstack::Scene scene = kind == "unilateral"  ? rubbing_scene_of(seed)
                                   : kind == "compliant" ? springy_scene(seed)
                                   : kind == "bed"       ? bedded_scene(seed)
                                                         : drawn_scene(seed, equations);
    const std::string words = tally.add(seed, scene);
    if (!words.empty()) std::printf("%s\n", words.c_str());
    std::fflush(stdout);
  }
  std::printf("%s\n", tally.summary().c_str());
  return tally.unexplained == 0 ? 0 : 1;
}
