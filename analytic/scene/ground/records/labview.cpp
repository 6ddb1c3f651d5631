#include "analytic/scene/ground/records/dialect.hpp"
#include "analytic/scene/ground/records/layout_checks.hpp"

namespace rockstack::records {

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

}  // namespace rockstack::records
