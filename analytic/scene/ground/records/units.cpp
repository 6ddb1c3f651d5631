#include "analytic/scene/ground/records/units.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace rockstack::records {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

bool is_keyword(std::string_view word) {
  constexpr std::array keywords{"unit", "units", "acc", "accel", "acceleration"};
  return std::find(keywords.begin(), keywords.end(), word) != keywords.end() || word.ends_with("unit");
}

/// Words that may stand between "acceleration" or "units" and the unit.
bool is_filler(std::string_view word) {
  constexpr std::array fillers{"of",     "in",      "is",   "are",    "and",  "the",    "s",      "sec",
                               "second", "seconds", "time", "ground", "data", "series", "history"};
  return is_keyword(word) || std::find(fillers.begin(), fillers.end(), word) != fillers.end();
}

std::optional<double> bracketed_unit(std::string_view line) {
  for (std::size_t open = line.find_first_of("(["); open != std::string_view::npos;
       open = line.find_first_of("([", open + 1)) {
    const std::string_view inside = line.substr(open + 1);
    if (const auto factor = unit_factor(trimmed(inside.substr(0, inside.find_first_of(")]"))))) return factor;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> unit_factor(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> spellings{
      {{"\u00b2", "2"}, {"^", ""}, {"**", ""}, {"sec", "s"}, {"/s/s", "/s2"}, {"cms", "cm"}}};
  constexpr std::array<std::pair<std::string_view, double>, 6> units{
      {{"g", standard_gravity},
       {"gal", centimetre_per_second_squared},
       {"gals", centimetre_per_second_squared},
       {"cm/s2", centimetre_per_second_squared},
       {"mm/s2", 1e-3},
       {"m/s2", 1.0}}};
  constexpr std::size_t longest = 16;
  if (name.size() > longest) return std::nullopt;
  std::string plain = lower(name);
  for (const auto& [from, to] : spellings) replace_all(plain, from, to);
  if (plain.ends_with('.')) plain.pop_back();
  for (const auto& [unit, factor] : units) {
    if (plain == unit) return factor;
  }
  return std::nullopt;
}

std::optional<double> find_unit(std::string_view line) {
  const std::string text = lower(line);
  bool expected = false;
  for (const std::string_view word : words(text, ",;:=()[]#")) {
    const std::size_t end = static_cast<std::size_t>(word.data() - text.data()) + word.size();
    const bool defined = end < text.size() && text[end] == '=';  // as in "g=981 cm/s2"
    if (expected && !defined) {
      if (const auto factor = unit_factor(word)) return factor;
    }
    expected = is_keyword(word) || (expected && is_filler(word));
  }
  return bracketed_unit(text);
}

void HeaderUnit::read(const Cursor& cursor, std::string_view line) {
  const std::optional<double> factor = find_unit(line);
  if (!factor) return;
  if (factor_ && *factor_ != *factor) {
    cursor.fail("names another unit of acceleration than line " + std::to_string(line_));
  }
  if (!factor_) line_ = cursor.line_number();
  factor_ = factor;
}

double HeaderUnit::factor(const Cursor& cursor) const {
  if (!factor_) {
    cursor.fail(
        "the header up to here names no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  }
  return *factor_;
}

}  // namespace rockstack::records
