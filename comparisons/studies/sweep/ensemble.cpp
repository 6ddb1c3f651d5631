#include "comparisons/studies/sweep/ensemble.hpp"

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/build.hpp"

namespace rockstack {
namespace {

Value number_value(double number, const std::string& place) {
  return {{.kind = Node::Kind::number, .place = place, .number = number}, number_text(number)};
}

/// Whether a value is a record's path, by any of the keys.
bool is_record(const Variation& variation, const Value& value) {
  return value.node.kind == Node::Kind::text &&
         std::ranges::any_of(variation.keys, [](const std::string& key) { return key.ends_with(".record"); });
}

void describe_record(const std::filesystem::path& name, MotionLibrary& library, std::string& text) {
  const auto motion = library.record(name);
  text += number_text(motion->interval);
  for (const double sample : motion->samples) text += " " + number_text(sample);
  text += "\n";
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

Distribution read_distribution(const Node& node) {
  if (node.name == "uniform") {
    if (node.kind != Node::Kind::array || node.children.size() != 2)
      throw wrong_value(node, "an array of two numbers, from and to");
    const double from = finite(node.children[0]), to = finite(node.children[1]);
    if (!(from < to)) throw wrong_value(node.children[1], "a number above the first, " + number_text(from));
    return {Distribution::Kind::uniform, from, to};
  }
  const bool normal = node.name == "normal";
  Distribution drawn{normal ? Distribution::Kind::normal : Distribution::Kind::lognormal};
  read_members(node, normal ? normal_keys : lognormal_keys, drawn);
  return drawn;
}

/// The one way of giving values that a table [[vary]] has.
const Node& way(const Node& table) {
  const Node* found = nullptr;
  for (const Node& child : table.children) {
    if (child.name == "key" || child.name == "group") continue;
    if (found != nullptr) throw excluded_key(child, *found);
    found = &child;
  }
  if (found == nullptr)
    throw missing_key(table, "values", "given, or range, uniform, normal or lognormal in its place");
  return *found;
}

}  // namespace

const KeyTable vary_keys{
    "[[vary]]",
    "values of a key: each table is a direction of the grid, or is drawn",
    {{"key", "\"duration\"", "", "a key of the scene, or an array of keys that get the same value",
      required_key, "as --set has it, e.g. \"blocks.2.height\""},
     {"group", "\"a\"", "", "a text", "none: a direction of its own",
      "tables of one group take their values in step"},
     {"values", "[0.5, 1.0]", "the key's", "numbers or texts", required_key, "one after the other"},
     {"range", "{ from = 0.5, to = 1.0, count = 3 }", "the key's", "a table, see below", "instead of values",
      "numbers at equal distances"},
     {"uniform", "[0.5, 1.0]", "the key's", "two numbers, the second larger", "instead of values",
      "drawn between the two"},
     {"normal", "{ mean = 1.0, deviation = 0.1 }", "the key's", "a table, see below", "instead of values",
      "drawn from a normal distribution"},
     {"lognormal", "{ median = 1.0, beta = 0.3 }", "the key's", "a table, see below", "instead of values",
      "drawn from a lognormal distribution"}}};

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

std::size_t run_count(const Ensemble& ensemble) {
  std::size_t count = ensemble.samples;
  for (const Axis& axis : ensemble.axes) count *= axis.length;
  return count;
}

std::size_t block_count(const Ensemble& ensemble) {
  return find(ensemble.base.root, "blocks")->children.size();
}

std::vector<Value> values_of(const Ensemble& ensemble, std::size_t run) {
  std::vector<Value> values(ensemble.variations.size());
  std::size_t point = run / ensemble.samples;
  for (auto axis = ensemble.axes.rbegin(); axis != ensemble.axes.rend(); ++axis) {
    for (const std::size_t v : axis->variations)
      values[v] = ensemble.variations[v].values[point % axis->length];
    point /= axis->length;
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    const Variation& variation = ensemble.variations[v];
    if (!variation.distribution) continue;
    const double drawn = draw(*variation.distribution, {ensemble.seed, run, static_cast<std::uint32_t>(v)});
    values[v] = number_value(drawn, variation.place);
  }
  return values;
}

void set_values(SceneDocument& document, const Variation& variation, const Value& value) {
  for (const std::string& key : variation.keys) set_value(document.root, key, value.node);
}

Json json_of(const Variation& variation) {
  Json json{{"keys", variation.keys}};
  constexpr std::array kinds{"uniform", "normal", "lognormal"};  // as Distribution::Kind has them
  if (const auto& drawn = variation.distribution)
    json[kinds.at(static_cast<std::size_t>(drawn->kind))] = {drawn->first, drawn->second};
  for (const Value& value : variation.values)
    json["values"].push_back(value.node.kind == Node::Kind::number ? Json(value.node.number)
                                                                   : Json(value.text));
  return json;
}

std::string identity(const Ensemble& ensemble, MotionLibrary& library) {
  std::string text = std::string(build::version) + "\n" + build::compiler + "\n" + build::flags + "\n";
  text += page_scene(ensemble.base.root).dump() + "\n";
  for (const char* key : {"ground.horizontal.record", "ground.vertical.record"}) {
    const Node& node = nearest(ensemble.base.root, key);
    if (node.name == "record" && node.kind == Node::Kind::text)
      describe_record(ensemble.base.folder / node.text, library, text);
  }
  text += std::to_string(ensemble.samples) + " " + std::to_string(ensemble.seed) + " " +
          number_text(ensemble.tolerance) + (ensemble.demands ? "\n" : " without demands\n");
  for (const Variation& variation : ensemble.variations) {
    text += json_of(variation).dump() + "\n";
    for (const Value& value : variation.values)
      if (is_record(variation, value)) describe_record(ensemble.base.folder / value.node.text, library, text);
  }
  for (const Axis& axis : ensemble.axes) text += Json(axis.variations).dump() + "\n";
  return text;
}

Variation read_variation(const Node& table, const std::filesystem::path& folder) {
  require_table(table, vary_keys);
  Variation variation;
  variation.place = table.place;
  const Node& key = required(table, "key", "a key of the scene");
  variation.keys = key.kind == Node::Kind::text
                       ? std::vector{key.text}
                       : mapped(entries(key, "a key of the scene, or an array of such keys"), text);
  // Whatever the value of these, the exact motion is the same.
  const auto is_label = [](const std::string& one) { return one == "title" || one == "engine.depth"; };
  if (find(table, "group") == nullptr && std::ranges::all_of(variation.keys, is_label))
    throw wrong_value(key, "a key that changes the exact motion, or one of a group");
  const Node& given = way(table);
  if (given.name == "values")
    variation.values = read_values(given);
  else if (given.name == "range")
    variation.values = read_range(given);
  else
    variation.distribution = read_distribution(given);
  for (Value& value : variation.values)
    if (is_record(variation, value))
      value.node.text = std::filesystem::absolute(folder / value.node.text).string();
  return variation;
}

Value typical_value(const Variation& variation) {
  return variation.distribution ? number_value(median(*variation.distribution), variation.place)
                                : variation.values.front();
}

SceneDocument typical_document(const Ensemble& ensemble) {
  SceneDocument document = ensemble.base;
  for (const Variation& variation : ensemble.variations)
    set_values(document, variation, typical_value(variation));
  return document;
}

}  // namespace rockstack
