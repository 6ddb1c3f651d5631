#include "analytic/scene/ground/records/format.hpp"

#include <algorithm>
#include <array>

namespace rockstack::records {
namespace {

bool is_keyword(std::string_view word) {
  constexpr std::array keywords{"unit", "units", "acc", "accel", "acceleration"};
  return std::ranges::find(keywords, word) != keywords.end() || word.ends_with("unit");
}

/// Words that may stand between "acceleration" or "units" and the unit.
bool is_filler(std::string_view word) {
  constexpr std::array fillers{"of",     "in",      "is",   "are",    "and",  "the",    "s",      "sec",
                               "second", "seconds", "time", "ground", "data", "series", "history"};
  return is_keyword(word) || std::ranges::find(fillers, word) != fillers.end();
}

/// A unit as files spell it.
std::optional<Unit> unit_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings{
      {{"\u00b2", "2"}, {"^", ""}, {"**", ""}, {"sec", "s"}, {"/s/s", "/s2"}, {"cms", "cm"}}};
  constexpr std::array<std::pair<std::string_view, Unit>, 12> units{
      {{"g", {standard_gravity, 0}},
       {"gal", {centimetre_per_second_squared, 0}},
       {"gals", {centimetre_per_second_squared, 0}},
       {"cm/s2", {centimetre_per_second_squared, 0}},
       {"mm/s2", {1e-3, 0}},
       {"m/s2", {1.0, 0}},
       {"m/s", {1.0, 1}},
       {"cm/s", {0.01, 1}},
       {"mm/s", {1e-3, 1}},
       {"m", {1.0, 2}},
       {"cm", {0.01, 2}},
       {"mm", {1e-3, 2}}}};
  constexpr std::size_t longest = 16;
  if (name.size() > longest) return std::nullopt;
  std::string plain = records::lower(name);
  for (const auto& [from, to] : spellings)
    for (std::size_t at = plain.find(from); at != std::string::npos; at = plain.find(from, at + to.size()))
      plain.replace(at, from.size(), to);
  if (plain.ends_with('.')) plain.pop_back();
  const auto found = std::ranges::find(units, plain, &std::pair<std::string_view, Unit>::first);
  return found == units.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string_view> in_brackets(std::string_view line) {
  std::vector<std::string_view> list;
  for (std::size_t open = line.find_first_of("(["); open != std::string_view::npos;
       open = line.find_first_of("([", open + 1)) {
    const std::string_view inside = line.substr(open + 1);
    list.push_back(trimmed(inside.substr(0, inside.find_first_of(")]"))));
  }
  return list;
}

/// The first of those that a line's keywords or brackets name that is of an acceleration, or is not.
std::optional<Unit> find_unit(const std::string& text, bool acceleration) {
  const auto wanted = [&](std::string_view name) {
    const auto unit = unit_of(name);
    return unit && (unit->derivatives == 0) == acceleration ? unit : std::nullopt;
  };
  bool expected = false;
  for (const std::string_view word : words(text, ",;:=()[]#")) {
    const std::size_t end = static_cast<std::size_t>(word.data() - text.data()) + word.size();
    const bool defined = end < text.size() && text[end] == '=';  // as in "g=981 cm/s2"
    if (const auto unit = wanted(word); unit && expected && !defined) return unit;
    expected = is_keyword(word) || (expected && is_filler(word));
  }
  const auto inside = in_brackets(text);
  const bool beside_time =
      std::ranges::any_of(inside, [](auto name) { return name == "s" || name == "sec"; });
  for (const std::string_view name : inside)
    if (const auto unit = wanted(name); unit && (acceleration || beside_time)) return unit;
  return std::nullopt;
}

}  // namespace

std::optional<double> unit_factor(std::string_view name) {
  const auto unit = unit_of(name);
  return unit && unit->derivatives == 0 ? std::optional(unit->factor) : std::nullopt;
}

std::optional<Unit> find_unit(std::string_view line) {
  const std::string text = lower(line);
  const auto unit = find_unit(text, true);
  return unit ? unit : find_unit(text, false);
}

void HeaderUnit::read(const Cursor& cursor, std::string_view line) {
  const std::optional<Unit> unit = find_unit(line);
  if (!unit) return;
  auto& named = unit->derivatives == 0 ? acceleration_ : other_;
  if (named && named->unit != *unit)
    cursor.fail(std::string("names another unit of ") +
                (unit->derivatives == 0 ? "acceleration" : "velocity or displacement") + " than line " +
                std::to_string(named->line));
  if (!named) named = {*unit, cursor.line_number()};
}

double HeaderUnit::factor(const Cursor& cursor) const {
  if (!acceleration_)
    cursor.fail(
        "the header up to here names no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  return acceleration_->unit.factor;
}

}  // namespace rockstack::records
