#pragma once

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {

/// The levels of tables, objects and arrays that an input may have: more than anything here writes, and few
/// enough for what goes down level by level. Keys have as many parts.
inline constexpr int most_levels = 32;

/// One value of a scene file together with the place it was written at; tables and arrays hold their entries
/// as children, those of an array are named "1", "2", ….
struct Node {
  enum class Kind { number, text, other, array, table };  ///< other: a truth value, a date or a time

  Kind kind = Kind::table;
  std::string name = {};   ///< last part of the key, empty for the whole file
  std::string key = {};    ///< from the top of the file, e.g. "blocks.1.width"
  std::string place = {};  ///< "scene.toml:12", or the override that gave the value
  double number = 0;       ///< of a number
  std::string text = {};   ///< of a text, or another value as written
  std::vector<Node> children = {};
};

/// An empty table under `parent`, not yet attached to it.
Node make_child(const Node& parent, std::string name, std::string place);

/// The child of that name, or nullptr.
const Node* find(const Node& parent, std::string_view name);
Node* find(Node& parent, std::string_view name);

/// The node of a dotted key, or the last one on the way to it that exists.
const Node& nearest(const Node& root, std::string_view key);

/// Text in quotes, as one_line().
std::string quoted(std::string_view text);

/// Text as TOML writes it, on one line, such that reading gives the same text.
std::string toml_text(std::string_view text);

/// The error "place: key = value: must be …".
InputError wrong_value(const Node& node, const std::string& allowed);

/// The error "place of the table: key: missing, must be …".
InputError missing_key(const Node& table, std::string_view name, const std::string& allowed);

/// The error for a key that may not stand beside another: names both places.
InputError excluded_key(const Node& node, const Node& other);

}  // namespace rockstack
