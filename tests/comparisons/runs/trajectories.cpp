// A motion that was written down gets the row of the run that it is of.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <set>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/runs/compare.hpp"
#include "engines/scene_setup.hpp"
#include "tests/native_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

NamedScene rocking_scene(const TemporaryFolder& folder) {
  return read_named_scene(folder.write("rocking.toml", R"(duration = 1.5
law = "paper"
[[blocks]]
width = 1.25
height = 1.25
density = 2500
[[blocks]]
width = 1.0
height = 2.5
density = 2500
[initial]
angles = [0.15, 0.15]
)"),
                          {});
}

/// Poses in space, z up, with all rates, as a simulator tells them; `tilt` turns each block out of the plane.
std::string poses_csv(const Trajectory& motion, double step, std::size_t blocks, double tilt) {
  CsvWriter csv;
  csv.line("time", numbered_in_turn({"x_", "y_", "z_", "qw_", "qx_", "qy_", "qz_", "vx_", "vy_", "vz_", "wx_",
                                     "wy_", "wz_"},
                                    static_cast<int>(blocks)));
  for (std::size_t i = 0; i < motion.bodies.size(); ++i) {
    const BodyState& body = motion.bodies[i];
    const std::size_t sample = i / blocks;
    if (i % blocks == 0) csv.add(static_cast<double>(sample) * step);
    const Eigen::Quaterniond turn = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(motion.angles[i], Eigen::Vector3d::UnitY());
    csv.add(body.x, 0, body.y, turn.w(), turn.x(), turn.y(), turn.z(), body.velocity_x, 0, body.velocity_y, 0,
            motion.velocities[i], 0);
    if (i % blocks + 1 == blocks) csv.end_line();
  }
  return csv.text();
}

/// Columns in which a recorded run differs: who made it, when, and what contacts alone tell.
const std::set<std::string> of_its_own{"repeats",
                                       "run",
                                       "engine",
                                       "solver",
                                       "settings",
                                       "rank",
                                       "complementarity_residual",
                                       "friction_cone_violation",
                                       "contact_stiffness",
                                       "contact_damping",
                                       "contact_points",
                                       "contact_damping_ratio",
                                       "contact_restitution",
                                       "contact_impacts_matched",
                                       "contact_impacts_missed",
                                       "contact_impacts_extra",
                                       "impact_readings_differ",
                                       "energy_gain"};

/// Numbers to rounding of angles: an RMS difference of 1e-2 and times by them.
void expect_same_cells(const RunMetrics& found, const RunMetrics& expected) {
  int compared = 0;
  for (const Column& column : columns()) {
    if (column.measured || of_its_own.contains(column.name)) continue;
    const Json one = column.cell(found), other = column.cell(expected);
    if (one.is_number() && other.is_number()) {
      EXPECT_NEAR(one.get<double>(), other.get<double>(),
                  1e-9 * std::max(1e-2, std::abs(other.get<double>())))
          << column.name;
    } else {
      EXPECT_EQ(one, other) << column.name;
    }
    compared += one.is_null() ? 0 : 1;
  }
  EXPECT_GT(compared, 40);
}

TEST(Trajectories, ARunThatWasWrittenDownHasTheRowOfTheRun) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const WorkerEngine& engine = native_engines().front();
  const TemporaryFolder folder;
  constexpr double step = 1e-3;
  Suite suite = suite_for(rocking_scene(folder), {{engine.full_name()}, {step}, true});
  suite.series.resize(1);
  suite.replicates.runs = 1;
  const Scene& scene = suite.scenes.front().scene;
  const Parameters& parameters = suite.series.front().parameters;
  const Trajectory motion = run(engine, set_up(scene, step, parameters), parameters, true);
  const auto file = folder.write("run.csv", poses_csv(motion, step, 2, 0));
  suite.series.push_back(trajectory_series({"elsewhere", {file}}, suite.scenes.front(), "a test"));
  const auto tilted = folder.write("tilted.csv", poses_csv(motion, step, 2, 0.05));
  suite.series.push_back(trajectory_series({"tilted", {tilted, file}}, suite.scenes.front(), "a test"));
  const std::filesystem::path out = folder.path() / "out";
  std::filesystem::create_directory(out);
  const auto rows = compare({suite}, out, *make_threads(1), {}).rows;
  ASSERT_EQ(rows.size(), 4u);
  ASSERT_EQ(rows[2].status, RunStatus::done) << rows[2].reason;
  expect_same_cells(rows[2], rows[1]);
  EXPECT_EQ(rows[2].engine, "elsewhere");
  EXPECT_FALSE(rows[2].stepping_time_minimum || rows[2].processor_time || rows[2].draws)
      << "no cost, no replicates";
  EXPECT_EQ(rows[3].draws, 2) << "a file each";
  EXPECT_NEAR(*rows[3].out_of_plane_tilt, std::sin(0.05) / 2, 1e-12) << "the median of both";
  EXPECT_NE(rows[3].outcome.find("leaves the plane by 62 mm in 1 of 2 replicates"), std::string::npos)
      << rows[3].outcome;
}

TEST(Trajectories, OfAnotherFileIsMadeAgainAndOfTheSameNot) {
  const TemporaryFolder folder;
  Suite suite = suite_for(rocking_scene(folder), {.steps = {1e-2}, .quick = true});
  suite.series.clear();
  suite.scenes.front().scene.duration = 0.2;
  const auto compared = [&](double fall) {
    std::string text = "time,theta_1,theta_2\n0,0.15,0.15\n";
    for (int i = 1; i <= 20; ++i) text += fmt::format("{0},{1},{1}\n", 0.01 * i, 0.15 - fall * i * i);
    const auto file = folder.write("run.csv", text);
    suite.series = {trajectory_series({"elsewhere", {file}}, suite.scenes.front(), "a test")};
    std::filesystem::create_directories(folder.path() / "out");
    return compare({suite}, folder.path() / "out", *make_threads(1), {});
  };
  const CompareResult first = compared(1e-4), again = compared(1e-4), other = compared(2e-4);
  EXPECT_EQ(first.reused, 0u);
  EXPECT_EQ(again.reused, 2u);
  EXPECT_EQ(other.reused, 1u) << "the exact motion alone";
  EXPECT_NE(other.rows[1].error, first.rows[1].error);
}

TEST(Trajectories, NamesOfEnginesAreTaken) {
  const TemporaryFolder folder;
  const auto file = folder.write("run.csv", "time,theta_1,theta_2\n0,0.15,0.15\n1.5,0.15,0.15\n");
  const NamedScene scene = rocking_scene(folder);
  EXPECT_EQ(trajectory_series({"isaac-5_1", {file}}, scene, "a test").engine->name, "isaac-5_1");
  for (const char* name : {"", "exact", "a b", "../up"})
    EXPECT_THROW(trajectory_series({name, {file}}, scene, "a test"), InputError) << name;
  if (native_engines().empty()) return;
  const std::string& taken = native_engines().front().get().name;
  EXPECT_THROW(trajectory_series({taken, {file}}, scene, "a test"), InputError);
}

}  // namespace
}  // namespace rockstack
