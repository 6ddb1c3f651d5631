#include "analytic/scene/input/block_lists.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include "analytic/scene/input/scene_keys.hpp"

namespace rockstack {
namespace {

/// A key of a scene that may be a list with a number for each block; null where it is none.
const InputKey* key_of_blocks(std::string_view name) {
  for (const KeyTable* table : scene_tables) {
    const std::string_view home = trimmed(table->header, "[]");
    for (const InputKey& key : table->keys)
      if (name == (home.empty() ? "" : std::string(home) + ".") + key.name)
        return std::string_view(key.range).find("for each block") != std::string_view::npos ? &key : nullptr;
  }
  return nullptr;
}

/// The number that stands for all blocks where a scene says no other; NaN where none does.
double standard_entry(const InputKey& key) {
  std::string_view default_value = key.default_value;
  if (default_value.starts_with("all ")) default_value.remove_prefix(4);
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(default_value.data(), default_value.data() + default_value.size(), value);
  return value;
}

}  // namespace

void list_blocks(const Node& root, Node& node, const std::string& place) {
  const InputKey* key = key_of_blocks(node.key);
  const Node* blocks = find(root, "blocks");
  const bool is_new = node.kind == Node::Kind::table && node.children.empty();
  if (key == nullptr || blocks == nullptr || (!is_new && node.kind != Node::Kind::number)) return;
  const double value = is_new ? standard_entry(*key) : node.number;
  node.kind = Node::Kind::array;
  for (std::size_t k = 1; k <= blocks->children.size(); ++k) {
    Node& entry = node.children.emplace_back(make_child(node, std::to_string(k), place));
    entry.kind = std::isnan(value) ? Node::Kind::other : Node::Kind::number;
    entry.number = value;
    if (std::isnan(value)) entry.text = "missing";
  }
}

}  // namespace rockstack
