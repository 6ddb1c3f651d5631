#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analytic/scene/ground/records/dialect.hpp"
#include "analytic/scene/ground/records/text.hpp"
#include "analytic/scene/ground/records/units.hpp"

namespace rockstack::records {

/// Title of a column: what it holds by its words and by its own unit.
struct Title {
  std::string text;
  std::string name = {};  ///< of the column alone, without its unit
  std::optional<Unit> unit = {};
  std::string unknown_unit = {};          ///< stands where the unit does, and is none
  std::optional<Quantity> quantity = {};  ///< by words, else by the unit
  bool counts = false;                    ///< numbers of samples, dates
  bool spectral = false;                  ///< of a spectrum: its periods or ordinates
  bool other = false;   ///< a force, a temperature: what no record holds, whatever unit it has
  bool scaled = false;  ///< names a factor, or says that the numbers are normalised
};

/// A text of columns. The text of the file must outlive it.
struct RecordTable {
  Cursor cursor;  ///< for errors
  Dialect dialect = {};
  std::vector<Line> header = {};   ///< lines of text, without that of titles and that of units
  std::vector<Title> titles = {};  ///< of each column, or none
  std::size_t title_line = 0;
  std::vector<std::vector<std::string_view>> rows = {};  ///< cells, at least one
  std::vector<std::size_t> lines = {};                   ///< of the rows

  std::size_t columns() const { return rows.front().size(); }
  /// Numbers of a column, times of day in s; a row that is too short ends it. Empty cells are not a number
  /// where they may be.
  /// @throws InputError at a cell that is no number.
  std::vector<double> column(std::size_t index, bool may_be_empty = false) const;
  /// @throws InputError at a row of another length than the first; the last may be shorter.
  void check_even(bool but_last) const;
  double number_at(std::size_t row, std::size_t index) const;
  /// "column 2, \"Acceleration (g)\"".
  std::string column_name(std::size_t index) const;
};

/// Whether a text begins as numbers do, right or wrong.
bool is_numeric(std::string_view word);

/// Rows and lines of text, without titles. Columns are parted by semicolons, tabs, commas or blanks; commas
/// are decimal points beside semicolons, in quotes, and beside tabs or blanks where no number has a point.
/// @throws InputError where there is no row.
RecordTable read_rows(std::string_view file, std::string_view text);

/// Finds the line of titles, and the row of units under it: the last lines above the numbers that have as
/// many cells as there are columns, and words or units that titles have.
void find_titles(RecordTable& table);

/// Refuses a line above the numbers that has titles, a time among them, but not as many as there are columns.
void check_titles(const RecordTable& table);

/// The last text in brackets, from its opening on; npos where a text ends in none.
std::size_t last_bracket(std::string_view text);

/// Units of what no record holds, and of numbers without one.
bool is_other_unit(std::string_view text);

/// Reads the title of one column.
Title read_title(std::string_view text);

/// The table of a file that has columns of these names, with or without their units. Where no titles that are
/// found so have them, the first line that has them between semicolons, tabs or commas is that of titles, and
/// cells of other columns may be texts.
/// @throws InputError where there is no row.
RecordTable read_titled(std::string_view file, std::string_view text, const std::vector<std::string>& names);

}  // namespace rockstack::records
