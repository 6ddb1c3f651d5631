#pragma once

#include <string>
#include <vector>

namespace rockstack {

// What a lesson's own file, course/NAME.toml, says beyond its text: for whom it is, what is to be predicted
// before it is read, and problems whose numbers are drawn anew for each student. Answers are never in the
// file: they are quantities of an exact solution, or of the numbers of the question.

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
  std::vector<std::string> after;  ///< lessons that come first
  std::vector<std::string> references;
  std::vector<Problem> predictions, problems;
};

/// @throws InputError with file:line, key, value and what is allowed.
CourseEntry read_course(const std::string& lesson);

}  // namespace rockstack
