#pragma once

#include <filesystem>
#include <optional>

#include "analytic/scene/input/document.hpp"

namespace rockstack {

/// Reads a TOML file into a tree whose places are "file:line".
/// @throws InputError: as file_text(), or not TOML (with the line), or nested too deep for any scene.
Node read_toml(const std::filesystem::path& file);

/// Reads the text of such a file, of that name. @throws InputError where it is not TOML or nested too deep.
Node parse_toml(const std::string& text, const std::string& name);

/// Reads one TOML value ("3", "[1, 2]", "\"text\"") into a copy of `target`, keeping its name, key and place;
/// nothing where the text is not TOML. @throws InputError where it is nested too deep.
std::optional<Node> parse_toml_value(const std::string& text, const Node& target);

/// Sets one value of a scene file from a text "key=value". The value is read as TOML; what is not TOML is a
/// text as it stands. Tables that are missing are made; entries of an array are reached by their number from
/// 1, and none can be added. The value's place becomes the override itself, "--set key=value".
/// @throws InputError: not of that form, no such entry, or a key below what is neither table nor array.
void apply_override(Node& root, const std::string& override_text);

/// Sets the value at a dotted key to that of `value`, whose place it takes over. Otherwise as above.
void set_value(Node& root, const std::string& key, const Node& value);

}  // namespace rockstack
