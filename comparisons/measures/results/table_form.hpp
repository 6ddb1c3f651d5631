#pragma once

#include <array>
#include <string>
#include <vector>

namespace rockstack {

/// In which form a table is printed.
enum class TableForm {
  text,      ///< columns of letters, for a terminal
  markdown,  ///< pipes, as GitHub shows them
  latex,     ///< a tabular with the rules of booktabs
};

/// As options have them.
inline constexpr std::array table_form_names{"text", "md", "tex"};

/// @throws InputError for a name that is none of them.
TableForm named_table_form(const std::string& name);

/// A line of a table, cell by cell. A line may end before its table's last columns.
using TableCells = std::vector<std::string>;

/// A column of a table whose lines are printed one after the other.
struct TableColumn {
  std::string heading;
  std::size_t width = 0;  ///< least, of text, in letters
  bool right = false;     ///< whether its cells stand at its right side
  std::size_t gap = 1;    ///< blanks before it, of text
};

// Parts of a table, each with its line breaks.
std::string table_head(const std::vector<TableColumn>& columns, TableForm form);
std::string table_line(const std::vector<TableColumn>& columns, const TableCells& cells, TableForm form);
std::string table_foot(TableForm form);

/// A whole table of lines with as many cells each, the first the heading. Of text columns are as wide as
/// their cells, two blanks apart; else columns of numbers stand at their right side.
std::string table_text(const std::vector<TableCells>& lines, TableForm form);

/// A text as a cell has it: what would end the cell or change its look is escaped. In LaTeX numbers have true
/// minus signs and powers of ten, and symbols of the program's texts their macros.
std::string markdown_cell(const std::string& text);
std::string latex_cell(const std::string& text);

/// A line of a table in Markdown, of cells that are Markdown already.
std::string markdown_line(const TableCells& cells);

}  // namespace rockstack
