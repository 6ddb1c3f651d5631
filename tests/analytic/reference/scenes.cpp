// Compares the solver with the reference over seeded random scenes: reference_scenes [COUNT [FIRST
// [linear | unilateral | compliant | bed]]]. Prints a line for each scene whose events are not those of the
// reference, and a summary; fails where a scene does not itself answer a rounding of its input with other
// events.
//
// Measured: 10,000 random scenes (reference_scenes) with 183,307 events have every event of the reference and
// no other, except one, which parts from itself when a height changes by 16 roundings.
//
// Thirteen of 1,000 random scenes (reference_scenes 1000 1000 unilateral) part from runs of 113 bits: ten in
// a last flight of chatter, two in a mode that lasts no longer than a decision (below), one as roundings part
// it from itself. Times of the others are off by 2·10⁻⁷ s and less, which decisions leave, in all but 69 by
// less than 10⁻¹⁰ s.
//
// All 12348 events of the first 200 random scenes (reference_scenes 200 0 compliant, an hour and a half)
// were set beside 113 bits. Twenty-two scenes part: twelve in a mode that lasts no longer than a decision,
// five as a rounding of the input parts them too, three at the resolution of chatter, one where two impacts
// of one instant come together or one by one. The last, 197, parts after 164 events: before a corner parts
// it slips, for 3.9·10⁻¹¹ s, by which all its times are off by then. In scene 46 an impact comes 7.8·10⁻⁸ s
// late, as it does at 113 bits that decide as late as double. Frequencies and uplift angles of two springs
// and of a bed are those of closed forms to 10⁻¹⁰ there. Nine random scenes on beds (bed in place of
// compliant), seeds of 1 … 13 that take it less than five seconds, have all 67 events at the times of 113
// bits, to 10⁻¹² s.

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
