#pragma once

#include "comparisons/runs/compare.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {

// What a lesson's course.toml says beyond its text: for whom it is, what is to be predicted before it is
// read, and problems whose numbers are drawn anew for each student. Answers are never in the file: they are
// quantities of an exact solution, or of the numbers of the question.

/// One thing that is asked, and what is said once it is answered.
struct Part {
  std::string ask;
  std::string answer;                     ///< the name of a quantity, see quantity_names()
  std::vector<std::string> choices = {};  ///< none: a number is asked for
  std::vector<double> bounds = {};        ///< ascending, between the choices: each holds up to its bound
  std::string unit = {};
  int digits = 3;        ///< after the point, of the answer as it is shown
  double within = 0.05;  ///< share of the answer by which a number may be off
  std::string why = {};  ///< with places for {{answer}} and, in a lesson, for its numbers
};

/// Values that a number of a problem may have: least, least + step, … up to most.
struct DrawnRange {
  std::string name;
  double least = 0, most = 0, step = 0;
};

/// A question with its scene. Places {{name}} in texts and overrides stand for the numbers drawn.
struct Problem {
  std::string name;  ///< of a prediction: where it stands in the text, {{predict:NAME}}; of a problem: empty
  std::string text;
  std::string scene;                 ///< shipped; empty: the numbers alone are asked about
  std::vector<std::string> changes;  ///< overrides of the scene
  std::vector<std::string> against;  ///< other overrides, that of the answer's divisor; empty: 1
  std::vector<DrawnRange> draw;
  std::vector<Part> parts;
};

/// A lesson as part of a course.
struct CourseEntry {
  std::vector<std::string> aims;
  int minutes = 0;                 ///< in class
  std::string pattern;             ///< that it is about, whose picture its entry has
  std::vector<std::string> after;  ///< lessons that come first
  std::vector<std::string> references;
  std::vector<Problem> predictions, problems;
};

/// @throws InputError with file:line, key, value and what is allowed.
CourseEntry read_course(const std::string& lesson);

/// What a question is about: a scene with its exact solution, where it has one, and numbers by name.
struct Asked {
  Scene scene;
  History history;
  std::map<std::string, double> numbers;

  /// @throws InputError for a number that is not there.
  double operator[](const std::string& name) const;
};

/// Solves a shipped scene with changes, with all that quantities need.
Asked asked_about(const std::string& scene, const std::vector<std::string>& changes);

/// A quantity by its name, as questions of lessons have them; the name of a number is that number.
/// @throws InputError for a name that is none, std::runtime_error where what is asked about never happens.
double quantity(const std::string& name, const Asked& asked);

/// All names besides those of numbers.
std::vector<std::string> quantity_names();

/// Solves a question whose numbers are given: {"name", "text", "parts": [{"ask", "choices", "unit", "within",
/// "value", "shown", "why", "right"}]}. Places are filled in, those of `why` apart; `value` is in the part's
/// unit, `shown` the choice that holds or the number with its unit; `right` counts choices from 0, and stands
/// only beside some. @throws InputError as read_scene() and quantity().
Json answered(const Problem& problem, const std::map<std::string, double>& numbers);

/// A lesson's problems with numbers of a student's own, and their answers: {"lesson", "title", "seed",
/// "problems"}, as `rockstack plot` reads it. The same seed gives the same sheet.
/// @throws InputError as answered().
Json sheet_json(const std::string& lesson, const std::string& title, std::uint64_t seed);

/// Runs a lesson's suite as compare() does, and writes FOLDER/lesson.json: text, numbers, tables, and what is
/// to be predicted with its answers. `in_course`: the folders of its neighbours lie beside it.
std::vector<RunMetrics> run_lesson(const Lesson& lesson, const std::filesystem::path& folder, bool in_course,
                                   const CompareOptions& options);

/// All lessons in their order, each with aims, minutes and those that come first, as JSON.
/// @throws InputError as read_course().
std::string course_json();

}  // namespace rockstack
