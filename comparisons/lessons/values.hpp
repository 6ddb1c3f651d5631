#pragma once

#include "comparisons/lessons/lesson.hpp"

namespace rockstack {

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
