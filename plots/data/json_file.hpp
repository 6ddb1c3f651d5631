#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analytic/scene/input/json_reader.hpp"
#include "plots/data/facts.hpp"

namespace rockstack::plots {

using Json = nlohmann::ordered_json;

/// A text that names a file or folder of results: never a path to elsewhere. @throws InputError naming
/// `place`.
std::string file_name(const std::string& text, const std::string& place);

/// Everything that an object says, nested names joined by dots.
Facts facts_of(const Json& object);

}  // namespace rockstack::plots
