#pragma once

#include <cstddef>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>

namespace rockstack {

/// Comma-separated values as text that grows cell by cell. Numbers read back to the same double; texts are
/// quoted and guarded where they have to be, line breaks in them are blanks; an empty optional is an empty
/// cell, and a range is a cell an element.
class CsvWriter {
 public:
  /// Adds cells to the line under way.
  template <class... Cells>
  void add(const Cells&... cells) {
    (add_one(cells), ...);
  }

  void end_line();

  /// Adds cells and ends the line.
  template <class... Cells>
  void line(const Cells&... cells) {
    add(cells...);
    end_line();
  }

  const std::string& text() const { return text_; }

 private:
  template <class Cell>
  void add_one(const Cell& cell) {
    if constexpr (std::is_same_v<Cell, bool>) {
      write(std::string_view(cell ? "true" : "false"));
    } else if constexpr (std::is_integral_v<Cell>) {
      write(static_cast<std::ptrdiff_t>(cell));
    } else if constexpr (std::is_floating_point_v<Cell>) {
      write(static_cast<double>(cell));
    } else if constexpr (std::is_convertible_v<const Cell&, std::string_view>) {
      write(std::string_view(cell));
    } else if constexpr (std::ranges::range<Cell>) {
      for (const auto& element : cell) add_one(element);
    } else if (cell) {
      add_one(*cell);
    } else {
      write(std::string_view());
    }
  }

  void write(double number);
  void write(std::ptrdiff_t number);
  void write(std::string_view text);
  void separate();

  std::string text_;
  bool begun_ = false;  ///< whether the line under way has a cell
};

}  // namespace rockstack
