#include "comparisons/measures/results/tables.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "analytic/solve.hpp"

namespace rockstack {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

double number(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST(Results, NumbersReadBackToTheSameDouble) {
  Scene scene;
  scene.duration = 1;
  scene.blocks = {make_block(0.3, 1.7, 1234.5)};
  scene.initial = {{0.1}, {0}};
  const History history = solve(scene, {.sample_times = regular_times(0.01, 1)});
  const auto lines = split(history_csv(history), '\n');
  ASSERT_EQ(lines.size(), history.size() + 1);
  EXPECT_EQ(lines[0], "time,theta_1,omega_1,pattern");
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto cells = split(lines[i + 1], ',');
    EXPECT_EQ(number(cells[0]), history.times[i]);
    EXPECT_EQ(number(cells[1]), history.angles[i]);
    EXPECT_EQ(number(cells[2]), history.velocities[i]);
    EXPECT_EQ(cells[3], name(history.patterns[i]));
  }
  EXPECT_EQ(split(events_csv(history), '\n').size(), history.events.size() + 1);
}

TEST(Results, GroundMotionHoldsEverySampleAndEveryMillisecondOfAPulse) {
  Scene scene;
  scene.duration = 0.25;
  scene.horizontal = {0.1, {0, 2, -1, 3}, {}, {}};  // to 0.3 s, past the end
  scene.vertical.pulse = Pulse{.shape = PulseShape::sine, .amplitude = 1, .period = 0.02, .start = 0.01};
  const auto lines = split(ground_csv(scene), '\n');
  EXPECT_EQ(lines[0], "time,horizontal,vertical");
  // 0, 30 milliseconds up to the pulse's end, two samples and the end.
  ASSERT_EQ(lines.size(), 1u + 1 + 30 + 2 + 1);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto cells = split(lines[i], ',');
    const double time = number(cells[0]);
    EXPECT_EQ(number(cells[1]), acceleration(scene.horizontal, time)) << time;
    EXPECT_EQ(number(cells[2]), acceleration(scene.vertical, time)) << time;
  }
  EXPECT_EQ(number(split(lines.back(), ',')[0]), scene.duration);
}

// Lines between what is written go where the ground does: a rectangle has an edge, at any time.
TEST(Results, GroundMotionJumpsWhereAPulseDoes) {
  Scene scene;
  scene.duration = 1;
  scene.vertical.pulse =
      Pulse{.shape = PulseShape::rectangle, .amplitude = -3, .period = 0.1002, .start = 0.2501};
  const auto lines = split(ground_csv(scene), '\n');
  double impulse = 0;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const auto last = split(lines[i - 1], ',');
    const auto next = split(lines[i], ',');
    EXPECT_LT(number(last[0]), number(next[0]));
    impulse += (number(next[0]) - number(last[0])) * (number(next[2]) + number(last[2])) / 2;
  }
  EXPECT_NEAR(impulse, -3 * 0.1002, 1e-12);
}

TEST(Results, EveryColumnHasANameOfItsOwnAndADefinition) {
  std::set<std::string> names;
  for (const Column& column : columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_GT(std::string(column.definition).size(), 10u) << column.name;
  }
}

TEST(Results, AFailedRunIsARowWithItsReasonAlone) {
  RunMetrics row;
  row.run = "a.b";
  row.engine = "bullet";
  row.status = RunStatus::failed;
  row.reason = "angle of block 1, and \"more\",\nis not finite";
  const auto lines = split(csv_of(std::vector{row}), '\n');
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NE(lines[1].find("failed,\"angle of block 1, and \"\"more\"\", is not finite\",,"),
            std::string::npos)
      << lines[1];
}

TEST(Results, ImpactTablesSayWhatIsMissingOnEitherSide) {
  const std::string text = impacts_csv({{1, 1, 0.5, 0.75, Contact::left, Contact::closed},
                                        {2, 2, 0.75, {}, Contact::right, {}},
                                        {1, {}, {}, 1.0, {}, Contact::right}});
  EXPECT_EQ(text,
            "number,interface,exact_time,engine_time,difference,verdict,exact_side,engine_side\n"
            "1,1,0.5,0.75,0.25,matched,left,closed\n"
            "2,2,0.75,,,missed,right,\n"
            ",1,,1,,extra,,right\n");
}

TEST(Results, PatternSharesAreALinePerPair) {
  Pattern open = closed_pattern(2);
  open[0] = Contact::right;
  EXPECT_EQ(patterns_csv({{closed_pattern(2), open, 0.25}}),
            "exact,engine,share\nrest," + name(open) + ",0.25\n");
}

TEST(Results, RowsReadBackFromTheirCells) {
  RunMetrics row;
  row.run = "a.b";
  row.dt = 0.1;
  row.impacts_extra = 3;
  row.slip = 1.0 / 3;
  row.toppling_verdict = TopplingVerdict::both;
  const auto read = nlohmann::ordered_json::parse(nlohmann::ordered_json(row).dump()).get<RunMetrics>();
  EXPECT_EQ(csv_of(std::vector{read}), csv_of(std::vector{row}));
  EXPECT_EQ(read.slip, row.slip);
  EXPECT_FALSE(read.gap);
}

}  // namespace
}  // namespace rockstack
