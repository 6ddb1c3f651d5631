#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "analytic/scene/input/json_reader.hpp"

namespace rockstack::plots {

using Json = nlohmann::ordered_json;

/// Names and texts in the order of the file.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A text that names a file or folder of results: never a path to elsewhere. @throws InputError naming
/// `place`.
std::string file_name(const std::string& text, const std::string& place);

/// Everything that an object says, nested names joined by dots.
Facts facts_of(const Json& object);

}  // namespace rockstack::plots
