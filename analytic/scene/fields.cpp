#include "analytic/scene/fields.hpp"

#include <algorithm>

#include "analytic/scene/scene.hpp"

namespace rockstack {

void require_table(const Node& node, std::initializer_list<std::string_view> allowed) {
  if (node.kind != Node::Kind::table) throw wrong_value(node, "a table");
  for (const Node& child : node.children) {
    if (std::find(allowed.begin(), allowed.end(), child.name) != allowed.end()) continue;
    std::string names;
    for (const auto name : allowed) names += (names.empty() ? "" : ", ") + std::string(name);
    throw InputError(child.place + ": " + one_line(child.key) + ": unknown key, must be one of " + names);
  }
}

const Node& required(const Node& table, std::string_view name, const std::string& allowed) {
  const Node* node = find(table, name);
  if (node == nullptr) throw missing_key(table, name, allowed);
  return *node;
}

double number(const Node& node) {
  if (node.kind != Node::Kind::number) throw wrong_value(node, "a number");
  return node.number;
}

double required_number(const Node& table, std::string_view name) {
  return number(required(table, name, "a number"));
}

double number_or(const Node& table, std::string_view name, double otherwise) {
  const Node* node = find(table, name);
  return node == nullptr ? otherwise : number(*node);
}

std::vector<double> numbers(const Node& node) {
  if (node.kind != Node::Kind::array) throw wrong_value(node, "an array of numbers");
  std::vector<double> result;
  result.reserve(node.children.size());
  for (const Node& child : node.children) {
    result.push_back(number(child));
    require_finite(child.key, result.back());
  }
  return result;
}

const std::string& text(const Node& node) {
  if (node.kind != Node::Kind::text) throw wrong_value(node, "a text in quotes");
  return node.text;
}

}  // namespace rockstack
