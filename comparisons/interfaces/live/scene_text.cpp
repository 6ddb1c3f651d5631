#include "comparisons/interfaces/live/scene_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::live {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* infinite = "inf";

/// As a value's place in messages.
constexpr const char* place = "the page";

Json page_value(const Node& node) {
  switch (node.kind) {
    case Node::Kind::number:
      return std::isfinite(node.number) ? Json(node.number) : Json(infinite);
    case Node::Kind::text:
    case Node::Kind::other:
      return node.text;
    case Node::Kind::array: {
      Json list = Json::array();
      for (const Node& child : node.children) list.push_back(page_value(child));
      return list;
    }
    case Node::Kind::table:
      break;
  }
  Json table = Json::object();
  for (const Node& child : node.children) table[child.name] = page_value(child);
  return table;
}

void fill(Node& node, const Json& value);

void add_child(Node& node, std::string name, const Json& value) {
  Node child = make_child(node, std::move(name), place);
  fill(child, value);
  node.children.push_back(std::move(child));
}

void fill(Node& node, const Json& value) {
  if (value.is_object()) {
    node.kind = Node::Kind::table;
    for (const auto& [name, entry] : value.items()) add_child(node, name, entry);
  } else if (value.is_array()) {
    node.kind = Node::Kind::array;
    node.children.reserve(value.size());
    for (const Json& entry : value) add_child(node, std::to_string(node.children.size() + 1), entry);
  } else if (value.is_number() || (value == infinite && node.name != "title")) {
    node.kind = Node::Kind::number;
    node.number = value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
  } else {
    node.kind = value.is_string() ? Node::Kind::text : Node::Kind::other;
    node.text = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

bool is_tables(const Json& value) {
  return value.is_array() && !value.empty() && value.front().is_object();
}

/// Values first, then tables, whose headers end those before.
void add_table(const Json& table, const std::string& key, std::string& text) {
  for (const auto& [name, value] : table.items())
    if (!value.is_object() && !is_tables(value))
      text += fmt::format("{} = {}\n", name,
                          name == "title" ? toml_text(value.get<std::string>()) : toml_value(value));
  for (const auto& [name, value] : table.items()) {
    const std::string inner = fmt::format("{}{}{}", key, key.empty() ? "" : ".", name);
    const Json tables = is_tables(value) ? value : Json::array({value});
    for (const Json& entry : tables) {
      if (!entry.is_object()) continue;
      text += is_tables(value) ? fmt::format("\n[[{}]]\n", inner) : fmt::format("\n[{}]\n", inner);
      add_table(entry, inner, text);
    }
  }
}

}  // namespace

Json page_scene(const Node& document) {
  return page_value(document);
}

Node scene_document(const Json& scene) {
  Node root;
  root.place = place;
  fill(root, scene);
  return root;
}

std::string toml_value(const Json& value) {
  if (value.is_string()) return value == infinite ? infinite : toml_text(value.get<std::string>());
  if (value.is_number()) return number_text(value.get<double>());
  std::string list;
  for (const Json& entry : value) list += (list.empty() ? "" : ", ") + toml_value(entry);
  return "[" + list + "]";
}

std::string scene_file_text(const Json& scene) {
  std::string text;
  add_table(scene, "", text);
  return text;
}

}  // namespace rockstack::live
