#include <algorithm>
#include <cmath>
#include <iterator>

#include "analytic/scene/ground/records/cells.hpp"
#include "analytic/scene/ground/records/units.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {
namespace {

/// Titles hold no values, "units: g" and "dt = 0.01" are none, and are no words of a sentence.
bool may_be_titles(const Texts& cells) {
  return std::ranges::none_of(cells, [&](const std::string& cell) {
    if (is_of(lower(cell), Topic::small)) return true;
    const bool has_value =
        (cell.find_first_of("=:") != cell.npos && !contains(cell, "unnamed")) ||
        std::ranges::any_of(words(cell), [](auto word) { return is_numeric(word) && contains(word, "."); });
    if (has_value || !is_numeric(cell)) return has_value;
    const Title title = read_title(cell);  // "10 x acc (g)" is one
    return !title.unit && !title.scaled;
  });
}

bool is_known(const Title& title) {
  return title.quantity || title.unit || title.spectral || title.other || !title.unknown_unit.empty();
}

/// A unit without a name, but of angles and "seconds", "millis": these are names, too.
bool is_unit_alone(const Title& title) {
  return title.unit && title.name == title.text && title.unit->quantity != Quantity::angle &&
         !speaks_of(title.text, Topic::time);
}

/// A row of units has one in each cell, with or without brackets, or nothing.
std::optional<std::vector<Title>> units_in(const Line& line, std::size_t columns, const Dialect& dialect) {
  const auto cells = cells_of(line.text, columns, dialect);
  if (!cells) return std::nullopt;
  std::vector<Title> units;
  for (const std::string& cell : *cells) {
    const bool bracket = last_bracket(cell) == 0;
    const std::string text(bracket ? trimmed(std::string_view(cell).substr(1, cell.size() - 2)) : cell);
    Title title{text, text, read_unit(text)};
    if (!title.unit && (resembles_unit(text) || is_other_unit(text))) title.unknown_unit = text;
    const bool nothing =
        text.empty() || text == "-" || text == "TS" || text == "RN";  // of loggers: time, row
    if (!title.unit && title.unknown_unit.empty() && !nothing) return std::nullopt;
    units.push_back(std::move(title));
  }
  const bool any = std::ranges::any_of(units, [](const Title& one) { return one.unit.has_value(); });
  return any ? std::optional(units) : std::nullopt;
}

/// Whether the numbers of the first column count the rows.
bool counts_rows(const RecordTable& table) {
  const std::vector<double> first = table.column(0, true);
  for (std::size_t k = 1; k < first.size(); ++k)
    if (first[k] != first[k - 1] + 1) return false;
  return first.front() == std::floor(first.front());
}

/// Whether times rise where titles say they are: a sentence may name quantities in another order.
bool has_rising_times(const RecordTable& table, const std::vector<Title>& titles) {
  const auto time = std::ranges::find(titles, std::optional(Quantity::time), &Title::quantity);
  if (time == titles.end()) return true;
  const std::vector<double> values = table.column(static_cast<std::size_t>(time - titles.begin()), true);
  return std::ranges::is_sorted(values);
}

std::optional<std::vector<Title>> titles_in(const Line& line, bool last, const RecordTable& table) {
  const std::size_t columns = table.columns();
  auto cells = cells_of(line.text, columns, table.dialect);
  // Tables of R have no title above the numbers of their rows.
  if (!cells && columns > 1 && counts_rows(table)) {
    cells = cells_of(line.text, columns - 1, table.dialect);
    if (cells) cells->insert(cells->begin(), "");
  }
  if (!cells || !may_be_titles(*cells)) return std::nullopt;
  std::vector<Title> titles;
  for (const std::string& cell : *cells) titles.push_back(read_title(cell));
  if (std::ranges::any_of(titles, is_unit_alone)) return std::nullopt;
  const bool sentence = contains(line.text, " in ") || !has_rising_times(table, titles);
  if ((is_comment(line.text) || columns == 1) && sentence) return std::nullopt;
  // "Sample rate 100 samples/s" is no title.
  const bool setting =
      columns == 1 && (titles[0].quantity == Quantity::time || titles[0].quantity == Quantity::frequency);
  if (setting) return std::nullopt;
  const auto known = static_cast<std::size_t>(std::ranges::count_if(titles, is_known));
  const bool names = last && !is_comment(line.text) && columns > 1;
  return known >= std::min<std::size_t>(2, columns) || names ? std::optional(titles) : std::nullopt;
}

void add_units(const RecordTable& table, std::size_t line, const std::vector<Title>& units,
               std::vector<Title>& titles) {
  for (std::size_t k = 0; k < titles.size(); ++k) {
    Title& title = titles[k];
    if (title.unit && units[k].unit && title.unit != units[k].unit)
      table.cursor.fail_at(line, "column " + std::to_string(k + 1) + " has the unit " + units[k].text +
                                     " here and another in its title \"" + title.text + "\"");
    if (units[k].unit) title.unit = units[k].unit;
    if (!title.unit) title.unknown_unit = units[k].unknown_unit;
    if (title.counts && title.unit && !title.text.empty()) title.counts = false;
    if (!title.quantity && title.unit && !title.other) title.quantity = title.unit->quantity;
    if (!units[k].text.empty()) title.text += " (" + units[k].text + ")";
  }
}

/// One letter names a quantity where another column is an acceleration by its title: "t, a, v, d".
void name_letters(std::vector<Title>& titles) {
  const auto is_acceleration = [](const Title& title) { return title.quantity == Quantity::acceleration; };
  if (std::ranges::none_of(titles, is_acceleration)) return;
  for (Title& title : titles) {
    if (title.quantity || title.unit || title.other) continue;
    const std::string text = lower(title.text);
    if (text == "v") title.quantity = Quantity::velocity;
    if (text == "d" || text == "u" || text == "x" || text == "s") title.quantity = Quantity::displacement;
  }
}

}  // namespace

void find_titles(RecordTable& table) {
  std::optional<std::pair<std::size_t, std::vector<Title>>> units;  // line among the header, and they
  const auto above = std::ranges::count_if(
      table.header, [&](const Line& line) { return line.number < table.lines.front(); });
  for (auto k = static_cast<std::size_t>(above); k-- > 0;) {
    const Line line = table.header[k];
    if (!units)
      if (auto row = units_in(line, table.columns(), table.dialect)) {
        units = {k, std::move(*row)};
        continue;
      }
    const bool last = k + 1 == static_cast<std::size_t>(above) || (units && units->first == k + 1);
    auto titles = titles_in(line, last, table);
    if (!titles) continue;
    if (units) add_units(table, table.header[units->first].number, units->second, *titles);
    table.titles = std::move(*titles);
    table.title_line = line.number;
    table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(k));
    if (units && units->first > k) --units->first;
    break;
  }
  if (table.titles.empty() && units) {
    table.title_line = table.header[units->first].number;
    for (Title& unit : units->second) {
      unit.quantity = unit.unit ? std::optional(unit.unit->quantity) : std::nullopt;
      unit.name = unit.text;
      table.titles.push_back(unit);
    }
  }
  if (units) table.header.erase(table.header.begin() + static_cast<std::ptrdiff_t>(units->first));
  name_letters(table.titles);
}

void check_titles(const RecordTable& table) {
  const auto above = [&](const Line& line) { return line.number < table.lines.front(); };
  if (!table.titles.empty() || table.header.empty() || !above(table.header.front())) return;
  const Line& line = *std::prev(std::ranges::find_if_not(table.header, above));
  for (const Texts& cells : parted(line.text, table.dialect)) {
    if (cells.size() < 2 || cells.size() == table.columns() || !may_be_titles(cells)) continue;
    const auto is_time = [](const std::string& cell) { return read_title(cell).quantity == Quantity::time; };
    const auto known =
        std::ranges::count_if(cells, [](const std::string& cell) { return is_known(read_title(cell)); });
    if (known < 2 || std::ranges::none_of(cells, is_time)) continue;
    table.cursor.fail_at(line.number, std::to_string(cells.size()) + " titles above numbers in " +
                                          std::to_string(table.columns()) + " columns: must be as many");
  }
}

}  // namespace rockstack::records
