#include "analytic/scene/ground/records/header.hpp"

#include <algorithm>
#include <utility>

#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {
namespace {

constexpr std::string_view borders = ",;:=()[]#";

bool is_acceleration(std::string_view word) {
  return is_of(word, Topic::acceleration_key);
}

bool is_unit_word(std::string_view word) {
  return is_of(word, Topic::unit) || word.ends_with("unit");
}

bool is_keyword(std::string_view word) {
  return is_acceleration(word) || is_unit_word(word);
}

bool is_filler(std::string_view word) {
  return is_keyword(word) || is_of(word, Topic::unit_filler);
}

std::size_t offset_in(std::string_view text, std::string_view part) {
  return static_cast<std::size_t>(part.data() - text.data());
}

/// The text from a word to the end of its bracket, or to the next sign that parts.
std::string_view segment_at(std::string_view text, std::size_t start) {
  const bool inside = start > 0 && (text[start - 1] == '(' || text[start - 1] == '[');
  int depth = 0;
  std::size_t end = start;
  for (; end < text.size(); ++end) {
    const char c = text[end];
    if (depth == 0 && (c == ')' || c == ']' || (!inside && borders.find(c) != borders.npos && c != '(')))
      break;
    if (c == '(' && !inside && end > start && text[end - 1] == ' ') break;
    depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
  }
  return trimmed(text.substr(start, end - start));
}

void state(Stated& stated, const Unit& unit, std::size_t line) {
  if (stated.unit && stated.unit != unit && stated.contradicted == 0) stated.contradicted = line;
  if (!stated.unit) stated = {unit, line, stated.contradicted};
}

/// Whether a unit is that of one number, which follows: "g=981 cm/s2", "design acceleration (g): 0.3".
bool has_value(std::string_view text, std::size_t end) {
  const std::size_t sign = std::min(text.find_first_not_of(" \t)]", end), text.size());
  if (sign == text.size() || (text[sign] != '=' && text[sign] != ':')) return false;
  const auto next = words(text.substr(sign + 1), "");
  return text[end] == '=' || (!next.empty() && is_numeric(next.front()));
}

/// Whether a unit is multiplied by what follows it in brackets: "g (times 10)".
bool has_factor_after(std::string_view text, std::size_t end) {
  const std::string_view rest = trimmed(text.substr(std::min(end, text.size())));
  const std::string_view inside = rest.substr(0, rest.find(')'));
  return rest.starts_with('(') && inside.find_first_of("0123456789") != inside.npos &&
         (inside.find("times") != inside.npos || inside.find_first_of("x*") != inside.npos);
}

/// Reads what follows keywords, and units in brackets.
void read_units(const Line& line, Header& header) {
  const std::string text = lower(line.text);
  const bool of_peak = speaks_of(text, Topic::peak);  // whose unit need not be that of all
  bool expected = false, of_acceleration = false;
  std::string_view before;
  for (const std::string_view word : words(text, borders)) {
    const std::size_t start = offset_in(text, word);
    const bool of_others = is_of(std::exchange(before, word), Topic::unit_of_others);
    if (is_unit_word(word) && of_others) continue;
    if (is_acceleration(word)) {
      of_acceleration = true;
      if (header.acceleration_line == 0) header.acceleration_line = line.number;
    }
    if (is_keyword(word) || (expected && is_filler(word))) {
      expected = true;
      continue;
    }
    if (!expected) continue;
    expected = false;
    const Found found = unit_at(text, start);
    const std::size_t end = start + found.text.size();
    if (has_value(text, end)) continue;
    if (has_factor_after(text, end) && header.unknown.empty()) {
      header.unknown = trimmed(text.substr(start));
      header.unknown_line = line.number;
      continue;
    }
    if (found.unit && found.unit->quantity == Quantity::time) {
      expected = true;
    } else if (found.unit && found.unit->quantity == Quantity::acceleration) {
      if (!of_peak) state(header.acceleration, *found.unit, line.number);
    } else if (found.unit && !of_acceleration && found.unit->quantity <= Quantity::displacement) {
      state(header.other, *found.unit, line.number);
    } else if ((found.unit || resembles_unit(found.text)) && header.unknown.empty() && !of_peak) {
      header.unknown = found.text;
      header.unknown_line = line.number;
    }
  }
  for (std::size_t open = text.find_first_of("(["); open != text.npos;
       open = text.find_first_of("([", open + 1)) {
    const std::string_view inside = segment_at(text, open + 1);
    if ((open > 0 && text[open - 1] == '/') || has_value(text, open + 1 + inside.size())) continue;
    const auto unit = read_unit(inside);
    if (unit && unit->quantity == Quantity::acceleration && !inside.ends_with('g'))
      state(header.aside, *unit, line.number);
  }
}

/// Notes quantities that the header names beside an acceleration.
void note_mixture(const std::vector<Line>& lines, Header& header) {
  for (const Line& line : lines)
    for (const char* other : {"veloc", "vel.", "displ", "geschwindigkeit", "verschiebung", "vitesse"})
      if (contains(line.text, other) && header.acceleration_line != 0 && header.mixed_line == 0)
        header.mixed_line = line.number;
}

}  // namespace

Found unit_at(std::string_view text, std::size_t start) {
  const std::string_view segment = segment_at(text, start);
  if (const auto unit = read_unit(segment)) return {unit, segment};
  const bool inside = start > 0 && (text[start - 1] == '(' || text[start - 1] == '[');
  const auto list = words(segment, "");
  constexpr std::size_t longest = 5;
  for (std::size_t count = std::min(longest, list.size()); count > 0 && !inside; --count) {
    const std::string_view run =
        segment.substr(0, offset_in(segment, list[count - 1]) + list[count - 1].size());
    const auto unit = read_unit(run);
    if (!unit) continue;
    const std::string_view after = trimmed(segment.substr(run.size()));
    const bool times = after.size() > 1 && after[0] == 'x' && after.find_first_of("0123456789") < 3;
    const bool goes_on =
        times || after.starts_with("\u00d7") ||
        (!after.empty() && std::string_view("0123456789^*/-").find(after.front()) != after.npos);
    if (goes_on) break;
    return {unit, run};
  }
  return {std::nullopt, segment};
}

std::optional<Unit> unit_in_header(const RecordTable& table, Topic topic, Quantity quantity) {
  Stated stated;
  for (const Line& line : table.header) {
    const std::string text = lower(line.text);
    bool expected = false, strict = false;  // strict: what follows must be a unit of that quantity
    for (const std::string_view word : words(text, borders)) {
      const bool of_all = is_unit_word(word) && quantity != Quantity::time;
      if (of_all || is_of(folded(word), topic)) {
        expected = true;
        strict = of_all;
        continue;
      }
      if (!expected) continue;
      strict = strict || (word == "in" && quantity != Quantity::time);
      if (is_filler(word)) continue;
      const Found found = unit_at(text, offset_in(text, word));
      const std::size_t end = offset_in(text, found.text) + found.text.size();
      const bool setting = text.find_first_of("=:", end) == end;  // as in "time in min: 3"
      expected = found.unit && found.unit->quantity == Quantity::time && quantity != Quantity::time;
      if (found.unit && found.unit->quantity == quantity && !setting) state(stated, *found.unit, line.number);
      if (strict && !expected && !(found.unit && found.unit->quantity == quantity))
        table.cursor.fail_at(line.number,
                             in_quotes(found.text) + " is no unit of " + std::string(name(quantity)));
    }
  }
  if (stated.contradicted != 0)
    table.cursor.fail_at(stated.contradicted, "names another unit of " + std::string(name(quantity)) +
                                                  " than line " + std::to_string(stated.line));
  return stated.unit;
}

Header read_header(const RecordTable& table) {
  Header header;
  for (const Line& line : table.header) {
    const Cursor cursor = table.cursor.at_line(line.number);
    const bool above = table.lines.empty() || line.number < table.lines.front();
    if (above) header.last_line = line.number;
    read_units(line, header);
    read_steps(cursor, line, above, header);
    read_statements(cursor, line, header);
  }
  note_mixture(table.header, header);
  return header;
}

Unit stated_unit(const RecordTable& table, const Header& header) {
  const Cursor cursor = table.cursor.at_line(std::max<std::size_t>(header.last_line, 1));
  const Stated& stated = header.acceleration.unit                      ? header.acceleration
                         : header.aside.unit && header.unknown.empty() ? header.aside
                                                                       : header.other;
  if (stated.contradicted != 0)
    cursor.fail_at(stated.contradicted,
                   std::string("names another unit of ") +
                       (&stated == &header.other ? "velocity or displacement" : "acceleration") +
                       " than line " + std::to_string(stated.line));
  if (!header.acceleration.unit && !header.unknown.empty())
    cursor.fail_at(header.unknown_line, in_quotes(header.unknown) +
                                            " is no unit of acceleration: say e.g. \"units: m/s2\" (or "
                                            "cm/s2, gal, g)");
  if (&stated == &header.other && stated.unit && header.acceleration_line != 0)
    cursor.fail_at(stated.line, "names a unit of " + std::string(name(stated.unit->quantity)) + ", line " +
                                    std::to_string(header.acceleration_line) +
                                    " an acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  if (!stated.unit)
    cursor.fail(
        "the header up to here names no unit of acceleration: say e.g. \"units: m/s2\" (or cm/s2, gal, g)");
  return *stated.unit;
}

}  // namespace rockstack::records
