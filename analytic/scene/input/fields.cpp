#include "analytic/scene/input/fields.hpp"

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {
namespace {

std::string whole_text(double value) {
  return std::to_string(static_cast<long long>(value));
}

/// A bound in the words of a key.
std::string bound_text(double value) {
  constexpr double million = 1e6;
  return value == largest_seed ? "2⁵³" : value == million ? "10⁶" : whole_text(value);
}

}  // namespace

std::string choices_text(const std::vector<NamedChoice>& choices) {
  std::string names;
  for (std::size_t i = 0; i < choices.size(); ++i)
    names += (i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ") + quoted(choices[i].name);
  return names;
}

void require_table(const Node& node, const KeyTable& allowed) {
  if (node.kind != Node::Kind::table) throw wrong_value(node, "a table");
  for (const Node& child : node.children) {
    if (std::ranges::find(allowed.keys, child.name, &InputKey::name) != allowed.keys.end()) continue;
    const auto names = mapped(allowed.keys, [](const InputKey& key) { return std::string(key.name); });
    throw InputError(child.place + ": " + one_line(child.key) + ": unknown key, must be one of " +
                     joined_texts(names, std::identity(), ", ") + did_you_mean(child.name, names));
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

double number_above_zero(const Node& node) {
  if (!(number(node) > 0)) throw wrong_value(node, "a number > 0");
  return node.number;
}

double whole_number(const Node& node, double least, double most) {
  const double value = number(node);
  if (!(value >= least && value <= most) || value != std::floor(value))
    throw wrong_value(node, "a whole number from " + whole_text(least) + " to " + whole_text(most));
  return value;
}

CheckedNumber numbers_between(double least, double most) {
  const std::string range = number_text(least) + " to " + number_text(most);
  return {range, "a number", [=](const Node& node) {
            if (!(number(node) >= least && node.number <= most))
              throw wrong_value(node, "a number from " + range);
            return node.number;
          }};
}

CheckedNumber whole_numbers(double least, double most) {
  constexpr double unsaid = 1e9;
  const std::string range =
      "a whole number from " + bound_text(least) + (most == unsaid ? "" : " to " + bound_text(most));
  return {range, range, [=](const Node& node) { return whole_number(node, least, most); }};
}

double required_number(const Node& table, std::string_view name) {
  return number(required(table, name, "a number"));
}

double number_or(const Node& table, std::string_view name, double otherwise) {
  const Node* node = find(table, name);
  return node == nullptr ? otherwise : number(*node);
}

const std::vector<Node>& entries(const Node& array, const std::string& allowed) {
  if (array.kind != Node::Kind::array || array.children.empty()) throw wrong_value(array, allowed);
  return array.children;
}

std::vector<double> numbers(const Node& node) {
  if (node.kind != Node::Kind::array) throw wrong_value(node, "an array of numbers");
  return mapped(node.children, [](const Node& child) {
    if (!std::isfinite(number(child))) throw wrong_value(child, "a finite number");
    return child.number;
  });
}

std::vector<double> one_each(const Node& array) {
  if (array.kind == Node::Kind::array) entries(array, "a number for each block");
  return numbers(array);
}

const std::string& text(const Node& node) {
  if (node.kind != Node::Kind::text) throw wrong_value(node, "a text in quotes");
  return node.text;
}

std::ptrdiff_t place_among(const Node& node, const std::vector<const char*>& names) {
  const auto found = std::find(names.begin(), names.end(), node.text);
  if (node.kind != Node::Kind::text || found == names.end())
    throw wrong_value(
        node, joined_texts(names, quoted, " or ") + did_you_mean(node.text, {names.begin(), names.end()}));
  return found - names.begin();
}

}  // namespace rockstack
