#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/studies/lessons/course/answered.hpp"

namespace rockstack {

/// A lesson's problems with numbers of a student's own. The same seed gives the same sheet.
/// @throws InputError as answered().
std::vector<Answered> drawn_problems(const std::string& lesson, std::uint64_t seed);

/// A sheet with its answers: {"lesson", "title", "seed", "problems"}, as `rockstack plot` reads it.
nlohmann::ordered_json sheet_json(const std::string& lesson, const std::string& title, std::uint64_t seed);

}  // namespace rockstack
