#include <algorithm>
#include <cmath>

#include "analytic/scene/ground/records/header.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack::records {
namespace {

/// What names a time step or a rate, folded, by topic.
struct Keys {
  Topic topic;
  bool rate = false, needs_sign = false;
};

constexpr Keys keys[] = {{Topic::step},
                         {Topic::step_with_sign, false, true},
                         {Topic::rate, true},
                         {Topic::rate_with_sign, true, true}};

/// What stands after a key: the unit in brackets, a number, the unit after that.
struct Setting {
  std::string_view unit_before = {}, number = {}, after = {};
  bool signed_before = false;  ///< "=" or ":" stands before the number
};

bool goes_on_at(std::string_view plain, std::size_t at) {
  const char c = at < plain.size() ? plain[at] : ' ';
  return is_digit(c) || (c >= 'a' && c <= 'z') || c == '_';
}

/// Takes what stands in brackets off the front.
std::string_view take_bracket(std::string_view& rest) {
  if (!rest.starts_with('(') && !rest.starts_with('[')) return {};
  const std::size_t close = std::min(rest.find_first_of(")]"), rest.size());
  const std::string_view inside = trimmed(rest.substr(1, close - 1));
  rest.remove_prefix(std::min(close + 1, rest.size()));
  return inside;
}

/// Parts a unit from the number that it follows at once: "0.02sec".
void part_unit(Setting& setting) {
  const std::size_t letter = setting.number.find_first_not_of("0123456789+-.,ed");
  if (letter == setting.number.npos || letter == 0 || !read_unit(setting.number.substr(letter))) return;
  setting.after = setting.number.substr(letter);
  setting.number = setting.number.substr(0, letter);
}

/// What follows the place where a key ends. A comma between digits is a decimal point.
Setting setting_at(std::string_view rest) {
  Setting setting;
  rest = trimmed(rest);
  setting.unit_before = take_bracket(rest);
  const std::size_t number = std::min(rest.find_first_not_of(" \t=:;,\""), rest.size());
  setting.signed_before = rest.substr(0, number).find_first_of("=:;") != rest.npos;
  rest.remove_prefix(number);
  setting.number = rest.substr(0, rest.find_first_of(" \t,;)(]["));
  const std::string_view tail = rest.substr(setting.number.size());
  setting.after = trimmed(tail);
  if (tail.size() > 1 && tail[0] == ',' && is_digit(tail[1]) &&
      setting.number.find_first_not_of("0123456789") == rest.npos) {
    const std::size_t digits = std::min(tail.find_first_not_of("0123456789", 1), tail.size());
    setting.number = rest.substr(0, setting.number.size() + digits);
    setting.after = trimmed(tail.substr(digits));
  }
  part_unit(setting);
  return setting;
}

/// Whether a place begins a text, or what signs part: "frame rate" is no rate of samples.
bool begins_part(std::string_view plain, std::size_t at) {
  const std::size_t before = at == 0 ? plain.npos : plain.find_last_not_of(" \t\"", at - 1);
  return before == plain.npos || std::string_view(",;#%!*/([").find(plain[before]) != plain.npos;
}

/// Whether the word before a place makes a step one of something else than the numbers: "raw sampling rate",
/// "solver time step", "max dt".
bool is_qualified(std::string_view plain, std::size_t at) {
  const auto before = words(plain.substr(0, at), ",;:=()[]#%.");
  return !before.empty() && is_of(before.back(), Topic::step_of_others);
}

std::vector<Setting> settings_after(std::string_view plain, std::string_view key, bool needs_sign) {
  std::vector<Setting> found;
  for (std::size_t from = plain.find(key); from != plain.npos; from = plain.find(key, from + 1)) {
    const std::size_t end = from + key.size();
    if ((from > 0 && goes_on_at(plain, from - 1)) || goes_on_at(plain, end)) continue;
    if (is_qualified(plain, from)) continue;
    const Setting setting = setting_at(plain.substr(end));
    if (!needs_sign || (setting.signed_before && begins_part(plain, from))) found.push_back(setting);
  }
  return found;
}

/// A decimal point, or a comma in its place; one that may part thousands is neither.
double plain_number(const Cursor& cursor, std::string_view field) {
  const std::size_t comma = field.find(',');
  constexpr std::size_t thousands = 3;  // digits after the comma
  if (comma != field.npos && field.front() != '0' && comma <= thousands &&
      field.size() - comma - 1 == thousands && field.find_first_not_of("0123456789,") == field.npos)
    cursor.fail(in_quotes(field) +
                ": its comma may be a decimal point, or part thousands: must be written without");
  std::string text(field);
  std::ranges::replace(text, ',', '.');
  return number(cursor, text);
}

/// The unit that follows a number, none where nothing does that could be one: a sign, a number, or another
/// setting. @throws InputError where a word does that is no unit of a step or a rate.
std::optional<Unit> unit_after(const Cursor& cursor, std::string_view after) {
  if (after.starts_with('(') || after.starts_with('[')) after.remove_prefix(1);
  const bool range = after.starts_with("..") || after.starts_with("to ") || after.starts_with("\u2026");
  const bool fraction = after.substr(0, after.find_first_of(" \t")).find('/') != after.npos;
  if (after.empty() ||
      (!range && !fraction && std::string_view(",;.:=#%\"|-)]0123456789").find(after.front()) != after.npos))
    return std::nullopt;
  const Found found = unit_at(after, 0);
  const bool known =
      found.unit && (found.unit->quantity == Quantity::time || found.unit->quantity == Quantity::frequency);
  const std::string_view rest = known ? trimmed(after.substr(found.text.size())) : after;
  if (known && !rest.starts_with("for ")) return found.unit;
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t,;)]="));
  if (is_of(folded(word), Topic::second)) return read_unit("s");
  const std::string_view sign = trimmed(rest.substr(word.size()));
  const bool setting = word.ends_with(':') || sign.starts_with('=') || sign.starts_with(':');
  if (!range && (setting || is_of(folded(word), Topic::channel) || word == "npts" || word == "and"))
    return std::nullopt;
  cursor.fail(in_quotes(rest.substr(0, rest.find_first_of(",;"))) +
              " after a time step or rate is no unit of one: must be s, ms, min or Hz");
}

/// The step that a number and its unit give; where none is named, of a rate in Hz, of a step in s.
double interval_of(const Cursor& cursor, const Setting& setting, bool rate) {
  const double value = plain_number(cursor, setting.number);
  std::optional<Unit> unit = read_unit(setting.unit_before);
  if (!setting.unit_before.empty() && !unit)
    cursor.fail(in_quotes(setting.unit_before) +
                " is no unit of a time step or rate: must be s, ms, min or Hz");
  if (const std::optional<Unit> named = unit_after(cursor, setting.after)) unit = named;
  if (unit && unit->quantity == Quantity::time) return checked_interval(cursor, value * unit->factor);
  if (unit && unit->quantity == Quantity::frequency)
    return checked_interval(cursor, 1 / (value * unit->factor));
  return checked_interval(cursor, rate ? 1 / value : value);
}

/// Whether a number is that of a word, "f = 2 Hz"; "output rate: 100 Hz" is one of samples.
bool is_of_another(std::string_view plain, std::string_view number) {
  const std::string_view before =
      trimmed(plain.substr(0, static_cast<std::size_t>(number.data() - plain.data())));
  return (before.ends_with('=') || before.ends_with(':')) &&
         !trimmed(before.substr(0, before.size() - 1)).ends_with("rate");
}

/// Rates that a line names beside its step must be that of the step, but those of filters.
void check_rates(const Cursor& cursor, std::string_view plain, Header& header) {
  const auto names = [&](std::string_view word) { return plain.find(word) != plain.npos; };
  if (std::ranges::any_of(words_of(Topic::filter), names)) return;
  const auto list = words(plain, ",;:=()[]");
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!is_numeric(list[k]) || is_of_another(plain, list[k])) continue;
    const std::size_t letter = std::min(list[k].find_first_not_of("0123456789+-."), list[k].size());
    const bool apart = letter == list[k].size();
    if (apart && k + 1 == list.size()) continue;
    const auto unit = read_unit(apart ? list[k + 1] : list[k].substr(letter));
    if (!unit || unit->quantity != Quantity::frequency || list[k].find('-', 1) != plain.npos) continue;
    note_interval(cursor,
                  checked_interval(cursor, 1 / (number(cursor, list[k].substr(0, letter)) * unit->factor)),
                  header);
  }
}

void read_intervals(const Cursor& cursor, std::string_view plain, bool required, Header& header) {
  const std::size_t before = header.interval_line;
  for (const auto& [topic, rate, needs_sign] : keys)
    for (const std::string_view key : words_of(topic))
      for (const Setting& setting : settings_after(plain, key, needs_sign))
        if (!setting.number.empty() && (required || is_numeric(setting.number)))
          note_interval(cursor, interval_of(cursor, setting, rate), header);
  if (header.interval_line != before) check_rates(cursor, plain, header);
}

/// "NPTS=  4000, DT= .01000 SEC", or the older "4000  .01000  NPTS, DT", in either order.
void read_count(const Cursor& cursor, std::string_view line, Header& header) {
  const std::string plain = folded(line);
  const auto fields = words(line, ",=:");
  header.count_line = cursor.line_number();
  if (is_numeric(fields.front()) && fields.size() > 2) {
    const bool count_first = plain.find("npts") < plain.find("dt");
    header.count = count(cursor, fields[count_first ? 0 : 1]);
    note_interval(cursor, checked_interval(cursor, number(cursor, fields[count_first ? 1 : 0])), header);
    return;
  }
  header.count = count(cursor, field_after(line, "npts"));
  read_intervals(cursor, plain, true, header);
}

}  // namespace

void note_interval(const Cursor& cursor, double interval, Header& header) {
  constexpr double rounding = 1e-9;
  if (header.interval && std::abs(*header.interval - interval) > rounding * interval) {
    const bool same = header.interval_line == cursor.line_number();
    cursor.fail(same ? "names two time steps, " + number_text(*header.interval) + " s and " +
                           number_text(interval) + " s: must be that of the numbers below alone"
                     : "names another time step than a line before");
  }
  if (!header.interval) header.interval = interval;
  header.interval_line = cursor.line_number();
}

void read_steps(const Cursor& cursor, const Line& line, bool may_count, Header& header) {
  const bool comment = trimmed(line.text).find_first_of("#%!/;") == 0;
  if (header.count == 0 && may_count && contains(line.text, "npts") && !comment)
    return read_count(cursor, line.text, header);
  read_intervals(cursor, folded(line.text), false, header);
}

}  // namespace rockstack::records
