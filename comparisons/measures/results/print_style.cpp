#include "comparisons/measures/results/print_style.hpp"

#include <fmt/format.h>

#include "analytic/scene/input/toml_reader.hpp"

namespace rockstack {
namespace {

std::vector<std::string> texts(const Node& array) {
  return mapped(entries(array, "an array of at least one name"),
                [](const Node& child) { return text(child); });
}

std::string value_text(const Node& node) {
  if (node.kind == Node::Kind::array) return "[" + joined_texts(node.children, value_text, ", ") + "]";
  if (node.kind == Node::Kind::number) return number_text(node.number);
  return node.kind == Node::Kind::text ? toml_text(node.text) : node.text;
}

/// A value of a command line as TOML.
std::string option_value(const InputKey& key, std::string text) {
  const std::string_view unit = key.unit, example = key.example;
  if (!unit.empty() && text.ends_with(unit)) text.resize(text.size() - unit.size());
  if (example.starts_with('"')) return toml_text(text);
  if (!example.starts_with('[')) return text;
  std::string list;
  for (std::size_t from = 0, to = 0; from <= text.size(); from = to + 1) {
    to = std::min(text.find(',', from), text.size());
    list += (list.empty() ? "" : ", ") + toml_text(text.substr(from, to - from));
  }
  return "[" + list + "]";
}

}  // namespace

const KeysOf<PrintStyle> print_keys{
    "[figures]",
    "figures for print, beside those of the report",
    {{"style",
      "\"paper\"",
      {{"paper", "as journals print them: vector pictures, a picture of 300 dots an inch, and their data"}},
      "how figures look",
      &PrintStyle::style},
     {"width", "88.0", "mm", numbers_between(50, 400), "of a figure: 88 is a journal's column, 180 its page",
      &PrintStyle::width},
     {"font", "\"Liberation Serif\"", "", "a family that is installed", "\"DejaVu Sans\"", "of all words",
      &PrintStyle::font},
     {"font_size", "8.0", "pt", numbers_between(4, 24), "of the words of axes", &PrintStyle::font_size},
     {"unit",
      "\"deg\"",
      {{"auto", "rad, or mrad of small angles"}, {"rad"}, {"mrad"}, {"deg"}},
      "of angles",
      &PrintStyle::unit},
     {{"titles", "\"none\"", "", "\"scene\" or \"none\"", "\"scene\"", "what stands above a figure"},
      [](const Node& node, PrintStyle& style) {
        style.titles = choice<bool>(node, {{"scene", true}, {"none", false}});
      }},
     {{"figures", "[\"motion\", \"error-step\"]", "", "names of figures that the results have", no_default,
       "which are drawn; left out: all for which the other keys have a meaning"},
      [](const Node& node, PrintStyle& style) { style.figures = texts(node); }},
     {{"panels", "[\"θ2\", \"slip\"]", "", "quantities over time, θ2 of one block or θ of all", no_default,
       "what the figure of a motion shows; left out: all angles"},
      [](const Node& node, PrintStyle& style) { style.panels = texts(node); }},
     {"from", "4.0", "s", numbers_between(0, largest_number), "where axes of time begin", &PrintStyle::from},
     {"to", "7.0", "s", numbers_above_zero(), "the motion's end", "where axes of time end at the latest",
      &PrintStyle::to}}};

PrintStyle read_print_style(const Node& table) {
  PrintStyle style;
  read_members(table, print_keys, style);
  if (const Node* to = find(table, "to"); to != nullptr && !(style.to > style.from))
    throw wrong_value(*to, fmt::format("a time after `from`, {} s", number_text(style.from)));
  constexpr double least = 7.5;  // mm for each pt, so that numbers of axes have room beside each other
  const Node* size = find(table, find(table, "font_size") != nullptr ? "font_size" : "width");
  if (size != nullptr && style.width < least * style.font_size)
    throw wrong_value(
        *size, fmt::format("such that `width`, {} mm, is at least {} mm for each pt of `font_size`, {}",
                           number_text(style.width), least, number_text(style.font_size)));
  return style;
}

Node style_table(const std::vector<std::pair<std::string, std::string>>& options) {
  Node table;
  for (const auto& [name, value] : options) {
    const InputKey& key = *std::ranges::find(print_keys.keys, name, &InputKey::name);
    const Node target = make_child(table, name, "--" + name);
    Node text = target;
    text.kind = Node::Kind::text;
    text.text = value;
    table.children.push_back(parse_toml_value(option_value(key, value), target).value_or(text));
  }
  return table;
}

std::string style_text(const Node& table) {
  return joined_texts(table.children,
                      [](const Node& node) { return node.name + " = " + value_text(node) + "\n"; });
}

PrintStyle read_style_text(const std::string& text, const std::string& place) {
  return read_print_style(parse_toml(text, place));
}

}  // namespace rockstack
