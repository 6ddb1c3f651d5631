#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/studies/lessons/course/course.hpp"

namespace rockstack {

/// A part with its answer.
struct AnsweredPart {
  Part part;          ///< with its places filled in, those of `why` apart
  double value = 0;   ///< in the part's unit
  std::string shown;  ///< the choice that holds, or the number with its unit
};

/// A question with its numbers filled in and its answers computed.
struct Answered {
  std::string name, text;
  std::vector<AnsweredPart> parts;
};

/// Solves a question whose numbers are given. @throws InputError as read_scene() and quantity().
Answered answered(const Problem& problem, const std::map<std::string, double>& numbers);

/// As {"name", "text", "parts": [{"ask", "choices", "right", "unit", "within", "value", "shown", "why"}]};
/// `right` counts choices from 0, and stands only beside some.
nlohmann::ordered_json to_json(const Answered& question);

/// A lesson's problems with numbers of a student's own. The same seed gives the same sheet.
/// @throws InputError as answered().
std::vector<Answered> drawn_problems(const std::string& lesson, std::uint64_t seed);

/// A sheet with its answers: {"lesson", "title", "seed", "problems"}, as `rockstack plot` reads it.
nlohmann::ordered_json sheet_json(const std::string& lesson, const std::string& title, std::uint64_t seed);

}  // namespace rockstack
