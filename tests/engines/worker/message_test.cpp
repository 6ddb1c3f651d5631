// What goes into a message comes out of it, to the last bit and in either form; whatever else comes is
// refused.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "analytic/scene/solve_options.hpp"
#include "engines/worker/request.hpp"
#include "tests/analytic/scene/ground/records/mutations.hpp"

namespace rockstack {
namespace {

Request full_request() {
  RunRequest run{"step", {}, {{"erp", 0.2}, {"limit", HUGE_VAL}}, 3, true};
  run.setup = {.blocks = {{.x = -0.0, .y = 5e-324, .angle = 0.1 + 0.2, .width = 1, .mass = 2500}, {}},
               .friction = {0.3, 1000},
               .gravity = {0.5, -9.81},
               .toppling_angles = {0.7, 0.4},
               .dt = 1e-3,
               .steps = 2,
               .accelerations = {{1, -9}, {2, -8}},
               .ground = {{1, 2, 3, 4}, {5, 6, 7, 8}},
               .pushes = {{{1, 0.1, 0.2}, 0.6, 0.8, {5, 6}}},
               .restraints = {{.from = {2, 0.3, 0.4}, .to = {0, 0.5, -0.6}, .length = 2, .stiffness = 3}},
               .lookahead = 5e-4};
  run.warm_up = 4000;
  run.reactions = true;
  return {run};
}

Reply full_reply() {
  RunReply run{"done", "why", {}, {0.1, 0.2}, 1e6};
  run.trajectory = {.angles = {0.2, std::nan("")},
                    .velocities = {0, -HUGE_VAL},
                    .bodies = {{.x = 1, .y = 2, .velocity_x = 3, .velocity_y = 4, .z = 5, .tilt = 6}, {}},
                    .contacts = ContactRecord{{0, 0.1}, 1, 2, 3e5, 40, {{0.05, 1, 0.3, -0.2}}},
                    .warnings = 4,
                    .reactions = {{1, 2, 3}, {4, 5, std::nan("")}}};
  run.warm_up = 4002;
  return {{}, run};
}

Reply full_description() {
  const EngineDescription engine{.name = "ode",
                                 .solver = "step",
                                 .version = "0.16",
                                 .licence = "BSD-3-Clause",
                                 .capabilities = {.largest_friction = 10,
                                                  .single_precision = true,
                                                  .planar = true,
                                                  .center_of_mass = true,
                                                  .lead = 0,
                                                  .tuned_lead = 1},
                                 .warm_up = 4000,
                                 .settings = {{.name = "erp",
                                               .unit = "m/s",
                                               .choices = {"soft", "hard"},
                                               .default_value = 0.1,
                                               .tuned = 0.2,
                                               .most = HUGE_VAL},
                                              {.name = "cfm",
                                               .default_value = 1,
                                               .tuned = 2,
                                               .most = 3,
                                               .role = SettingRole::restitution_threshold}}};
  return {{engine, engine}, {}};
}

std::string again(const Request& request, Form form) {
  return to_bytes(read_request(read_message(to_bytes(request, form))), form);
}

std::string again(const Reply& reply, Form form) {
  return to_bytes(read_reply(read_message(to_bytes(reply, form))), form);
}

class Messages : public testing::TestWithParam<Form> {};

TEST_P(Messages, ComeBackAsTheyWere) {
  EXPECT_EQ(again(full_request(), GetParam()), to_bytes(full_request(), GetParam()));
  EXPECT_EQ(again(full_reply(), GetParam()), to_bytes(full_reply(), GetParam()));
  EXPECT_EQ(again(full_description(), GetParam()), to_bytes(full_description(), GetParam()));
  EXPECT_EQ(again(Request{}, GetParam()), to_bytes(Request{}, GetParam()));
}

TEST_P(Messages, KeepEveryBitOfTheirNumbers) {
  const Request read = read_request(read_message(to_bytes(full_request(), GetParam())));
  ASSERT_TRUE(read.run);
  EXPECT_TRUE(std::signbit(read.run->setup.blocks[0].x));
  EXPECT_EQ(read.run->setup.blocks[0].y, 5e-324);
  EXPECT_EQ(read.run->setup.blocks[0].angle, 0.1 + 0.2);
  EXPECT_EQ(read.run->parameters.at("limit"), HUGE_VAL);
  const Reply reply = read_reply(read_message(to_bytes(full_reply(), GetParam())));
  ASSERT_TRUE(reply.run);
  EXPECT_TRUE(std::isnan(reply.run->trajectory.angles[1]));
  EXPECT_EQ(reply.run->trajectory.velocities[1], -HUGE_VAL);
}

/// A change of one field; of each, other bytes are to come back.
template <class Part>
using Change = std::function<void(Part&)>;

TEST_P(Messages, HaveEveryFieldOfARequest) {
  const std::vector<Change<RunRequest>> changes{
      [](RunRequest& run) { run.solver = "quickstep"; },
      [](RunRequest& run) { run.parameters["erp"] = 0.3; },
      [](RunRequest& run) {
        run.setup.wall = FixedBox{-1, 2, 2, 4, 1};
      },
      [](RunRequest& run) { run.setup.kinetic_friction = {0.1}; },
      [](RunRequest& run) { run.setup.pushes[0].point.block = 2; },
      [](RunRequest& run) { run.setup.pushes[0].point.x = 7; },
      [](RunRequest& run) { run.setup.pushes[0].point.y = 7; },
      [](RunRequest& run) { run.setup.pushes[0].direction_x = 7; },
      [](RunRequest& run) { run.setup.pushes[0].direction_y = 7; },
      [](RunRequest& run) { run.setup.pushes[0].forces[1] = 7; },
      [](RunRequest& run) { run.setup.pushes.clear(); },
      [](RunRequest& run) { run.setup.restraints[0].from.block = 1; },
      [](RunRequest& run) { run.setup.restraints[0].to.block = 1; },
      [](RunRequest& run) { run.setup.restraints[0].to.y = 7; },
      [](RunRequest& run) { run.setup.restraints[0].length = 7; },
      [](RunRequest& run) { run.setup.restraints[0].stiffness = 7; },
      [](RunRequest& run) { run.setup.restraints[0].prestress = 7; },
      [](RunRequest& run) { run.setup.restraints[0].yield = 7; },
      [](RunRequest& run) { run.setup.restraints[0].damping = 7; },
      [](RunRequest& run) { run.setup.restraints.clear(); },
      [](RunRequest& run) { run.setup.lookahead = 7; },
      [](RunRequest& run) { run.repeats = 4; },
      [](RunRequest& run) { run.bodies = false; },
      [](RunRequest& run) { run.reactions = false; },
      [](RunRequest& run) { run.warm_up = 0; },
      [](RunRequest& run) { run.setup.dt = 2e-3; },
      [](RunRequest& run) { run.setup.steps = 7; },
      [](RunRequest& run) { run.setup.gravity.x = 7; },
      [](RunRequest& run) { run.setup.gravity.y = 7; },
      [](RunRequest& run) { run.setup.friction[1] = 7; },
      [](RunRequest& run) { run.setup.toppling_angles[1] = 7; },
      [](RunRequest& run) { run.setup.accelerations[1].x = 7.5; },
      [](RunRequest& run) { run.setup.accelerations[1].y = 7; },
      [](RunRequest& run) { run.setup.accelerations.clear(); },
      [](RunRequest& run) { run.setup.ground[1].x = 9; },
      [](RunRequest& run) { run.setup.ground[1].y = 9; },
      [](RunRequest& run) { run.setup.ground[1].velocity_x = 9; },
      [](RunRequest& run) { run.setup.ground[1].velocity_y = 9; },
      [](RunRequest& run) { run.setup.ground.clear(); },
      [](RunRequest& run) { run.setup.blocks[1].x = 7; },
      [](RunRequest& run) { run.setup.blocks[1].y = 7; },
      [](RunRequest& run) { run.setup.blocks[1].velocity_x = 7; },
      [](RunRequest& run) { run.setup.blocks[1].velocity_y = 7; },
      [](RunRequest& run) { run.setup.blocks[1].angle = 7; },
      [](RunRequest& run) { run.setup.blocks[1].angular_velocity = 7; },
      [](RunRequest& run) { run.setup.blocks[1].width = 7; },
      [](RunRequest& run) { run.setup.blocks[1].height = 7; },
      [](RunRequest& run) { run.setup.blocks[1].depth = 7; },
      [](RunRequest& run) { run.setup.blocks[1].offset_x = 7; },
      [](RunRequest& run) { run.setup.blocks[1].offset_y = 7; },
      [](RunRequest& run) { run.setup.blocks[1].mass = 7; },
      [](RunRequest& run) { run.setup.blocks[1].inertia = 7; },
      [](RunRequest& run) { run.setup.blocks[1].inertia_about_x = 7; },
      [](RunRequest& run) { run.setup.blocks[1].inertia_about_y = 7; }};
  std::set<std::string> messages{to_bytes(full_request(), GetParam())};
  for (const auto& change : changes) {
    Request changed = full_request();
    change(*changed.run);
    messages.insert(again(changed, GetParam()));
  }
  EXPECT_EQ(messages.size(), changes.size() + 1);
}

TEST_P(Messages, HaveEveryFieldOfAReply) {
  const std::vector<Change<RunReply>> changes{
      [](RunReply& run) { run.status = "failed"; },
      [](RunReply& run) { run.reason = "because"; },
      [](RunReply& run) { run.seconds[1] = 7; },
      [](RunReply& run) { run.peak_memory = 7; },
      [](RunReply& run) { run.warm_up.reset(); },
      [](RunReply& run) { run.trajectory.angles[0] = 7; },
      [](RunReply& run) { run.trajectory.velocities[0] = 7; },
      [](RunReply& run) { run.trajectory.warnings = 7; },
      [](RunReply& run) { run.trajectory.bodies[1].x = 7; },
      [](RunReply& run) { run.trajectory.bodies[1].y = 7; },
      [](RunReply& run) { run.trajectory.bodies[1].velocity_x = 7; },
      [](RunReply& run) { run.trajectory.bodies[1].velocity_y = 7; },
      [](RunReply& run) { run.trajectory.bodies[1].z = 7; },
      [](RunReply& run) { run.trajectory.bodies[1].tilt = 7; },
      [](RunReply& run) { run.trajectory.bodies.clear(); },
      [](RunReply& run) { run.trajectory.contacts->elastic[1] = 7; },
      [](RunReply& run) { run.trajectory.contacts->complementarity = 7; },
      [](RunReply& run) { run.trajectory.contacts->friction_excess = 7; },
      [](RunReply& run) { run.trajectory.contacts->stiffness = 7; },
      [](RunReply& run) { run.trajectory.contacts->damping = 7; },
      [](RunReply& run) { run.trajectory.contacts->impacts.clear(); },
      [](RunReply& run) { run.trajectory.contacts->impacts[0].time = 7; },
      [](RunReply& run) { run.trajectory.contacts->impacts[0].interface = 7; },
      [](RunReply& run) { run.trajectory.contacts->impacts[0].speed = 7; },
      [](RunReply& run) { run.trajectory.contacts->impacts[0].after = 7; },
      [](RunReply& run) { run.trajectory.contacts.reset(); },
      [](RunReply& run) { run.trajectory.reactions[1].normal = 7; },
      [](RunReply& run) { run.trajectory.reactions[1].tangential = 7; },
      [](RunReply& run) { run.trajectory.reactions[1].centre = 7; },
      [](RunReply& run) { run.trajectory.reactions.clear(); }};
  std::set<std::string> messages{to_bytes(full_reply(), GetParam())};
  for (const auto& change : changes) {
    Reply changed = full_reply();
    change(*changed.run);
    messages.insert(again(changed, GetParam()));
  }
  EXPECT_EQ(messages.size(), changes.size() + 1);
}

TEST_P(Messages, HaveWholeParametersAsWholeNumbers) {
  Request request = full_request();
  request.run->parameters = {{"sweeps", 400}, {"margin", 1}, {"large", 1e300}};
  request.run->whole = {"sweeps", "large"};
  const Message message = read_message(to_bytes(request, GetParam()));
  const nlohmann::json& parameters = message.fields["run"]["parameters"];
  EXPECT_TRUE(parameters["sweeps"].is_number_integer());
  EXPECT_TRUE(parameters["margin"].is_number_float());
  EXPECT_EQ(read_request(message).run->parameters, request.run->parameters);
}

INSTANTIATE_TEST_SUITE_P(Forms, Messages, testing::Values(Form::json, Form::messagepack),
                         [](const auto& form) { return form.param == Form::json ? "json" : "messagepack"; });

TEST(MessageBytes, EveryShorterMessageIsRefused) {
  for (const Form form : {Form::json, Form::messagepack}) {
    const std::string bytes = to_bytes(full_request(), form);
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_THROW(read_message(std::string_view(bytes).substr(0, size)), std::runtime_error) << size;
  }
}

TEST(MessageBytes, DamagedOnesAreReadOrRefusedAndNothingElse) {
  std::mt19937_64 random(1983);
  int refused = 0;
  const auto read = [&](const auto& reader, const std::string& bytes) {
    try {
      reader(read_message(mutated(bytes, random)));
    } catch (const std::runtime_error&) {
      ++refused;
    }
  };
  constexpr int rounds = 1000;
  for (int round = 0; round < rounds; ++round) {
    for (const Form form : {Form::json, Form::messagepack}) {
      ASSERT_NO_THROW(read(read_request, to_bytes(full_request(), form)));
      ASSERT_NO_THROW(read(read_reply, to_bytes(full_reply(), form)));
      ASSERT_NO_THROW(read(read_reply, to_bytes(full_description(), form)));
    }
  }
  EXPECT_GT(refused, rounds) << "mutations must do harm";
}

TEST(MessageBytes, WhateverIsNoneIsRefused) {
  for (const std::string& bytes :
       {std::string(), std::string(64, 'x'), std::string("{}"), std::string(R"({"rockstack": 2})"),
        std::string(R"({"rockstack": "1"})"), std::string(R"({"rockstack": 1} {})"),
        std::string(1 << 20, '['), "{\"a\":" + std::string(1 << 20, '['), std::string(1 << 20, '\x91'),
        std::string("\xdd\xff\xff\xff\xff"), std::string("\xc6\xff\xff\xff\xff")}) {
    EXPECT_THROW(read_message(bytes), std::runtime_error) << bytes.substr(0, 40);
  }
}

/// What is said of bytes that are no reply.
std::string complaint(const std::string& bytes) {
  try {
    read_reply(read_message(bytes));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

std::string complaint(const Message& message) {
  return complaint(message.fields.dump());
}

TEST(MessageBytes, WhyTheyCannotBeReadIsSaid) {
  EXPECT_EQ(complaint(R"({"rockstack": 1, "run": {)"), "the message is cut short, after 25 bytes");
  for (const std::string bare : {"NaN", "Infinity"})
    EXPECT_EQ(
        complaint("{\"rockstack\": 1, \"a\": [0, -" + bare + "]}"),
        "the message has a bare " + bare + " at byte 28; must be a text there, \"nan\", \"inf\" or \"-inf\"");
  EXPECT_EQ(complaint(R"({"rockstack": 1, 'run': 2})"), "the message is no JSON from byte 18 on");
  EXPECT_EQ(complaint("words"), "the message is no JSON, which begins with '{', and no MessagePack");
  EXPECT_EQ(complaint("{\"a\":" + std::string(40, '[')), "the message has more than 32 levels");
}

TEST_P(Messages, LongQuestionEndsWhereItIsCancelled) {
  RunRequest run = *full_request().run;
  int asked = 0;
  const std::function<bool()> cancelled = [&] { return ++asked > 0; };
  EXPECT_EQ(to_bytes(run, GetParam(), &cancelled), to_bytes(Request{run}, GetParam()));
  EXPECT_EQ(asked, 0);
  run.setup.accelerations.resize(1'000'000);
  EXPECT_THROW(to_bytes(run, GetParam(), &cancelled), Stopped);
  EXPECT_EQ(asked, 1);
}

TEST(MessageBytes, FieldThatIsWrongIsNamedWithTheObjectsThatHaveIt) {
  const Message whole = read_message(to_bytes(full_reply(), Form::json));
  Message message = whole;
  message.fields["run"]["angles"] = "many";
  EXPECT_EQ(complaint(message), "`angles` must be a list of numbers");
  message = whole;
  message.fields["run"]["angles"] = {{0.1}, {0.2}};
  EXPECT_EQ(complaint(message), "each of `angles` must be a number, \"inf\", \"-inf\" or \"nan\"");
  message = whole;
  message.fields["run"]["contacts"].erase("elastic");
  EXPECT_EQ(complaint(message), "`contacts.elastic` must be there");
  message = whole;
  message.fields["run"]["bodies"].erase("y");
  EXPECT_EQ(complaint(message), "`bodies.y` must be there");
  message = read_message(to_bytes(full_description(), Form::json));
  message.fields["engines"][1]["settings"][0]["least"] = "few";
  EXPECT_EQ(complaint(message),
            "`engines.2.settings.1.least` must be a number, \"inf\", \"-inf\" or \"nan\"");
}

}  // namespace
}  // namespace rockstack
