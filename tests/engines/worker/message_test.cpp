// What goes into a message comes out of it, to the last bit.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "engines/worker/request.hpp"
#include "tests/analytic/scene/ground/records/mutations.hpp"

namespace rockstack {
namespace {

Scene full_scene() {
  Scene scene;
  scene.title = "Zwei Blöcke";
  scene.duration = 0.1;
  scene.gravity = 1.62;
  scene.law = Law::consistent;
  scene.equations = Equations::linear;
  scene.blocks = {make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2400)};
  scene.initial = {{0.15, -0.0}, {0.1 + 0.2, 5e-324}};
  scene.horizontal = {0.02, {0, 1.5, -2.25}, "record.at2", true, {}};
  scene.vertical.pulse = Pulse{PulseShape::ricker, 2.5, 0.3, 0.1, 2, 0.7};
  scene.engine = {0.3, 2};
  return scene;
}

BodyRecord full_record() {
  return {.energy = {1.5, 2},
          .input = {0, 0.5},
          .penetration = {0, 1e-3},
          .elastic = {0, 0.1},
          .complementarity = 1,
          .friction_excess = 2,
          .impacts = {{0.05, 1, 0.3, -0.2}},
          .gap = 0.125,
          .slip = 0.25,
          .out_of_plane = 0,
          .out_of_plane_tilt = 0};
}

TEST(Messages, SceneComesBackAsItWas) {
  const Request sent{RunRequest{"step", full_scene(), 1e-3, {{"erp", 0.2}, {"limit", HUGE_VAL}}, 3}};
  const std::string bytes = to_bytes(sent);
  const Request read = read_request(bytes);
  ASSERT_TRUE(read.run);
  // Equal bytes of what was read: no field was dropped or changed.
  EXPECT_EQ(to_bytes(read), bytes);
  EXPECT_EQ(read.run->scene.title, "Zwei Blöcke");
  EXPECT_TRUE(std::signbit(read.run->scene.initial.angles[1]));
  EXPECT_EQ(read.run->scene.initial.velocities[1], 5e-324);
  EXPECT_EQ(read.run->scene.horizontal.samples, (std::vector<double>{0, 1.5, -2.25}));
  EXPECT_EQ(read.run->scene.vertical.pulse->shape, PulseShape::ricker);
  EXPECT_EQ(read.run->scene.law, Law::consistent);
  EXPECT_EQ(read.run->parameters.at("limit"), HUGE_VAL);
}

/// A change of one field; of each, other bytes are to come back.
template <class Message>
using Change = std::function<void(Message&)>;

TEST(Messages, EveryFieldOfARequestIsInIt) {
  const RunRequest given{"step", full_scene(), 1e-3, {{"erp", 0.2}}, 3};
  const std::vector<Change<RunRequest>> changes{
      [](RunRequest& run) { run.solver = "quickstep"; },
      [](RunRequest& run) { run.dt = 2e-3; },
      [](RunRequest& run) { run.parameters["erp"] = 0.3; },
      [](RunRequest& run) { run.repeats = 4; },
      [](RunRequest& run) { run.bodies = true; },
      [](RunRequest& run) { run.scene.duration = 2; },
      [](RunRequest& run) { run.scene.gravity = 2; },
      [](RunRequest& run) { run.scene.law = Law::paper; },
      [](RunRequest& run) { run.scene.equations = Equations::nonlinear; },
      [](RunRequest& run) { run.scene.blocks[1].half_width = 7; },
      [](RunRequest& run) { run.scene.blocks[1].half_height = 7; },
      [](RunRequest& run) { run.scene.blocks[1].mass = 7; },
      [](RunRequest& run) { run.scene.blocks[1].inertia = 7; },
      [](RunRequest& run) { run.scene.initial.angles[1] = 0.2; },
      [](RunRequest& run) { run.scene.initial.velocities[1] = 0.2; },
      [](RunRequest& run) { run.scene.horizontal.interval = 0.03; },
      [](RunRequest& run) { run.scene.horizontal.samples[1] = 2; },
      [](RunRequest& run) { run.scene.horizontal.made_up = false; },
      [](RunRequest& run) { run.scene.vertical.pulse->shape = PulseShape::sine; },
      [](RunRequest& run) { run.scene.vertical.pulse->amplitude = 7; },
      [](RunRequest& run) { run.scene.vertical.pulse->period = 7; },
      [](RunRequest& run) { run.scene.vertical.pulse->start = 7; },
      [](RunRequest& run) { run.scene.vertical.pulse->cycles = 7; },
      [](RunRequest& run) { run.scene.vertical.pulse->phase = 7; },
      [](RunRequest& run) { run.scene.engine.friction = 7; },
      [](RunRequest& run) { run.scene.engine.depth = 7; }};
  std::set<std::string> messages{to_bytes(Request{given})};
  for (const auto& change : changes) {
    RunRequest changed = given;
    change(changed);
    messages.insert(to_bytes(read_request(to_bytes(Request{changed}))));
  }
  EXPECT_EQ(messages.size(), changes.size() + 1);
}

TEST(Messages, EveryFieldOfAReplyIsInIt) {
  RunReply given{"done", "", {}, 4, {0.1, 0.2}, 1e6, full_record()};
  given.history.blocks = 1;
  given.history.times = {0, 0.1};
  given.history.angles = given.history.velocities = given.history.slips = given.history.gaps = {0, 0};
  given.history.places = {0, 0, 0, 0};
  const std::vector<Change<RunReply>> changes{[](RunReply& run) { run.status = "failed"; },
                                              [](RunReply& run) { run.reason = "why"; },
                                              [](RunReply& run) { run.history.blocks = 2; },
                                              [](RunReply& run) { run.history.times[1] = 7; },
                                              [](RunReply& run) { run.history.angles[1] = 7; },
                                              [](RunReply& run) { run.history.velocities[1] = 7; },
                                              [](RunReply& run) { run.history.slips[1] = 7; },
                                              [](RunReply& run) { run.history.gaps[1] = 7; },
                                              [](RunReply& run) { run.history.places[3] = 7; },
                                              [](RunReply& run) { run.warnings = 7; },
                                              [](RunReply& run) { run.seconds[1] = 7; },
                                              [](RunReply& run) { run.peak_memory = 7; },
                                              [](RunReply& run) { run.bodies->energy[1] = 7; },
                                              [](RunReply& run) { run.bodies->input[1] = 7; },
                                              [](RunReply& run) { run.bodies->penetration[1] = 7; },
                                              [](RunReply& run) { run.bodies->elastic[1] = 7; },
                                              [](RunReply& run) { run.bodies->complementarity = 7; },
                                              [](RunReply& run) { run.bodies->complementarity.reset(); },
                                              [](RunReply& run) { run.bodies->friction_excess = 7; },
                                              [](RunReply& run) { run.bodies->impacts.clear(); },
                                              [](RunReply& run) { run.bodies->impacts[0].time = 7; },
                                              [](RunReply& run) { run.bodies->impacts[0].interface = 7; },
                                              [](RunReply& run) { run.bodies->impacts[0].speed = 7; },
                                              [](RunReply& run) { run.bodies->impacts[0].after = 7; },
                                              [](RunReply& run) { run.bodies->gap = 7; },
                                              [](RunReply& run) { run.bodies->slip = 7; },
                                              [](RunReply& run) { run.bodies->out_of_plane = 7; },
                                              [](RunReply& run) { run.bodies->out_of_plane_tilt = 7; }};
  std::set<std::string> messages{to_bytes(Reply{{}, given})};
  for (const auto& change : changes) {
    RunReply changed = given;
    change(changed);
    messages.insert(to_bytes(read_reply(to_bytes(Reply{{}, changed}))));
  }
  EXPECT_EQ(messages.size(), changes.size() + 1);
}

TEST(Messages, HistoryComesBackWithItsNumbersThatAreNone) {
  Reply sent;
  sent.run = RunReply{"done", "", {}, 4, {0.1, 0.2}, 1e6, {}};
  sent.run->history.blocks = 1;
  sent.run->history.times = {0, 0.1};
  sent.run->history.angles = {0.2, std::nan("")};
  sent.run->history.velocities = {0, -HUGE_VAL};
  sent.run->bodies = full_record();
  const Reply read = read_reply(to_bytes(sent));
  ASSERT_TRUE(read.run);
  EXPECT_EQ(to_bytes(read), to_bytes(sent));
  EXPECT_TRUE(std::isnan(read.run->history.angles[1]));
  EXPECT_EQ(read.run->warnings, 4U);
  EXPECT_EQ(read.run->bodies->energy, sent.run->bodies->energy);
  EXPECT_EQ(read.run->bodies->slip, 0.25);
  EXPECT_EQ(read.run->bodies->impacts.at(0).speed, 0.3);
}

TEST(Messages, EveryShorterMessageIsRefused) {
  const std::string bytes = to_bytes(Request{RunRequest{"step", full_scene(), 1e-3, {{"erp", 0.2}}, 3}});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(read_request(std::string_view(bytes).substr(0, size)), std::runtime_error) << size;
  }
}

TEST(Messages, DamagedOnesAreReadOrRefusedAndNothingElse) {
  RunReply reply{"done", "", {}, 4, {0.1, 0.2}, 1e6, full_record()};
  reply.history.times = {0, 0.1};
  reply.history.angles = reply.history.velocities = {0, 0};
  const EngineDescription engine{"ode", "step", "0.16", 1e9, {{"erp", 0.1, 0.2, 0, 1}}};
  const std::string asked = to_bytes(Request{RunRequest{"step", full_scene(), 1e-3, {{"erp", 0.2}}, 3}});
  std::mt19937_64 random(1983);
  int refused = 0;
  const auto read = [&](const auto& reader, const std::string& bytes) {
    try {
      reader(mutated(bytes, random));
    } catch (const std::runtime_error&) {
      ++refused;
    }
  };
  constexpr int rounds = 3000;
  for (int round = 0; round < rounds; ++round) {
    ASSERT_NO_THROW(read(read_request, asked));
    ASSERT_NO_THROW(read(read_reply, to_bytes(Reply{{}, reply})));
    ASSERT_NO_THROW(read(read_reply, to_bytes(Reply{{engine, engine}, {}})));
  }
  EXPECT_GT(refused, rounds) << "mutations must do harm";
}

TEST(Messages, OtherBytesAreRefused) {
  EXPECT_THROW(read_reply(std::string(64, 'x')), std::runtime_error);
}

}  // namespace
}  // namespace rockstack
