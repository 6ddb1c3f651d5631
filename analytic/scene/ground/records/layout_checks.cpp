#include "analytic/scene/ground/records/layout_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analytic/scene/ground/records/cells.hpp"
#include "analytic/scene/ground/records/contents.hpp"
#include "analytic/scene/ground/records/dialect.hpp"
#include "analytic/scene/ground/records/vocabulary.hpp"

namespace rockstack::records {

void check_whole(const RecordTable& table) {
  for (const Line& line : table.header)
    if (line.number > table.lines.front() && line.number < table.lines.back())
      table.cursor.fail_at(line.number, "text between the numbers: " + in_quotes(trimmed(line.text)) +
                                            "; a second series must be in a file of its own");
}

void check_commas(const RecordTable& table) {
  const auto is_cut = [](std::string_view cell) {
    return cell.size() > 1 && cell.front() == '0' && cell.find_first_not_of("0123456789") == cell.npos;
  };
  for (std::size_t k = 0; k < table.rows.size() && table.dialect.separator == ','; ++k)
    if (std::ranges::any_of(table.rows[k], is_cut))
      table.cursor.fail_at(table.lines[k],
                           "commas part columns and may be decimal points: columns must be parted by "
                           "semicolons or tabs");
}

void check_history(const RecordTable& table, const Header& header) {
  const auto is_time = [](const Title& title) {
    return title.quantity == Quantity::time && speaks_of(title.name, Topic::time);
  };
  if (header.spectrum_line == 0 || std::ranges::any_of(table.titles, is_time)) return;
  table.cursor.fail_at(
      header.spectrum_line,
      "speaks of a spectrum, which is no record: of a history the time must be named in full, as in "
      "a title \"time (s)\"");
}

void check_cards(const RecordTable& table) {
  constexpr std::size_t least = 3;                 // lines
  const std::size_t full = table.rows.size() - 1;  // the last may be shorter
  if (full < least || table.columns() < 2) return;
  for (const std::size_t column : {std::size_t{0}, table.columns() - 1}) {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < full && table.rows[k].size() > column; ++k)
      if (table.rows[k][column].find_first_not_of("0123456789") == std::string_view::npos)
        numbers.push_back(table.number_at(k, column));
    if (numbers.size() == full && counts(numbers))
      table.cursor.fail_at(table.lines.front(), table.column_name(column) +
                                                    " counts the lines: numbers of cards must be taken out");
  }
}

void check_present(const RecordTable& table, const Header& header, const std::vector<std::size_t>& columns) {
  if (!header.missing) return;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (const std::size_t column : columns)
      if (column < table.rows[row].size() && table.number_at(row, column) == *header.missing)
        table.cursor.fail_at(table.lines[row], in_quotes(table.rows[row][column]) + " marks missing data");
}

void label_labview(RecordTable& table) {
  if (table.header.empty() || !starts_with(trimmed(table.header.front().text), "labview measurement")) return;
  Cells names, units, dimensions;
  for (const Line& line : table.header) {
    const Cells cells = split(line.text, table.dialect);
    const std::string_view key = trimmed(cells.front());
    if (key == "X_Columns" && (cells.size() < 2 || trimmed(cells[1]) != "One"))
      table.cursor.fail_at(line.number, "X_Columns must be One: times in the first column, for all others");
    const Cursor cursor = table.cursor.at_line(line.number);
    if (key == "Samples" && cells.size() > 1)
      check_count(table.cursor.at_line(table.lines.back()), table.rows.size(),
                  count(cursor, trimmed(cells[1])), line.number);
    if (key == "X_Dimension") dimensions = cells;
    if (key == "Y_Unit_Label") units = cells;
    if (key != "X_Value") continue;
    names = cells;
    table.title_line = line.number;
  }
  const auto text = [](const Cells& cells, std::size_t k) {
    return k < cells.size() ? std::string(trimmed(cells[k])) : std::string();
  };
  table.titles.push_back(read_title(text(dimensions, 1) + " (s)"));
  for (std::size_t k = 1; k < table.columns(); ++k) {
    const std::string unit = text(units, k);
    table.titles.push_back(read_title(text(names, k) + (unit.empty() ? "" : " (" + unit + ")")));
  }
  table.header.clear();
}

void check_tail(const RecordTable& table) {
  constexpr std::size_t most = 3;  // lines of a summary
  std::size_t rows = 0;
  for (const Line& line : table.header) {
    if (line.number < table.lines.back()) continue;
    const Cells cells = split(uncommented(line.text), table.dialect);
    if (cells.size() != table.columns() || cells.size() < 2) continue;
    rows += std::ranges::any_of(cells, is_numeric) ? 1 : 0;
    if (is_numeric(cells.front()) || rows > most)
      table.cursor.fail_at(line.number, "a row with text or a comment's sign below the numbers: " +
                                            in_quotes(trimmed(line.text)));
  }
}

void check_thousands(const RecordTable& table, std::size_t column) {
  constexpr std::size_t digits = 3;
  std::size_t marked = 0, plain = 0;
  for (const auto& row : table.rows) {
    if (row.size() <= column) break;
    std::string_view cell = row[column];
    cell.remove_prefix(cell.starts_with('-') || cell.starts_with('+') ? 1 : 0);
    const std::size_t mark = std::min(cell.find_first_of(".,"), cell.size());
    if (mark > digits || cell.find_first_not_of("0123456789.,") != cell.npos) return;
    if (mark == cell.size()) {
      ++plain;
    } else {
      if (cell.front() == '0' || mark == 0 || cell.size() - mark - 1 != digits) return;
      ++marked;
    }
  }
  if (marked > 0 && plain > 0)
    table.cursor.fail_at(table.lines.front(),
                         table.column_name(column) +
                             ": its points or commas may part thousands: must be taken out, or all numbers "
                             "have decimals");
}

void check_marks(const RecordTable& table, std::size_t column) {
  std::size_t last = 0, times = 0;
  double most = 0, next = 0;  // the largest, and the largest of all others
  for (std::size_t k = 0; k < table.rows.size() && column < table.rows[k].size(); ++k) {
    const double size = std::abs(table.number_at(k, column));
    if (size > most) {
      next = std::exchange(most, size);
      times = 0;
    }
    if (size < most) next = std::max(next, size);
    if (size < most) continue;
    ++times;
    last = k;
  }
  const std::string_view cell = times > 1 ? table.rows[last][column] : std::string_view();
  const auto nines = std::ranges::count(cell, '9');
  if (nines > 1 && cell.find_first_not_of("-+9.,0") == cell.npos && next > 0 && most > 2 * next)
    table.cursor.fail_at(table.lines[last], in_quotes(cell) + " comes " + std::to_string(times) +
                                                " times and marks missing data, it seems: must be taken out");
}

void unfold_pairs(RecordTable& table) {
  const std::size_t columns = table.rows.empty() ? 0 : table.columns();
  if (!table.titles.empty() || columns < 4 || columns % 2 != 0 || table.rows.size() < 2) return;
  RecordTable pairs = table;
  pairs.rows.clear();
  pairs.lines.clear();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto& cells = table.rows[row];
    const bool last = row + 1 == table.rows.size();
    if (cells.size() % 2 != 0 || !(cells.size() == columns || (last && cells.size() < columns))) return;
    for (std::size_t k = 0; k < cells.size(); k += 2) {
      pairs.rows.push_back({cells[k], cells[k + 1]});
      pairs.lines.push_back(table.lines[row]);
    }
  }
  if (rises_evenly(pairs.column(0))) table = std::move(pairs);
}

}  // namespace rockstack::records
