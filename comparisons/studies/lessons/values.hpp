#pragma once

#include <map>
#include <string>
#include <vector>

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
};

/// What a lesson's text leaves open: numbers in words ready to be read, and tables, each by its name.
struct LessonValues {
  std::map<std::string, std::string> numbers;
  std::map<std::string, Table> tables;
  PlayerStart player = {};
  std::map<std::string, double> measured = {};  ///< of engines and histories, that predictions ask for
};

// The values of each lesson, computed with the exact solver and the engines. What a function is given is its
// own suite, run.

LessonValues housner_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues projection_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues separation_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues still_base_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues soft_contacts_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues steps_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues chatter_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues sensitivity_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues limits_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues friction_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues lift_off_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues contact_models_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues experiment_values(const Suite& suite, const std::vector<RunMetrics>& rows);
LessonValues reading_values(const Suite& suite, const std::vector<RunMetrics>& rows);

}  // namespace rockstack
