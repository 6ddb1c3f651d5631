// What goes into a message comes out of it, to the last bit.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "engines/worker/request.hpp"

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

TEST(Messages, HistoryComesBackWithItsNumbersThatAreNone) {
  Reply sent;
  sent.run = RunReply{"done", "", {}, 4, {0.1, 0.2}, 1e6, {}};
  sent.run->history.blocks = 1;
  sent.run->history.times = {0, 0.1};
  sent.run->history.angles = {0.2, std::nan("")};
  sent.run->history.velocities = {0, -HUGE_VAL};
  sent.run->bodies = BodyRecord{.energy = {1.5, 2}, .input = {0, 0.5}, .slip = 0.25};
  const Reply read = read_reply(to_bytes(sent));
  ASSERT_TRUE(read.run);
  EXPECT_EQ(to_bytes(read), to_bytes(sent));
  EXPECT_TRUE(std::isnan(read.run->history.angles[1]));
  EXPECT_EQ(read.run->warnings, 4U);
  EXPECT_EQ(read.run->bodies->energy, sent.run->bodies->energy);
  EXPECT_EQ(read.run->bodies->slip, 0.25);
}

TEST(Messages, EveryShorterMessageIsRefused) {
  const std::string bytes = to_bytes(Request{RunRequest{"step", full_scene(), 1e-3, {{"erp", 0.2}}, 3}});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(read_request(std::string_view(bytes).substr(0, size)), std::runtime_error) << size;
  }
}

TEST(Messages, OtherBytesAreRefused) {
  EXPECT_THROW(read_reply(std::string(64, 'x')), std::runtime_error);
}

}  // namespace
}  // namespace rockstack
