#include "analytic/scene/input/document.hpp"

#include <algorithm>
#include <utility>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {
namespace {

std::string joined(const std::string& parent, std::string_view name) {
  return parent.empty() ? std::string(name) : parent + "." + std::string(name);
}

/// The value as an error shows it; a table or an array is named, not listed.
std::string shown(const Node& node) {
  if (node.kind == Node::Kind::number) return number_text(node.number);
  if (node.kind == Node::Kind::text) return rockstack::quoted(node.text);
  if (node.kind == Node::Kind::other) return node.text;
  return node.kind == Node::Kind::table ? "a table" : "an array of " + std::to_string(node.children.size());
}

}  // namespace

Node make_child(const Node& parent, std::string name, std::string place) {
  Node child;
  child.key = joined(parent.key, name);
  child.name = std::move(name);
  child.place = std::move(place);
  return child;
}

const Node* find(const Node& parent, std::string_view name) {
  const auto found = std::ranges::find(parent.children, name, &Node::name);
  return found == parent.children.end() ? nullptr : &*found;
}

Node* find(Node& parent, std::string_view name) {
  return const_cast<Node*>(find(std::as_const(parent), name));  // the node itself is not const
}

const Node& nearest(const Node& root, std::string_view key) {
  const Node* node = &root;
  while (!key.empty()) {
    const auto dot = std::min(key.find('.'), key.size());
    const Node* next = find(*node, key.substr(0, dot));
    if (next == nullptr) break;
    node = next;
    key.remove_prefix(std::min(dot + 1, key.size()));
  }
  return *node;
}

std::string quoted(std::string_view text) {
  return '"' + one_line(text) + '"';
}

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') result += '\\';
    const bool control = (letter >= 0 && letter < 0x20) || letter == 0x7f;
    result += control ? "\\u00" + hex_digits(letter) : std::string(1, letter);
  }
  return result + '"';
}

InputError wrong_value(const Node& node, const std::string& allowed) {
  const std::string subject = node.key.empty() ? "the scene" : one_line(node.key);
  return InputError(node.place + ": " + subject + " = " + shown(node) + ": must be " + allowed);
}

InputError missing_key(const Node& table, std::string_view name, const std::string& allowed) {
  return InputError(table.place + ": " + joined(table.key, name) + ": missing, must be " + allowed);
}

InputError excluded_key(const Node& node, const Node& other) {
  return wrong_value(node, "left out where " + other.name + " is given (" + other.place + ")");
}

}  // namespace rockstack
