#pragma once

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/run_metrics.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// How a lesson's player stands when the page opens: at the moment that the lesson is about.
struct PlayerStart {
  double time = 0;        ///< s
  double speed = 1;       ///< times that of the motion: 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2 or 4
  double gain = 1;        ///< angles are drawn that many times larger, 1 to 100
  bool overlaid = false;  ///< motions over each other, not side by side
  bool chatter = false;   ///< stepping stops at impacts of chatter too
  bool finest = false;    ///< engines are shown at their finest steps
};

/// What a lesson's text leaves open: numbers in words ready to be read, and tables, each by its name.
struct LessonValues {
  std::map<std::string, std::string> numbers;
  std::map<std::string, Table> tables;
  PlayerStart player = {};
  std::map<std::string, double> measured = {};  ///< of engines and histories, that predictions ask for
};

/// Computes the values of one lesson, with the exact solver and engines, from its own suite, run.
using ValuesOf = LessonValues(const Suite& suite, const std::vector<RunMetrics>& rows);

#include "comparisons/studies/lessons/lesson_functions.inc"

/// A lesson: the folder NAME with a suite, suite.toml, a text with places for values and marks for its
/// slides, text.html, its part in a course, course.toml, and what computes the values once the suite has been
/// run, values.cpp.
struct Lesson {
  std::string name;
  ValuesOf* values;
};

/// In the order in which to read them.
const std::vector<Lesson>& lessons();

/// The lesson's title, from its suite. @throws InputError as read_suite().
std::string title(const Lesson& lesson);

/// @throws InputError naming what was asked for and what there is.
const Lesson& find_lesson(const std::string& name);

// What values are made of.

/// An engine's answer to a scene, made in passing. `changes` go on top of the named set of parameters.
/// @throws InputError where this build leaves the engine out, std::runtime_error where the run fails.
History answer(const std::string& engine, const Scene& scene, double dt, const Parameters& changes = {},
               const std::string& settings = "tuned");

/// The exact answer, sampled every `interval` s.
History exact_answer(const Scene& scene, double interval = 1e-3);

/// Root of the mean square of all differences of an answer's angles from the exact motion, rad.
double error_of(const Scene& scene, const History& answer);

/// Errors of an engine as error_of(), a run for each of the suite's draws, of its first scene.
std::vector<double> errors_of_draws(const Suite& suite, const std::string& engine, double dt,
                                    const Parameters& changes = {}, const std::string& settings = "tuned");

/// One of the scenes that come with the program. @throws InputError as read_scene().
Scene read_shipped(const std::string& scene, const std::vector<std::string>& overrides = {});

Scene under(Scene scene, Law law);

Scene lasting(Scene scene, double duration);

/// Weight of all blocks, N.
double weight_of(const Scene& scene);

/// The row of a suite's run with tuned parameters; one where that run is not done has no numbers.
/// @throws std::logic_error where the suite has no such run.
const RunMetrics& find_run(const std::vector<RunMetrics>& rows, const std::string& engine, double dt);

/// Where a function changes its sign between two places, to a rounding, by bisection.
double crossing(double low, double high, const std::function<double(double)>& value);

/// The first event of a kind, or nullptr.
const Event* first_event(const History& history, EventKind kind);

std::vector<Event> impacts_of(const History& history);

/// A number with that many digits after the point, and a true minus sign: "−0.4816".
std::string fixed(double value, int digits);

/// A number as digits times a power of ten, "3.1 × 10⁻⁵"; 0 as "0".
std::string power(double value, int digits);

/// A share as per cent, "29.5 %".
std::string percent(double share, int digits);

/// A cell of a table: a number with all its digits; 0 where it is rounding beside `scale`.
std::string cell(double value, double scale = 0);

}  // namespace rockstack
