// Motions that other programs have written, in every form in which they may come: what is read is the motion
// itself.

#include "comparisons/suites/trajectory_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "comparisons/measures/results/csv.hpp"
#include "engines/body_record.hpp"
#include "engines/scene_setup.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// Two blocks, the upper of which slides and turns past half a turn would it not topple; law unilateral, as
/// blocks leave their pivots.
Scene two_blocks() {
  Scene scene;
  scene.law = Law::unilateral;
  scene.duration = 0.5;
  scene.blocks = {make_block(1, 2, 2500), make_block(0.8, 1, 1500)};
  scene.initial = {{0.05, -0.02}, {0.3, 0}};
  return scene;
}

constexpr double dt = 1e-2;

/// Smooth motion from the scene's start: angles and centres by cubic terms in time, with their rates.
Trajectory made_up_motion(const Scene& scene) {
  const Setup setup = set_up(scene, dt, {});
  Trajectory made;
  for (std::size_t i = 0; i <= setup.steps; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      const Placement& start = setup.blocks[k];
      const double t = static_cast<double>(i) * dt, turn = k == 0 ? -0.8 : 0.5;
      BodyState state{.x = start.x + start.velocity_x * t + 0.3 * t * t,
                      .y = start.y + start.velocity_y * t - 0.1 * t * t,
                      .velocity_x = start.velocity_x + 0.6 * t,
                      .velocity_y = start.velocity_y - 0.2 * t,
                      .angle = start.angle + start.angular_velocity * t + turn * t * t * t,
                      .angular_velocity = start.angular_velocity + 3 * turn * t * t};
      made.angles.push_back(state.angle);
      made.velocities.push_back(state.angular_velocity);
      made.bodies.push_back(state);
    }
  return made;
}

/// How a file differs from the scene's own axes.
struct FileForm {
  Eigen::Vector3d right = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double clock = 0;
  bool ground = false;  ///< moves to the right by 0.2 t², and all blocks with it
  double leaves = 0;    ///< speed out of the plane, m/s
};

std::string space_csv(const Trajectory& motion, const FileForm& form) {
  CsvWriter csv;
  csv.add("time", form.ground ? std::vector<std::string>{"x_0", "y_0", "z_0"} : std::vector<std::string>());
  csv.line(numbered_in_turn(
      {"x_", "y_", "z_", "qw_", "qx_", "qy_", "qz_", "vx_", "vy_", "vz_", "wx_", "wy_", "wz_"}, 2));
  const Eigen::Vector3d out = form.right.cross(form.up);
  for (std::size_t i = 0; i < motion.bodies.size(); i += 2) {
    const std::size_t sample = i / 2;
    const double t = static_cast<double>(sample) * dt;
    const Eigen::Vector3d way =
        form.ground ? 0.2 * t * t * form.right : Eigen::Vector3d(Eigen::Vector3d::Zero());
    const Eigen::Vector3d speed =
        form.ground ? 0.4 * t * form.right : Eigen::Vector3d(Eigen::Vector3d::Zero());
    csv.add(t + form.clock);
    if (form.ground) csv.add(way + form.origin);
    for (std::size_t k = i; k < i + 2; ++k) {
      const BodyState& body = motion.bodies[k];
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(-body.angle, out));
      csv.add(form.origin + way + body.x * form.right + body.y * form.up + form.leaves * t * out);
      csv.add(turn.w(), turn.x(), turn.y(), turn.z());
      // A file with the ground's place alone: its velocity is that of the step before.
      csv.add(Eigen::Vector3d(body.velocity_x * form.right + body.velocity_y * form.up + speed));
      csv.add(Eigen::Vector3d(-body.angular_velocity * out));
    }
    csv.end_line();
  }
  return csv.text();
}

/// Lengths of metres, turned and moved by some metres: a hundred roundings.
constexpr double round_off = 1e-13;

void expect_same(const Trajectory& found, const Trajectory& expected, const char* what) {
  ASSERT_EQ(found.bodies.size(), expected.bodies.size()) << what;
  for (std::size_t i = 0; i < expected.bodies.size(); ++i) {
    EXPECT_NEAR(found.angles[i], expected.angles[i], round_off) << what;
    EXPECT_NEAR(found.velocities[i], expected.velocities[i], round_off) << what;
    EXPECT_NEAR(found.bodies[i].x, expected.bodies[i].x, round_off) << what;
    EXPECT_NEAR(found.bodies[i].y, expected.bodies[i].y, round_off) << what;
    EXPECT_NEAR(found.bodies[i].velocity_y, expected.bodies[i].velocity_y, round_off) << what;
  }
}

TEST(TrajectoryFiles, InSpaceAreReadWhateverTheirAxesOriginAndClock) {
  const Scene scene = two_blocks();
  const Trajectory motion = made_up_motion(scene);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  const TemporaryFolder folder;
  for (const auto& [what, form] : {std::pair("y up", FileForm{}), std::pair("z up, x right", FileForm{x, z}),
                                   std::pair("z up, y right", FileForm{y, z}),
                                   std::pair("an origin of its own", FileForm{x, z, {3, -2, 5}}),
                                   std::pair("a clock of its own", FileForm{.clock = 7.5}),
                                   std::pair("a ground that moves", FileForm{x, z, {0, 0, 0}, 0, true})}) {
    const TrajectoryFile file = read_trajectory(folder.write("run.csv", space_csv(motion, form)), scene);
    EXPECT_EQ(file.dt, dt) << what;
    expect_same(file.trajectory, motion, what);
  }
}

TEST(TrajectoryFiles, InThePlaneAndOfAnglesAloneAreReadToTheBit) {
  Scene scene = two_blocks();
  const Trajectory motion = made_up_motion(scene);
  CsvWriter plane, angles;
  plane.line("time", numbered_in_turn({"x_", "y_", "theta_", "vx_", "vy_", "omega_"}, 2));
  angles.line("time", numbered("theta_", 2), numbered("omega_", 2), "pattern");
  for (std::size_t i = 0; i < motion.bodies.size(); i += 2) {
    const BodyState &lower = motion.bodies[i], &upper = motion.bodies[i + 1];
    const std::size_t sample = i / 2;
    const double t = static_cast<double>(sample) * dt;
    plane.line(t, lower.x, lower.y, lower.angle, lower.velocity_x, lower.velocity_y, lower.angular_velocity,
               upper.x, upper.y, upper.angle, upper.velocity_x, upper.velocity_y, upper.angular_velocity);
    angles.line(t, lower.angle, upper.angle, lower.angular_velocity, upper.angular_velocity, "1a");
  }
  const TemporaryFolder folder;
  const Trajectory found = read_trajectory(folder.write("plane.csv", plane.text()), scene).trajectory;
  expect_same(found, motion, "in the plane");
  EXPECT_EQ(found.angles, motion.angles);
  EXPECT_EQ(found.velocities, motion.velocities);
  const auto file = folder.write("angles.csv", angles.text());
  EXPECT_THROW(read_trajectory(file, scene), InputError) << "blocks slip, and nobody says how far";
  scene.law = Law::paper;
  const Trajectory turned = read_trajectory(file, scene).trajectory;
  EXPECT_EQ(turned.angles, motion.angles);
  EXPECT_EQ(turned.velocities, motion.velocities);
  EXPECT_TRUE(turned.bodies.empty());
}

// Semi-implicit Euler's velocities are those of the step before: so they come back where a file has poses
// alone.
TEST(TrajectoryFiles, RatesThatAreMissingAreThoseOfTheStepBefore) {
  const Scene scene = two_blocks();
  const auto setup = set_up(scene, dt, {});
  CsvWriter csv;
  csv.line("time", numbered_in_turn({"x_", "y_", "theta_"}, 2));
  std::vector<double> expected;
  double angle = setup.blocks[0].angle, rate = setup.blocks[0].angular_velocity;
  for (std::size_t i = 0; i <= setup.steps; ++i) {
    csv.line(static_cast<double>(i) * dt, setup.blocks[0].x, setup.blocks[0].y, angle, setup.blocks[1].x,
             setup.blocks[1].y, setup.blocks[1].angle);
    expected.push_back(rate);
    rate -= 2 * dt;
    angle += rate * dt;
  }
  const TemporaryFolder folder;
  const Trajectory found = read_trajectory(folder.write("run.csv", csv.text()), scene).trajectory;
  // A difference of angles of order one over a step of 10 ms.
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found.velocities[2 * i], expected[i], 1e-16 / dt * 2) << i;
}

TEST(TrajectoryFiles, WhatLeavesThePlaneIsToldByHowMuch) {
  const Scene scene = two_blocks();
  const TemporaryFolder folder;
  const auto file = folder.write(
      "run.csv", space_csv(made_up_motion(scene),
                           {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), {0, 4, 0}, 0, false, 0.1}));
  const TrajectoryFile read = read_trajectory(file, scene);
  const EngineRun run = engine_run_of(scene, set_up(scene, dt, {}), read.trajectory, true);
  EXPECT_NEAR(run.bodies->out_of_plane, 0.1 * scene.duration, round_off);
  EXPECT_NEAR(run.bodies->out_of_plane_tilt, 0, round_off);
}

TEST(TrajectoryFiles, WhatIsWrongIsOneLineWithItsPlace) {
  Scene scene = two_blocks();
  scene.law = Law::paper;
  scene.duration = 0.2;
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) -> std::string {
    const auto file = folder.write("run.csv", text);
    try {
      read_trajectory(file, scene);
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find("run.csv"));
    }
    return "read";
  };
  const std::string head = "time,theta_1,theta_2\n", start = "0,0.05,-0.02\n", end = "0.2,0.05,-0.02\n";
  EXPECT_EQ(refusal(head + start + "0.1,0.05,-0.02\n" + end), "read");
  for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"", "run.csv:1: empty"},
           {"t,theta_1,theta_2\n" + start + end, "run.csv:1: no column time"},
           {"time,angle\n0,1\n1,2\n", "run.csv:1: no column theta_1: must have time and"},
           {"time,theta_1\n0,0.05\n0.2,0.05\n", "run.csv:1: no column theta_2"},
           {"time,theta_1,theta_2,theta_3\n0,0.05,-0.02,0\n",
            "run.csv:1: theta_3: must be left out, the scene has 2"},
           {"time,x_1,y_1,theta_1,x_2,theta_2\n0,0,0,0,0,0\n", "run.csv:1: no column y_2"},
           {head + start + "0.1,0.05\n" + end, "run.csv:3: 2 cells; must be 3"},
           {head + start + "0.1,0.05,fast\n" + end, "run.csv:3: theta_2 = \"fast\": must be a number"},
           {head + start + "0.1,nan,0\n" + end, "run.csv:3: theta_1 = \"nan\": must be a number"},
           {head + start + "0,0.05,-0.02\n" + end, "run.csv:3: time = 0: must be above 0, the time before"},
           {head + "0,2.86,-1.15\n0.1,2.8,-1\n" + end,
            "run.csv:2: block 1 starts at an angle of 2.86 rad: must be 0.05"},
           {head + "0,-0.05,0.02\n0.1,-0.05,0.02\n" + end,
            "run.csv:2: block 1 starts at an angle of -0.05 rad"},
           {head + start + "0.05,0.05,-0.02\n", "run.csv:3: time = 0.05: must go on to 0.2 s"},
           {head + start, "run.csv: must have two samples or more"}})
    EXPECT_EQ(refusal(text).substr(0, expected.size()), expected) << text;
}

}  // namespace
}  // namespace rockstack
