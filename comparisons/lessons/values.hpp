#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/results/csv.hpp"
#include "comparisons/results/run_metrics.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// What a lesson's text leaves open: numbers in words ready to be read, and tables, each by its name.
struct LessonValues {
  std::map<std::string, std::string> numbers;
  std::map<std::string, Table> tables;
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

}  // namespace rockstack
