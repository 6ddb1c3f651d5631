#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "plots/data/facts.hpp"

namespace rockstack::plots {

using Json = nlohmann::ordered_json;

/// @throws InputError naming the file that is missing or malformed.
Json read_json(const std::filesystem::path& file);

/// A text that names a file or folder of results: never a path to elsewhere. @throws InputError naming
/// `place`.
std::string file_name(const std::string& text, const std::string& place);

/// Everything that an object says, nested names joined by dots.
Facts facts_of(const Json& object);

}  // namespace rockstack::plots
