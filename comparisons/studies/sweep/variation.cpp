#include <nlohmann/json.hpp>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"

// What a table [[vary]] has.

namespace rockstack {
namespace {

Value number_value(double number, const std::string& place) {
  return {{.kind = Node::Kind::number, .place = place, .number = number}, number_text(number)};
}

std::vector<Value> read_values(const Node& array) {
  std::vector<Value> values;
  for (const Node& child : entries(array, "an array of numbers or texts")) {
    if (child.kind != Node::Kind::number && child.kind != Node::Kind::text)
      throw wrong_value(child, "a number or a text");
    values.push_back({child, child.kind == Node::Kind::text ? child.text : number_text(child.number)});
  }
  return values;
}

std::vector<Value> read_range(const Node& table) {
  EvenValues range;
  read_members(table, range_keys, range);
  const double from = range.from, to = range.to;
  if (range.logarithmic && !(from > 0 && to > 0))
    throw wrong_value(*find(table, "spacing"), "\"linear\" where from or to is not > 0");
  std::vector<Value> values{number_value(from, table.place)};
  const auto steps = static_cast<double>(range.count - 1);
  for (std::size_t i = 1; i < range.count; ++i) {
    const auto step = static_cast<double>(i);
    const double inner =
        range.logarithmic ? from * std::pow(to / from, step / steps) : from + (to - from) * step / steps;
    values.push_back(number_value(i + 1 == range.count ? to : inner, table.place));
  }
  return values;
}

double finite(const Node& node) {
  if (!std::isfinite(number(node))) throw wrong_value(node, "a finite number");
  return node.number;
}

CheckedNumber finite_numbers() {
  return {"any number", "a number", finite};
}

CheckedNumber finite_above_zero() {
  return {"> 0", "a number", [](const Node& node) {
            finite(node);
            return number_above_zero(node);
          }};
}

Distribution read_uniform(const Node& node) {
  if (node.kind != Node::Kind::array || node.children.size() != 2)
    throw wrong_value(node, "an array of two numbers, from and to");
  const double from = finite(node.children[0]), to = finite(node.children[1]);
  if (!(from < to)) throw wrong_value(node.children[1], "a number above the first, " + number_text(from));
  return {Distribution::Kind::uniform, from, to};
}

Distribution read_distribution(const Node& node, Distribution::Kind kind, const KeysOf<Distribution>& keys) {
  Distribution drawn{kind};
  read_members(node, keys, drawn);
  return drawn;
}

/// Values of which each is as likely as any other.
void read_one_of(const Node& node, Variation& variation) {
  variation.values = node.kind == Node::Kind::table ? read_range(node) : read_values(node);
  variation.distribution = {Distribution::Kind::uniform, 0, static_cast<double>(variation.values.size())};
}

std::vector<std::string> read_keys(const Node& key) {
  return key.kind == Node::Kind::text
             ? std::vector{key.text}
             : mapped(entries(key, "a key of the scene, or an array of such keys"), text);
}

/// Refuses a table [[vary]] that does not give values in one way.
void require_one_way(const Node& table) {
  const Node* found = nullptr;
  for (const Node& child : table.children) {
    if (child.name == "key" || child.name == "group") continue;
    if (found != nullptr) throw excluded_key(child, *found);
    found = &child;
  }
  if (found == nullptr)
    throw missing_key(table, "values", "given, or range, one_of, uniform, normal or lognormal in its place");
}

}  // namespace

const KeysOf<Variation> vary_keys{
    "[[vary]]",
    "values of a key: each table is a direction of the grid, or is drawn",
    {{{"key", "\"duration\"", "", "a key of the scene, or an array of keys that get the same value",
       required_key, "as --set has it, e.g. \"blocks.2.height\""},
      [](const Node& node, Variation& variation) { variation.keys = read_keys(node); }},
     {"group", "\"a\"", "", "a text", "none: a direction of its own",
      "tables of one group take their values in step", &Variation::group},
     {{"values", "[0.5, 1.0]", "the key's", "numbers or texts", required_key, "one after the other"},
      [](const Node& node, Variation& variation) { variation.values = read_values(node); }},
     {{"range", "{ from = 0.5, to = 1.0, count = 3 }", "the key's", "a table, see below", "instead of values",
       "numbers at equal distances"},
      [](const Node& node, Variation& variation) { variation.values = read_range(node); }},
     {{"one_of", "[0.5, 1.0]", "the key's", "numbers or texts, or a table as range has it",
       "instead of values", "drawn, each as likely as any other: records, or seeds"},
      read_one_of},
     {{"uniform", "[0.5, 1.0]", "the key's", "two numbers, the second larger", "instead of values",
       "drawn between the two"},
      [](const Node& node, Variation& variation) { variation.distribution = read_uniform(node); }},
     {{"normal", "{ mean = 1.0, deviation = 0.1 }", "the key's", "a table, see below", "instead of values",
       "drawn from a normal distribution"},
      [](const Node& node, Variation& variation) {
        variation.distribution = read_distribution(node, Distribution::Kind::normal, normal_keys);
      }},
     {{"lognormal", "{ median = 1.0, beta = 0.3 }", "the key's", "a table, see below", "instead of values",
       "drawn from a lognormal distribution"},
      [](const Node& node, Variation& variation) {
        variation.distribution = read_distribution(node, Distribution::Kind::lognormal, lognormal_keys);
      }}}};

const KeysOf<EvenValues> range_keys{
    "[vary.range]",
    "numbers at equal distances",
    {{"from", "0.5", "the key's", any_number, required_key, "first value", &EvenValues::from},
     {"to", "1.0", "the key's", any_number, required_key, "last value", &EvenValues::to},
     {"count", "3", "", whole_numbers(2, 1e6), required_key, "number of values", &EvenValues::count},
     {{"spacing", "\"linear\"", "", "\"linear\" or \"log\"", "\"linear\"",
       "equal differences or equal ratios"},
      [](const Node& node, EvenValues& range) {
        range.logarithmic = choice<bool>(node, {{"linear", false}, {"log", true}});
      }}}};

const KeysOf<Distribution> normal_keys{
    "[vary.normal]",
    "a normal distribution",
    {{"mean", "1.0", "the key's", finite_numbers(), required_key, "of the values", &Distribution::first},
     {"deviation", "0.1", "the key's", finite_above_zero(), required_key, "standard deviation",
      &Distribution::second}}};

const KeysOf<Distribution> lognormal_keys{
    "[vary.lognormal]",
    "a lognormal distribution",
    {{"median", "1.0", "the key's", finite_above_zero(), required_key, "of the values", &Distribution::first},
     {"beta", "0.3", "", finite_above_zero(), required_key, "standard deviation of the natural logarithm",
      &Distribution::second}}};

Variation read_variation(const Node& table, const std::filesystem::path& folder) {
  require_table(table, vary_keys);
  const Node& key = required(table, "key", "a key of the scene");
  require_one_way(table);
  Variation variation;
  variation.place = table.place;
  read_members(table, vary_keys, variation);
  // Whatever the value of these, the exact motion is the same.
  const auto is_label = [](const std::string& one) { return one == "title" || one == "engine.depth"; };
  if (variation.group.empty() && std::ranges::all_of(variation.keys, is_label))
    throw wrong_value(key, "a key that changes the exact motion, or one of a group");
  for (Value& value : variation.values)
    if (is_record(variation, value))
      value.node.text = std::filesystem::absolute(folder / value.node.text).string();
  return variation;
}

bool is_record(const Variation& variation, const Value& value) {
  return value.node.kind == Node::Kind::text &&
         std::ranges::any_of(variation.keys, [](const std::string& key) { return key.ends_with(".record"); });
}

Value drawn_value(const Variation& variation, double draw) {
  return variation.values.empty() ? number_value(draw, variation.place)
                                  : variation.values.at(static_cast<std::size_t>(draw));
}

Value typical_value(const Variation& variation) {
  return variation.values.empty() ? drawn_value(variation, median(*variation.distribution))
                                  : variation.values.front();
}

Json json_of(const Variation& variation) {
  Json json{{"keys", variation.keys}};
  constexpr std::array kinds{"uniform", "normal", "lognormal"};  // as Distribution::Kind has them
  const auto& drawn = variation.distribution;
  if (variation.values.empty())
    json[kinds.at(static_cast<std::size_t>(drawn->kind))] = {drawn->first, drawn->second};
  for (const Value& value : variation.values)
    json[drawn ? "one_of" : "values"].push_back(
        value.node.kind == Node::Kind::number ? Json(value.node.number) : Json(value.text));
  return json;
}

}  // namespace rockstack
