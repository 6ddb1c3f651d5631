#include "analytic/scene/input/overrides.hpp"

#include <algorithm>
#include <utility>

#include "analytic/scene/input/toml_reader.hpp"

namespace rockstack {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The parts of a dotted key; an empty part stays, for the caller to refuse.
std::vector<std::string> parts(const std::string& key) {
  std::vector<std::string> result(1);
  for (const char letter : key) {
    if (letter == '.') {
      result.emplace_back();
    } else {
      result.back() += letter;
    }
  }
  return result;
}

std::string count(std::size_t number, const std::string& name) {
  const bool one = number == 1;
  const std::string noun = name == "blocks" ? (one ? "block" : "blocks") : (one ? "entry" : "entries");
  return (one ? "there is " : "there are ") + std::to_string(number) + " " + noun;
}

Node& entry(Node& array, const std::string& name, const std::string& place) {
  if (Node* found = find(array, name)) return *found;
  const auto size = array.children.size();
  throw InputError(place + ": " + array.key + "." + one_line(name) + ": " + count(size, array.name) +
                   (size == 0 ? "" : ", must be 1 to " + std::to_string(size)));
}

Node& child(Node& parent, const std::string& name, const std::string& place) {
  if (parent.kind == Node::Kind::array) return entry(parent, name, place);
  if (parent.kind != Node::Kind::table) {
    Node here = parent;
    here.place = place;
    throw wrong_value(here, "a table or an array to hold " + parent.key + "." + one_line(name));
  }
  if (Node* found = find(parent, name)) return *found;
  return parent.children.emplace_back(make_child(parent, name, place));
}

/// The node of a dotted key, made where it is missing, under the place given.
Node& target(Node& root, const std::vector<std::string>& path, const std::string& place) {
  Node* node = &root;
  for (const std::string& part : path) node = &child(*node, part, place);
  return *node;
}

/// Whether a scene may have such a key; none has more than a few parts.
bool is_key(const std::vector<std::string>& path) {
  return path.size() <= most_levels && std::find(path.begin(), path.end(), "") == path.end();
}

}  // namespace

void apply_override(Node& root, const std::string& override_text) {
  const std::string place = "--set " + one_line(override_text);
  const auto equals = override_text.find('=');
  const auto path = parts(trimmed(override_text.substr(0, equals)));
  if (equals == std::string::npos || !is_key(path)) {
    throw InputError(place + ": must be key=value, e.g. blocks.1.height=3 or law=consistent");
  }
  Node& node = target(root, path, place);
  Node fresh;
  fresh.name = node.name;
  fresh.key = node.key;
  fresh.place = place;
  const std::string text = trimmed(override_text.substr(equals + 1));
  if (auto value = parse_toml_value(text, fresh)) {
    node = std::move(*value);
  } else {
    fresh.kind = Node::Kind::text;
    fresh.text = text;
    node = std::move(fresh);
  }
}

void set_value(Node& root, const std::string& key, const Node& value) {
  const auto path = parts(key);
  if (!is_key(path)) {
    throw InputError(value.place + ": key = " + one_line(key) +
                     ": must be a scene's key, e.g. blocks.1.height");
  }
  Node& node = target(root, path, value.place);
  node.kind = value.kind;
  node.place = value.place;
  node.number = value.number;
  node.text = value.text;
  node.children = value.children;
}

}  // namespace rockstack
