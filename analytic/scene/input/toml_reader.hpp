#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analytic/scene/input/document.hpp"

namespace rockstack {

/// Reads a TOML file into a tree whose places are "file:line".
/// @throws InputError: as file_text(), or not TOML (with the line), or nested too deep for any scene.
Node read_toml(const std::filesystem::path& file);

/// Reads one TOML value ("3", "[1, 2]", "\"text\"") into a copy of `target`, keeping its name, key and place;
/// nothing where the text is not TOML. @throws InputError where it is nested too deep.
std::optional<Node> parse_toml_value(const std::string& text, const Node& target);

}  // namespace rockstack
