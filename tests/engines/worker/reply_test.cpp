// A reply is held against what was asked, field by field.

#include "engines/worker/answer_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "engines/trajectory.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

RunRequest asked(bool bodies = true, std::size_t repeats = 2) {
  RunRequest request{"y", {}, {}, repeats, bodies};
  request.setup.blocks = {{.x = 0.5, .y = 1, .velocity_x = 0.1, .velocity_y = -0.2, .angle = 0.1}};
  request.setup.blocks[0].angular_velocity = -0.3;
  request.setup.toppling_angles = {0.8};
  request.setup.dt = 0.5;
  request.setup.steps = 2;
  request.reactions = true;
  return request;
}

json whole() {
  json run{
      {"status", "done"},      {"reason", ""},  {"angles", {0.1, 0.2, 0.3}}, {"velocities", {-0.3, 0.2, 0.1}},
      {"seconds", {0.1, 0.2}}, {"warnings", 1}, {"peak_memory", 1e6}};
  run["bodies"] = {{"x", {0.5, 0.5, 0.5}},       {"y", {1, 1, 1}}, {"velocity_x", {0.1, 0, 0}},
                   {"velocity_y", {-0.2, 0, 0}}, {"z", {0, 0, 0}}, {"tilt", {0, 0, 0}}};
  run["contacts"] = {{"elastic", {0, 1, 0}}, {"complementarity", 1}, {"friction_excess", 0.1},
                     {"stiffness", 1e5},     {"damping", 10},        {"points", 1.5}};
  run["contacts"]["impacts"] =
      json::array({json{{"time", 0.5}, {"interface", 1}, {"speed", 0.3}, {"after", -0.1}}});
  run["reactions"] = {{"normal", {2, 1}}, {"tangential", {1, -1}}, {"centre", {0.1, 0.2}}};
  return run;
}

/// What is said of a reply; nothing where it is taken.
std::string said_of(const json& run, const RunRequest& request = asked()) {
  try {
    const Reply reply = read_reply(read_message(json{{"rockstack", 1}, {"run", run}}.dump()));
    require_answer(*reply.run, request);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Which values a field may have in place of its own; of a list, each number after that of the start.
struct Field {
  std::string path;
  double least = 0, most = largest_number;
  bool whole = false, optional = false, may_be_infinite = false, may_be_none = false;
};

const std::vector<Field>& fields() {
  constexpr double any = largest_number, largest = std::numeric_limits<double>::max();
  static const std::vector<Field> list{
      {"/angles", -0.8, 0.8},
      {"/velocities", -any},
      {"/seconds"},
      {.path = "/warnings", .most = 2, .whole = true, .optional = true},
      {.path = "/peak_memory", .optional = true},
      {"/bodies/x", -any},
      {"/bodies/y", -any},
      {"/bodies/velocity_x", -any},
      {"/bodies/velocity_y", -any},
      {"/bodies/z", -any},
      {"/bodies/tilt", -any},
      {"/contacts/elastic"},
      {"/contacts/complementarity"},
      {"/contacts/friction_excess"},
      {.path = "/contacts/stiffness", .most = largest, .optional = true, .may_be_infinite = true},
      {.path = "/contacts/damping", .most = largest, .optional = true},
      {.path = "/contacts/points", .least = 1, .optional = true},
      {"/contacts/impacts/0/time", 0, 1},
      {.path = "/contacts/impacts/0/interface", .least = 1, .most = 1, .whole = true},
      {"/contacts/impacts/0/speed"},
      {"/contacts/impacts/0/after", -any},
      {"/reactions/normal", -any},
      {"/reactions/tangential", -any},
      {.path = "/reactions/centre", .least = -any, .may_be_none = true}};
  return list;
}

/// The number that a value stands for as a field; not a number where it is none.
double number_of(const json& value) {
  if (value.is_number()) return value.get<double>();
  return value == "inf" ? HUGE_VAL : value == "-inf" ? -HUGE_VAL : std::nan("");
}

bool may_be(const Field& field, const json& value) {
  if (value.is_null()) return field.optional || field.may_be_none;
  if (value == "nan" && field.may_be_none) return true;
  const double number = number_of(value);
  if (std::isinf(number)) return field.may_be_infinite && number > 0;
  return number >= field.least && number <= field.most && (!field.whole || value.is_number_integer());
}

const std::vector<json>& values() {
  static const std::vector<json> list{nullptr,
                                      "nan",
                                      "inf",
                                      "-inf",
                                      "",
                                      "1",
                                      true,
                                      json::array(),
                                      json::object(),
                                      json::array({1}),
                                      0,
                                      1,
                                      2,
                                      3,
                                      -1,
                                      0.5,
                                      1.5,
                                      -0.5,
                                      1e-300,
                                      1e20,
                                      1e21,
                                      -1e21,
                                      1e308,
                                      4294967297,
                                      9223372036854775807,
                                      std::numeric_limits<std::uint64_t>::max()};
  return list;
}

TEST(Reply, WholeIsTaken) {
  EXPECT_EQ(said_of(whole()), "");
}

// Each field with each value: taken where the table has it, else refused with the field's name in one line.
TEST(Reply, EveryFieldIsHeldToItsRange) {
  for (const Field& field : fields()) {
    for (const json& value : values()) {
      json run = whole();
      json& place = run[json::json_pointer(field.path)];
      const bool list = place.is_array();
      (list ? place[1] : place) = value;
      const bool taken = (!(list && value.is_null()) || field.may_be_none) && may_be(field, value);
      const std::string said = said_of(run);
      EXPECT_EQ(said.empty(), taken) << field.path << " = " << value << ": " << said;
      EXPECT_EQ(said, one_line(said));
      // The time is said of a motion's numbers that are none.
      if (taken || said.find("is not finite at t = 0.5 s") != std::string::npos) continue;
      const std::string name = field.path.substr(field.path.rfind('/') + 1);
      EXPECT_NE(said.find(name), std::string::npos) << field.path << " = " << value << ": " << said;
    }
  }
}

TEST(Reply, TableHasEveryFieldButItsWords) {
  const json leaves = whole().flatten();
  for (const auto& [path, value] : leaves.items()) {
    if (value.is_string()) continue;
    const auto has = [&, path = path](const Field& field) {
      return path == field.path || path.starts_with(field.path + "/");
    };
    EXPECT_TRUE(std::any_of(fields().begin(), fields().end(), has)) << path;
  }
}

TEST(Reply, EveryFieldMayBeMissingOnlyWhereThatMeansSomething) {
  for (const Field& field : fields()) {
    json run = whole();
    const json::json_pointer path(field.path);
    run[path.parent_pointer()].erase(path.back());
    EXPECT_EQ(said_of(run).empty(), field.optional || field.path == "/bodies/z") << field.path;
  }
  json run = whole();
  run.erase("contacts");
  EXPECT_EQ(said_of(run), "");
  run.erase("bodies");
  EXPECT_EQ(said_of(run), "`bodies` must be there, they are asked for");
  EXPECT_EQ(said_of(run, asked(false)), "");
  EXPECT_EQ(said_of(whole(), asked(false)), "`bodies` must be left out, they are not asked for");
  run["contacts"] = whole()["contacts"];
  EXPECT_EQ(said_of(run, asked(false)), "`contacts` must be left out, `bodies` are not asked for");
  RunRequest without = asked();
  without.reactions = false;
  EXPECT_EQ(said_of(whole(), without), "`reactions` must be left out, they are not asked for");
}

TEST(Reply, ListsAreAsLongAsTheQuestionAsks) {
  for (const Field& field : fields()) {
    const json::json_pointer path(field.path);
    for (const bool longer : {false, true}) {
      json run = whole();
      if (!run[path].is_array()) continue;
      if (longer)
        run[path].push_back(0);
      else
        run[path].erase(run[path].size() - 1);
      EXPECT_NE(said_of(run), "") << field.path;
    }
  }
  json run = whole();
  EXPECT_EQ(said_of(run, asked(true, 3)), "`seconds` has 2 numbers; must have 3, one for each of `repeats`");
  run["angles"] = json::array();
  EXPECT_EQ(said_of(run),
            "`angles` has 0 numbers; must have 3, 1 in each of 3 samples; fewer samples only where a "
            "block of the last one is beyond its `toppling_angles`");
}

TEST(Reply, EndsWithTheFirstSampleInWhichABlockHasToppled) {
  json run = whole();
  for (const char* later : {"contacts", "reactions"}) run.erase(later);
  for (const char* list : {"/angles", "/velocities", "/bodies/x", "/bodies/y", "/bodies/velocity_x",
                           "/bodies/velocity_y", "/bodies/z", "/bodies/tilt"})
    run[json::json_pointer(list)].erase(2);
  EXPECT_TRUE(said_of(run).starts_with("`angles` has 2 numbers; must have 3"));
  run["angles"][1] = -0.9;
  EXPECT_EQ(said_of(run), "");
  run = whole();
  run["angles"] = {0.1, 0.9, 0.3};
  EXPECT_EQ(said_of(run),
            "`angles` must end with sample 2, in which block 1 is beyond its `toppling_angles`");
  run["angles"] = {0.1, 0.3, 0.9};
  EXPECT_EQ(said_of(run), "");
}

TEST(Reply, BeginsWithTheStartOfTheScene) {
  for (const Field& field : fields()) {
    const bool motion =
        field.path.starts_with("/bodies") || field.path == "/angles" || field.path == "/velocities";
    if (!motion || field.path == "/bodies/z" || field.path == "/bodies/tilt") continue;
    json run = whole();
    json& first = run[json::json_pointer(field.path)][0];
    const double start = first.get<double>();
    first = start * (1 + 1e-6);  // single precision
    EXPECT_EQ(said_of(run), "") << field.path;
    first = start + 0.01;
    EXPECT_TRUE(said_of(run).starts_with("`" + field.path.substr(field.path.rfind('/') + 1)) ||
                said_of(run).starts_with("`bodies." + field.path.substr(field.path.rfind('/') + 1)))
        << said_of(run);
  }
}

TEST(Reply, HasAStatusAndMayHaveFieldsThatNobodyKnows) {
  json run = whole();
  run["colour"] = "red";
  EXPECT_EQ(said_of(run), "");
  run["status"] = "fine";
  EXPECT_EQ(said_of(run), "`status` must be \"done\", \"failed\", \"not finite\" or \"memory limit\"");
  run.erase("status");
  EXPECT_EQ(said_of(run), "`status` must be there");
  EXPECT_EQ(said_of({{"status", "failed"}, {"angles", "none"}}), "");
  EXPECT_EQ(said_of({{"status", "failed"}, {"peak_memory", -1}}),
            "`peak_memory` must be from 0 to 1e+20; -1 is not");
}

}  // namespace
}  // namespace rockstack
