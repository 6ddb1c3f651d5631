#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "analytic/solve.hpp"
#include "tests/analytic/reference/agreement.hpp"
#include "tests/analytic/reference/example_scenes.hpp"

namespace rockstack::testing {
namespace {

struct NamedScene {
  const char* name;
  Scene (*scene)();
  std::size_t settled;  ///< at least so many events come before the scene amplifies roundings a hundredfold
};

void PrintTo(const NamedScene& scene, std::ostream* out) {
  *out << scene.name;
}

/// What a rounding of the input grows to tells the stretches in which errors stay what they are from those in
/// which the scene itself amplifies them: events up to the first of the latter.
std::size_t settled_events(const Agreement& response) {
  constexpr double hundredfold = 100 * std::numeric_limits<double>::epsilon();
  std::size_t count = 0;
  for (const Deviation& own : response.events) {
    if (own.time > hundredfold || own.state > hundredfold) break;
    ++count;
  }
  return count;
}

class Reference : public ::testing::TestWithParam<NamedScene> {};

// Time and velocities of a flight are sums of some twenty terms, and its times are added up: errors as of a
// handful of roundings, each amplified as a rounding of the input is. Measured: at most 5.
TEST_P(Reference, IsMissedByAFewRoundingsTimesTheScenesOwnAmplification) {
  const Scene scene = GetParam().scene();
  const QuadHistory expected = reference(scene);
  const Agreement agreement = compare(solve(scene), expected);
  EXPECT_FALSE(agreement.parts.has_value()) << "at event " << *agreement.parts;
  const Agreement response = response_to_rounding(scene, expected);
  ASSERT_EQ(response.events.size(), expected.events.size());
  const std::size_t settled = settled_events(response);
  EXPECT_GE(settled, GetParam().settled);
  constexpr double few = 16;
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  for (std::size_t i = 0; i < agreement.events.size(); ++i) {
    const auto time = static_cast<double>(expected.events[i].time);
    const Deviation& found = agreement.events[i];
    const Deviation& own = response.events[i];
    EXPECT_LE(std::abs(found.time), few * (own.time + rounding * time)) << "event " << i;
    EXPECT_LE(found.state, few * (own.state + rounding)) << "event " << i;
    if (i < settled) {
      EXPECT_LT(std::abs(found.time), 1e-12) << "event " << i;
      EXPECT_LT(found.state, 1e-11) << "event " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference,
                         ::testing::Values(NamedScene{"two_blocks_free", two_blocks_free, 785},
                                           NamedScene{"two_blocks_recorded", two_blocks_recorded, 80},
                                           NamedScene{"one_block_free", one_block_free, 13},
                                           NamedScene{"one_block_pulse", one_block_pulse, 18}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace rockstack::testing
