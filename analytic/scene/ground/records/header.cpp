#include "analytic/scene/ground/records/header.hpp"

#include <algorithm>
#include <array>

namespace rockstack::records {
namespace {

constexpr std::string_view borders = ",;:=()[]#";

bool is_acceleration(std::string_view word) {
  constexpr std::array list{"acc",           "accel",        "acceleration",
                            "accelerations", "accelerogram", "beschleunigung"};
  return std::ranges::find(list, word) != list.end();
}

bool is_keyword(std::string_view word) {
  constexpr std::array list{"unit", "units", "einheit", "einheiten"};
  return is_acceleration(word) || std::ranges::find(list, word) != list.end() || word.ends_with("unit");
}

/// Words that may stand between "acceleration" or "units" and the unit.
bool is_filler(std::string_view word) {
  constexpr std::array fillers{"of",     "in",        "is",   "are",    "and",    "the",
                               "all",    "values",    "time", "ground", "data",   "history",
                               "series", "histories", "s",    "sec",    "second", "seconds"};
  return is_keyword(word) || std::ranges::find(fillers, word) != fillers.end();
}

/// Words of a line about its largest value, whose unit need not be that of all.
bool is_of_peak(std::string_view line) {
  return std::ranges::any_of(words(line, " ,;:=()[]#_"), [](std::string_view word) {
    constexpr std::array list{"pga", "peak", "max", "maximum", "min", "minimum", "pgv", "pgd"};
    return std::ranges::find(list, word) != list.end();
  });
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

struct Found {
  std::optional<Unit> unit = {};
  std::string_view text;  ///< of the unit, or what stands in its place
};

/// The unit that a segment begins with: its longest run of words that is one, unless a number or a sign of
/// units follows, which would belong to it.
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
    const bool goes_on =
        !after.empty() && std::string_view("0123456789^*/-").find(after.front()) != after.npos;
    if (goes_on) break;
    return {unit, run};
  }
  return {std::nullopt, segment};
}

void state(Stated& stated, const Unit& unit, std::size_t line) {
  if (stated.unit && stated.unit != unit && stated.contradicted == 0) stated.contradicted = line;
  if (!stated.unit) stated = {unit, line, stated.contradicted};
}

/// Reads what follows keywords, and units in brackets.
void read_units(const Line& line, Header& header) {
  const std::string text = lower(line.text);
  const bool of_peak = is_of_peak(text);
  bool expected = false, of_acceleration = false;
  for (const std::string_view word : words(text, borders)) {
    const std::size_t start = offset_in(text, word);
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
    if (end < text.size() && text[end] == '=') continue;  // as in "g=981 cm/s2"
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

constexpr std::array steps{"dt",
                           "delta t",
                           "delta_t",
                           "deltat",
                           "delta",
                           "\u03b4t",
                           "\u0394t",
                           "time step",
                           "timestep",
                           "time_step",
                           "time interval",
                           "interval",
                           "sampling period",
                           "zeitschritt",
                           "abtastintervall",
                           "pas de temps"};
constexpr std::array rates{"samplerate",
                           "sample rate",
                           "sample_rate",
                           "sampling rate",
                           "sampling_rate",
                           "sampling frequency",
                           "sampling_frequency",
                           "sampling freq",
                           "sample frequency",
                           "samplingrate",
                           "fs",
                           "sps",
                           "abtastrate",
                           "abtastfrequenz"};

/// What stands after a key: the unit in brackets, a number, the unit after that.
struct Setting {
  std::string_view unit_before, number, after;
};

std::optional<Setting> setting_after(std::string_view text, std::string_view key) {
  const std::string plain = lower(text);
  const auto in_word = [&](std::size_t at) {
    const char c = at < plain.size() ? plain[at] : ' ';
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '_';
  };
  for (std::size_t from = plain.find(key); from != plain.npos; from = plain.find(key, from + 1)) {
    if (in_word(from - 1) || in_word(from + key.size())) continue;
    Setting setting;
    std::string_view rest = trimmed(text.substr(from + key.size()));
    if (rest.starts_with('(') || rest.starts_with('[')) {
      const std::size_t close = std::min(rest.find_first_of(")]"), rest.size());
      setting.unit_before = trimmed(rest.substr(1, close - 1));
      rest.remove_prefix(std::min(close + 1, rest.size()));
    }
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t=:,\""), rest.size()));
    setting.number = rest.substr(0, rest.find_first_of(" \t,;)(]["));
    setting.after = trimmed(rest.substr(setting.number.size()));
    // "0,025": a decimal comma; "0.02sec".
    const std::string_view tail = rest.substr(setting.number.size());
    if (tail.size() > 1 && tail[0] == ',' && tail[1] >= '0' && tail[1] <= '9' &&
        setting.number.find_first_not_of("0123456789") == text.npos) {
      const std::size_t digits = std::min(tail.find_first_not_of("0123456789", 1), tail.size());
      setting.number = rest.substr(0, setting.number.size() + digits);
      setting.after = trimmed(tail.substr(digits));
    }
    const std::size_t letter = lower(setting.number).find_first_not_of("0123456789+-.,ed");
    if (letter != text.npos && letter > 0 && read_unit(setting.number.substr(letter))) {
      setting.after = setting.number.substr(letter);
      setting.number = setting.number.substr(0, letter);
    }
    return setting;
  }
  return std::nullopt;
}

double plain_number(const Cursor& cursor, std::string_view field) {
  std::string text(field);
  std::ranges::replace(text, ',', '.');
  return number(cursor, text);
}

/// The step that a number and its unit give; where none is named, of a rate in Hz, of a step in s.
double interval_of(const Cursor& cursor, const Setting& setting, bool rate) {
  const double value = plain_number(cursor, setting.number);
  std::optional<Unit> unit = read_unit(setting.unit_before);
  if (!setting.unit_before.empty() && !unit)
    cursor.fail(in_quotes(setting.unit_before) +
                " is no unit of a time step or rate: must be s, ms, min or Hz");
  std::string_view after = setting.after;
  if (after.starts_with('(') || after.starts_with('[')) after.remove_prefix(1);
  if (!after.empty() && std::string_view(",;").find(after.front()) == after.npos)
    if (const Found found = unit_at(after, 0); found.unit) unit = found.unit;
  if (unit && unit->quantity == Quantity::time) return checked_interval(cursor, value * unit->factor);
  if (unit && unit->quantity == Quantity::frequency)
    return checked_interval(cursor, 1 / (value * unit->factor));
  return checked_interval(cursor, rate ? 1 / value : value);
}

void read_intervals(const Cursor& cursor, std::string_view line, bool required, Header& header) {
  for (const bool rate : {false, true}) {
    const auto read = [&](std::string_view key) {
      const auto setting = setting_after(line, key);
      if (!setting || setting->number.empty() || !(required || is_numeric(setting->number))) return;
      note_interval(cursor, interval_of(cursor, *setting, rate), header);
    };
    if (rate)
      std::ranges::for_each(rates, read);
    else
      std::ranges::for_each(steps, read);
  }
}

/// "NPTS=  4000, DT= .01000 SEC", or the older "4000  .01000  NPTS, DT", in either order.
void read_count(const Cursor& cursor, std::string_view line, Header& header) {
  const std::string plain = lower(line);
  const auto fields = words(line, ",=:");
  header.count_line = cursor.line_number();
  if (is_numeric(fields.front()) && fields.size() > 2) {
    const bool count_first = plain.find("npts") < plain.find("dt");
    header.count = count(cursor, fields[count_first ? 0 : 1]);
    note_interval(cursor, checked_interval(cursor, number(cursor, fields[count_first ? 1 : 0])), header);
    return;
  }
  header.count = count(cursor, field_after(line, "npts"));
  read_intervals(cursor, line, true, header);
}

}  // namespace

void note_interval(const Cursor& cursor, double interval, Header& header) {
  if (header.interval && *header.interval != interval)
    cursor.fail("names another time step than a line before");
  header.interval = interval;
  header.interval_line = cursor.line_number();
}

Header read_header(const RecordTable& table) {
  Header header;
  for (const Line& line : table.header) {
    const Cursor cursor = table.cursor.at_line(line.number);
    const bool above = table.lines.empty() || line.number < table.lines.front();
    if (above) header.last_line = line.number;
    read_units(line, header);
    const bool comment = trimmed(line.text).find_first_of("#%!/;") == 0;
    if (header.count == 0 && above && contains(line.text, "npts") && !comment)
      read_count(cursor, line.text, header);
    else
      read_intervals(cursor, line.text, false, header);
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
