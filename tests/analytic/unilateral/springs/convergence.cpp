#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <limits>

#include "tests/analytic/unilateral/solve_unilateral.hpp"
#include "tests/analytic/unilateral/springs/explicit_steps.hpp"
#include "tests/analytic/unilateral/springs/random_springs.hpp"

namespace rockstack {
namespace {

/// How far explicit steps end from the exact motion, m or rad: the most of some steps, as where in a step
/// events come is chance.
double explicit_error(const Scene& scene, const History& history, std::initializer_list<double> steps) {
  const Bodies<> start = bodies_at(history, 0);
  std::vector<testing::PlaneBlock> blocks;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k)
    blocks.push_back({{start.pose[k].x, start.pose[k].y},
                      {start.velocity[k].x, start.velocity[k].y},
                      start.pose[k].angle,
                      start.velocity[k].angle});
  const double end = ends_early(history) ? history.events.back().time : scene.duration;
  const Poses<> last = bodies_at_end(history).pose;
  double error = 0;
  for (const double step : steps) {
    const auto found = testing::explicit_motion(scene, blocks, end, step);
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      const Pose<>& exact = last[k];
      error = std::max({error, std::abs(found[k].place - std::complex<double>(exact.x, exact.y)),
                        std::abs(found[k].angle - exact.angle)});
    }
  }
  return error;
}

class SoftScenes : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(OnSpringsOrBeds, SoftScenes, ::testing::Bool());

// A method of another kind, blind to events within its steps: an event that makes a force jump leaves an
// error of anything up to a share of the step. With steps of a sixth no scene is left with more than a third.
// Where forces are smooth, as those of a bed that one block leans on, the method is of order four, and
// nothing is left but what steps round places of the stack's height by.
TEST_P(SoftScenes, MoveAsExplicitStepsDo) {
  int slid = 0;
  int parted = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = testing::soft_scene(seed, GetParam());
    const History history = solve_unilateral(scene, {.sample_times = {0}, .end = true});
    const double coarse = explicit_error(scene, history, {1e-4, 7.7e-5, 5.9e-5});
    const double fine = explicit_error(scene, history, {1.7e-5, 1.3e-5, 1e-5});
    double height = 0;
    for (const Block& block : scene.blocks) height += 2 * block.half_height;
    const double rounding = scene.duration / 1e-5 * std::numeric_limits<double>::epsilon() * height;
    EXPECT_LT(fine, std::max(coarse / 3, rounding)) << seed;
    EXPECT_LT(coarse, 1e-3) << seed;
    for (const Event& event : history.events) {
      slid += event.kind == EventKind::slip ? 1 : 0;
      parted += event.kind == EventKind::part ? 1 : 0;
    }
  }
  EXPECT_GT(slid, 10);
  EXPECT_GT(parted, 10);
}

}  // namespace
}  // namespace rockstack
