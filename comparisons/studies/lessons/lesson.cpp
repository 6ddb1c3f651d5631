#include "comparisons/studies/lessons/lesson.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {

const std::vector<Lesson>& lessons() {
  static const std::vector<Lesson> list{
      {"housner", housner_values},
      {"projection", projection_values},
      {"separation", separation_values},
      {"still-base", still_base_values},
      {"soft-contacts", soft_contacts_values},
      {"steps", steps_values},
      {"chatter", chatter_values},
      {"sensitivity", sensitivity_values},
      {"limits", limits_values},
      {"friction", friction_values},
      {"lift-off", lift_off_values},
      {"contact-models", contact_models_values},
      {"experiment", experiment_values},
      {"reading", reading_values},
  };
  return list;
}

std::string title(const Lesson& lesson) {
  return read_suite(shipped("studies/lessons") / (lesson.name + ".toml"), {}).title;
}

const Lesson& find_lesson(const std::string& name) {
  std::vector<std::string> names;
  for (const Lesson& lesson : lessons()) {
    if (lesson.name == name) return lesson;
    names.push_back(lesson.name);
  }
  throw InputError(
      fmt::format("teach {}: must be one of {}{}", name, fmt::join(names, ", "), did_you_mean(name, names)));
}

}  // namespace rockstack
