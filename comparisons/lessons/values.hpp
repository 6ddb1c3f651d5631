#pragma once

#include <map>
#include <string>
#include <vector>

#include "comparisons/results/csv.hpp"
#include "comparisons/results/row.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// What a lesson's text leaves open: numbers in words ready to be read, and tables, each by its name.
struct LessonValues {
  std::map<std::string, std::string> numbers;
  std::map<std::string, Table> tables;
};

// The values of each lesson, computed with the exact solver and the engines. What a function is given is its
// own suite, run.

LessonValues housner_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues projection_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues separation_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues still_base_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues soft_contacts_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues steps_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues chatter_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues sensitivity_values(const Suite& suite, const std::vector<Row>& rows);
LessonValues limits_values(const Suite& suite, const std::vector<Row>& rows);

}  // namespace rockstack
