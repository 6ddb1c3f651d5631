#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analytic/scene/input/document.hpp"

namespace rockstack {

/// Reads a TOML file into a tree whose places are "file:line".
/// @throws InputError: no such file, not a file, not readable, or not TOML (with the line).
Node read_toml(const std::filesystem::path& file);

/// Reads one TOML value ("3", "[1, 2]", "\"text\"") into a copy of `target`, keeping its name, key and place;
/// nothing where the text is not TOML.
std::optional<Node> parse_toml_value(const std::string& text, const Node& target);

}  // namespace rockstack
