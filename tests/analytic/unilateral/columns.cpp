#include <gtest/gtest.h>

#include <vector>

#include "tests/analytic/unilateral/momentum_laws.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack {
namespace {

/// A block of a column, m.
struct Size {
  double width, height;
};

/// A column that leans as one, with the same friction at all interfaces, one.
Scene leaning_column(const std::vector<Size>& sizes, double angle, double duration) {
  std::vector<Block> blocks;
  for (const auto& [width, height] : sizes) blocks.push_back(testing::block(width, height));
  return testing::with_friction(
      testing::released(blocks, std::vector<double>(blocks.size(), angle), duration), 1);
}

// Columns of seven and ten, in whose impacts Lemke's method comes to its answer next to a ray: the artificial
// variable is zero but for rounding, and no other may leave. Durations are a little beyond the first of them.
TEST(Columns, GoOnWhereTheArtificialVariableIsZeroNextToARay) {
  const std::vector<Scene> scenes{
      leaning_column(
          {{0.91, 0.42}, {0.85, 0.81}, {0.85, 0.53}, {0.8, 0.6}, {0.82, 0.77}, {0.79, 0.81}, {0.79, 0.84}},
          0.026, 3.6),
      leaning_column({{0.97, 0.41},
                      {0.91, 0.42},
                      {0.85, 0.45},
                      {0.85, 0.81},
                      {0.85, 0.53},
                      {0.85, 0.57},
                      {0.82, 0.77},
                      {0.79, 0.87},
                      {0.79, 0.81},
                      {0.79, 0.84}},
                     0.026, 0.21)};
  for (const Scene& scene : scenes) {
    SCOPED_TRACE(scene.blocks.size());
    const testing::ImpactTally tally = testing::impacts_by_momenta(scene, solve_unilateral(scene));
    EXPECT_GE(tally.impacts, 3);
    EXPECT_EQ(tally.broken, 0);
  }
}

}  // namespace
}  // namespace rockstack
