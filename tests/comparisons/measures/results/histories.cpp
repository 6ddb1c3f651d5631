#include "comparisons/measures/results/tables.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// A block that rocks on its right edge until 0.2 s.
Scene rocking() {
  Scene scene;
  scene.duration = 0.2;
  scene.blocks = {make_block(1, 2, 2500)};
  scene.initial = {{0.2}, {0}};
  scene.inclination = 0.03;
  return scene;
}

std::vector<std::vector<double>> columns_of(const std::string& csv, const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  return read_columns(folder.write("table.csv", csv), names);
}

TEST(Histories, OfCornersLeaveThePivotInPlaceAndTurnTheOthersAboutIt) {
  const Scene scene = rocking();
  const History history = solve(scene, {.sample_times = {0, 0.1, 0.2}});
  const auto columns =
      columns_of(corners_csv(scene, history), {"lower_right_x_1", "lower_right_y_1", "lower_left_x_1",
                                               "lower_left_y_1", "upper_right_x_1", "upper_right_y_1"});
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double turn = history.angles[i];
    const std::vector<double> expected{
        0, 0, 1 - std::cos(turn), std::sin(turn), 2 * std::sin(turn), 2 * (std::cos(turn) - 1)};
    for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(columns[k][i], expected[k], 1e-14);
  }
}

TEST(Histories, OfEnergiesAddUpToAConstantInFreeMotion) {
  const Scene scene = rocking();
  const History history = solve(scene, {.sample_times = {0, 0.1, 0.2}});
  const auto columns = columns_of(energies_csv(scene, history), {"kinetic_1", "potential_1"});
  EXPECT_EQ(columns[0][0], 0);
  for (std::size_t i = 1; i < history.size(); ++i) {
    EXPECT_GT(columns[0][i], 1);
    EXPECT_NEAR(columns[0][i] + columns[1][i], columns[1][0], 1e-9);
  }
}

/// Beside gravity the tendon alone does work on the block, which stays over its pivot.
TEST(Histories, OfEnergiesAddUpToAConstantWithThoseOfTendons) {
  Scene scene = rocking();
  Restraint tendon;
  tendon.from = {1, 0.1, 2};
  tendon.to = {0, -0.2, -0.5};
  tendon.stiffness = 1e5;
  tendon.prestress = 5e3;
  scene.restraints = {tendon};
  const History history = solve(scene, {.sample_times = {0, 0.1, 0.2}});
  ASSERT_TRUE(history.events.empty()) << "an impact would lose energy";
  const auto columns = columns_of(energies_csv(scene, history), {"kinetic_1", "potential_1", "tendon_1"});
  for (std::size_t i = 1; i < history.size(); ++i) {
    EXPECT_GT(std::abs(columns[2][i] - columns[2][0]), 10);
    EXPECT_NEAR(columns[0][i] + columns[1][i] + columns[2][i], columns[1][0] + columns[2][0], 1e-8);
  }
}

TEST(Histories, AreThoseThatAreAskedFor) {
  const Scene scene = rocking();
  const History history = solve(scene, {.sample_times = {0, 0.1}});
  EXPECT_TRUE(histories_csv(scene, history, {}).empty());
  const auto files = histories_csv(scene, history, {"forces", "corners"});
  EXPECT_EQ(files.size(), 2U);
  EXPECT_TRUE(files.contains("reactions.csv"));
  EXPECT_THROW(histories_csv(scene, history, {"force"}), InputError);
}

}  // namespace
}  // namespace rockstack
