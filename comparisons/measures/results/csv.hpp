#pragma once

#include <fmt/compile.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ranges>
#include <type_traits>

#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {

/// A small file of comma-separated values as text: one name a column, one vector of cells a row.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows = {};
};

/// Reads a file of comma-separated values with a header line; cells may be quoted, and hold no line breaks.
/// @throws InputError with file:line: missing or empty file, a row with too many or too few cells, an open
/// quote.
Table read_table(const std::filesystem::path& file);

/// One line of a file after the other, whose columns are found by their names. All throw InputError as
/// read_table(), and naming file, line and column of what is missing or malformed.
class CsvLine {
 public:
  using Indices = std::vector<std::size_t>;  ///< of columns

  /// Stands at the header.
  explicit CsvLine(const std::filesystem::path& file);

  /// Goes on to the next line; false at the end.
  bool next();

  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& name) const;
  std::size_t index(const std::string& name) const;
  Indices indices(const std::vector<std::string>& names) const;

  const std::vector<std::string>& cells() const { return cells_; }
  const std::string& text(std::size_t index) const { return cells_[index]; }
  const std::string& text(const std::string& name) const { return text(index(name)); }
  double value(std::size_t index) const;  ///< NaN where the cell is empty
  double value(const std::string& name) const { return value(index(name)); }
  std::optional<double> known(std::size_t index) const;
  int whole(std::size_t index, int least, int most) const;
  /// Adds the numbers of some columns to a list.
  void add(const Indices& columns, std::vector<double>& list) const;
  /// What `read` makes of a text, where it does not throw std::invalid_argument.
  template <class Read>
  auto named(std::size_t index, const Read& read) const {
    try {
      return read(text(index));
    } catch (const std::invalid_argument& error) {
      throw InputError(place() + ": " + names_[index] + " = " + error.what());
    }
  }

 private:
  std::string place() const;

  std::filesystem::path file_;
  std::ifstream in_;
  std::string line_;
  std::vector<std::string> names_, cells_;
  std::size_t number_ = 0;
};

/// Reads only the named columns, each as one vector of numbers; an empty cell is NaN. Meant for long files.
/// @throws InputError as read_table(), and for a missing column or a cell that is not a number.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<std::string>& names);

/// The names `stem`1 … `stem`count, e.g. theta_1, theta_2.
std::vector<std::string> numbered(const std::string& stem, int count);

/// Numbered names of several stems in turn: x_1, y_1, x_2, y_2.
std::vector<std::string> numbered_in_turn(const std::vector<std::string>& stems, int count);

/// A cell as a number, none where it is something else.
std::optional<double> number_in(std::string_view cell);

/// Comma-separated values as text that grows cell by cell. Numbers read back to the same double; texts are
/// quoted and guarded where they have to be, line breaks in them are blanks; an empty optional is an empty
/// cell, and a range is a cell an element.
class CsvWriter {
 public:
  template <class... Cells>
  void add(const Cells&... cells) {
    (add_one(cells), ...);
  }

  void end_line();

  template <class... Cells>
  void line(const Cells&... cells) {
    add(cells...);
    end_line();
  }

  const std::string& text() const { return text_; }

 private:
  template <class Cell>
  void add_one(const Cell& cell) {
    if constexpr (std::is_arithmetic_v<Cell>) {
      separate();
      std::array<char, 32> digits;  // the longest number that round-trips has 24
      text_.append(digits.data(), fmt::format_to(digits.data(), FMT_COMPILE("{}"), cell));
    } else if constexpr (std::is_convertible_v<const Cell&, std::string_view>) {
      write(cell);
    } else if constexpr (std::ranges::range<Cell>) {
      for (const auto& element : cell) add_one(element);
    } else if (cell) {
      add_one(*cell);
    } else {
      write("");
    }
  }

  void write(std::string_view text);
  void separate();

  std::string text_;
  bool begun_ = false;  ///< whether the line under way has a cell
};

}  // namespace rockstack
