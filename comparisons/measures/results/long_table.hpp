#pragma once

#include <optional>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/npz.hpp"

namespace rockstack {

/// Where a table lies that is named as a .csv file: there, or, of one with many rows, as columns in the .npz
/// file beside it.
std::filesystem::path table_file(const std::filesystem::path& csv);

/// Writes a table into a .csv or an .npz file, as its name says. @throws as write_file().
void write_table(const std::filesystem::path& file, const std::vector<FileColumn>& columns, std::size_t rows);

/// The names of a table's columns. @throws InputError where there is none, or it is malformed.
std::vector<std::string> column_names(const std::filesystem::path& csv);

/// Some columns of a table, row by row, wherever it lies; numbers are the same to the bit. All throw
/// InputError naming the file and what is missing or malformed.
class TableRows {
 public:
  /// Stands before the first row.
  TableRows(const std::filesystem::path& csv, const std::vector<std::string>& names);

  bool next();  ///< false at the end

  // By the place of a name in the list.
  double value(std::size_t i) const { return line_ ? line_->value(indices_[i]) : columns_[i].value(); }
  std::string text(std::size_t i) const { return line_ ? line_->text(indices_[i]) : columns_[i].text(); }

 private:
  std::optional<CsvLine> line_;
  CsvLine::Indices indices_;
  std::vector<NpzColumn> columns_;
};

/// Whole columns of numbers, likewise.
std::vector<std::vector<double>> table_columns(const std::filesystem::path& csv,
                                               const std::vector<std::string>& names);

}  // namespace rockstack
