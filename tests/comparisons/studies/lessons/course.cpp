#include "comparisons/studies/lessons/course/course.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/lessons/course/course.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

std::string text_of_lesson(const std::string& name) {
  std::ifstream in(std::filesystem::path(ROCKSTACK_LESSONS) / name / "text.html");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

TEST(Course, EachLessonComesAfterThoseThatItNeeds) {
  std::set<std::string> before;
  for (const Lesson& lesson : lessons()) {
    const CourseEntry entry = read_course(lesson.name);
    EXPECT_FALSE(entry.aims.empty() || entry.references.empty()) << lesson.name;
    for (const std::string& name : entry.after) EXPECT_TRUE(before.contains(name)) << lesson.name << name;
    before.insert(lesson.name);
  }
}

TEST(Course, ItsIndexHasEveryLesson) {
  const auto list = nlohmann::json::parse(course_json()).at("lessons");
  ASSERT_EQ(list.size(), lessons().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i]["name"], lessons()[i].name);
    EXPECT_EQ(list[i]["number"], i + 1);
  }
}

TEST(Course, EachPredictionStandsOnceInItsText) {
  for (const Lesson& lesson : lessons()) {
    const CourseEntry entry = read_course(lesson.name);
    const std::string text = text_of_lesson(lesson.name);
    EXPECT_EQ(occurrences(text, "{{predict:"), entry.predictions.size()) << lesson.name;
    EXPECT_GE(entry.predictions.size(), 1U) << lesson.name;
    for (const Problem& problem : entry.predictions) {
      EXPECT_EQ(occurrences(text, "{{predict:" + problem.name + "}}"), 1U) << lesson.name << problem.name;
      EXPECT_EQ(problem.parts.size(), 1U);
    }
  }
}

/// What the sliders of a text ask, each a <div class="try">.
std::vector<std::string> sliders_of(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t at = text.find("<div class=\"try\""); at != std::string::npos;
       at = text.find("<div class=\"try\"", at + 1))
    list.push_back(text.substr(at, text.find("</div>", at) - at));
  return list;
}

TEST(Course, EverySliderHasAnAnswerThatIsComputed) {
  for (const Lesson& lesson : lessons())
    for (const std::string& slider : sliders_of(text_of_lesson(lesson.name))) {
      const std::size_t answer = slider.find("<details class=\"question\"><summary>Answer</summary>");
      ASSERT_NE(answer, std::string::npos) << lesson.name << slider;
      EXPECT_NE(slider.find("{{", answer), std::string::npos) << lesson.name << ": of a number of its own";
    }
}

// Typed are sizes of what is set up, by a few digits; results come from values, with theirs.
TEST(Course, NumbersThatAreResultsAreNotTyped) {
  const std::regex beside("<(pre|math|svg|label|code)[\\s\\S]*?</\\1>|<[^>]*>|\\{\\{[^}]*\\}\\}"),
      result("\\d\\.\\d{3}");
  for (const Lesson& lesson : lessons()) {
    const std::string words = std::regex_replace(text_of_lesson(lesson.name), beside, " ");
    std::smatch found;
    EXPECT_FALSE(std::regex_search(words, found, result))
        << lesson.name << ": " << found.str() << found.suffix();
  }
}

TEST(Course, LessonsThatCompareStepsHaveReplicates) {
  for (const char* name : {"steps", "reading"}) {
    const std::filesystem::path folder = std::filesystem::path(ROCKSTACK_LESSONS) / name;
    EXPECT_GE(read_suite(folder / "suite.toml", {}).replicates.runs, 7) << name;
    EXPECT_NE(text_of_lesson(name).find("{{draws}} replicates"), std::string::npos) << name;
  }
}

TEST(Course, TheChoiceOfALawReachesAllLawsAndBothRestitutions) {
  const std::string text = text_of_lesson("contact-models");
  for (const char* end :
       {"<code>paper</code>", "<code>consistent</code>", "<code>unilateral</code>", "<code>compliant</code>",
        "<code>restitution</code>", "<code>contact.restitution</code>"})
    EXPECT_NE(text.find(end), std::string::npos) << end;
}

TEST(Course, EveryQuantityIsAskedForSomewhere) {
  std::set<std::string> asked;
  for (const Lesson& lesson : lessons()) {
    const CourseEntry entry = read_course(lesson.name);
    for (const auto* problems : {&entry.predictions, &entry.problems})
      for (const Problem& problem : *problems)
        for (const Part& part : problem.parts) asked.insert(part.answer);
  }
  for (const std::string& name : quantity_names()) EXPECT_TRUE(asked.contains(name)) << name;
}

TEST(Quantities, ANameThatIsNoneIsRefused) {
  EXPECT_THROW(quantity("mood", {}), InputError);
  EXPECT_THROW(quantity("chance-apart", {}), InputError) << "the numbers that it is of are missing";
  EXPECT_THROW(quantity("opening", asked_about("housner-block", {"duration=0.1"})), std::runtime_error);
}

TEST(Sheets, TheSameSeedGivesTheSameSheetAndAnotherSeedAnother) {
  std::set<std::string> texts;
  for (const std::uint64_t seed : {1U, 2U, 3U, 1U}) texts.insert(sheet_json("housner", "", seed).dump());
  EXPECT_EQ(texts.size(), 3U);
}

// Any seed may come: numbers are drawn from few values each, of which no combination may be without answer.
TEST(Sheets, EveryProblemHasFiniteAnswers) {
  for (const Lesson& lesson : lessons())
    for (const std::uint64_t seed : {0U, 7U}) {
      const Json sheet = sheet_json(lesson.name, "", seed);
      for (const Json& problem : sheet["problems"])
        for (const Json& part : problem["parts"])
          EXPECT_TRUE(std::isfinite(part["value"].get<double>()))
              << lesson.name << ' ' << seed << ' ' << part["ask"];
    }
}

/// The first problem of a lesson with these numbers; its answers.
std::vector<double> answers_of(const std::string& lesson, const std::map<std::string, double>& numbers) {
  std::vector<double> values;
  const Json question = answered(read_course(lesson).problems.front(), numbers);
  for (const Json& part : question["parts"]) values.push_back(part["value"]);
  return values;
}

// What a student would find with pen and paper.
TEST(Sheets, TheKeyOfABlockIsHousners) {
  const double width = 0.4, height = 2.2, alpha = std::atan(width / height);
  const std::vector<double> key =
      answers_of("housner", {{"width", width}, {"height", height}, {"angle", 0.05}});
  const double ratio = 1 - 1.5 * std::sin(alpha) * std::sin(alpha);
  constexpr double rounding = 1e-11;
  EXPECT_NEAR(key.at(0), alpha, rounding);
  EXPECT_NEAR(key.at(2), ratio, rounding);
  EXPECT_NEAR(key.at(3), 1 - ratio * ratio, rounding);
  // θ̈ = p² sin(θ − α): the block taken for slender is pulled by less than a share (α − θ)²/6 too much.
  const double p = std::sqrt(3 * 9.81 / (2 * std::hypot(width, height)));
  const double slender = std::acosh(1 / (1 - 0.05 / alpha)) / p;
  EXPECT_NEAR(key.at(1), slender, slender * alpha * alpha / 6);
}

TEST(Sheets, TheKeyOfAThrowIsTheParabola) {
  const Throw thrown = thrown_by_sine(20, 0.4, 9.81);
  const std::vector<double> key = answers_of("lift-off", {{"amplitude", 20}});
  constexpr double rounding = 1e-9;
  EXPECT_NEAR(key.at(0), thrown.lift_off, rounding);
  EXPECT_NEAR(key.at(1), thrown.landing - thrown.lift_off, rounding);
}

TEST(Sheets, TheKeyOfDrawsIsTheTestItself) {
  const std::vector<double> key = answers_of("reading", {{"draws", 5}, {"level", 0.05}});
  EXPECT_NEAR(key.at(0), mann_whitney({1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}).p_value, 1e-12);
  EXPECT_EQ(key.at(1), 6);  // 0.05 · 252/2 = 6.3
}

TEST(Answered, AChoiceIsTheIntervalInWhichTheAnswerLies) {
  Problem problem;
  problem.parts = {{.ask = "{{x}}?", .answer = "x", .choices = {"low", "middle", "high"}, .bounds = {1, 2}}};
  const auto shown = [&](double x) {
    return answered(problem, {{"x", x}})["parts"][0]["shown"].get<std::string>();
  };
  EXPECT_EQ(shown(0.5), "low");
  EXPECT_EQ(shown(1), "low") << "up to its bound";
  EXPECT_EQ(shown(1.5), "middle");
  EXPECT_EQ(shown(9), "high");
  EXPECT_EQ(answered(problem, {{"x", 1.5}})["parts"][0]["right"], 1);
}

}  // namespace
}  // namespace rockstack
