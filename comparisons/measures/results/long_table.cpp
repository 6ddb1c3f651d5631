#include "comparisons/measures/results/long_table.hpp"

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

bool is_npz(const std::filesystem::path& file) {
  return file.extension() == ".npz";
}

void add_cell(CsvWriter& csv, const FileColumn& column, std::size_t row) {
  if (const auto* number = std::get_if<FileColumn::Number>(&column.cell))
    csv.add(number_text((*number)(row)));
  if (const auto* count = std::get_if<FileColumn::Count>(&column.cell)) csv.add((*count)(row));
  if (const auto* text = std::get_if<FileColumn::Text>(&column.cell)) csv.add((*text)(row));
}

}  // namespace

std::filesystem::path table_file(const std::filesystem::path& csv) {
  std::filesystem::path npz = csv;
  npz.replace_extension(".npz");
  return std::filesystem::exists(npz) && !std::filesystem::exists(csv) ? npz : csv;
}

void write_table(const std::filesystem::path& file, const std::vector<FileColumn>& columns,
                 std::size_t rows) {
  if (is_npz(file)) return write_npz(file, columns, rows);
  write_file(file, [&](const Sink& put) {
    constexpr std::size_t rows_at_once = 1000;
    CsvWriter header;
    header.line(mapped(columns, &FileColumn::name));
    put(header.text());
    for (std::size_t row = 0; row < rows;) {
      CsvWriter csv;
      for (const std::size_t end = std::min(rows, row + rows_at_once); row < end; ++row) {
        for (const FileColumn& column : columns) add_cell(csv, column, row);
        csv.end_line();
      }
      put(csv.text());
    }
  });
}

std::vector<std::string> column_names(const std::filesystem::path& csv) {
  const std::filesystem::path file = table_file(csv);
  return is_npz(file) ? npz_names(file) : CsvLine(file).names();
}

TableRows::TableRows(const std::filesystem::path& csv, const std::vector<std::string>& names) {
  const std::filesystem::path file = table_file(csv);
  if (is_npz(file)) {
    columns_.reserve(names.size());
    for (const std::string& name : names) columns_.emplace_back(file, name);
  } else {
    line_.emplace(file);
    indices_ = line_->indices(names);
  }
}

bool TableRows::next() {
  if (line_) return line_->next();
  const auto ended = std::ranges::count_if(columns_, [](NpzColumn& column) { return !column.next(); });
  return ended == 0;
}

std::vector<std::vector<double>> table_columns(const std::filesystem::path& csv,
                                               const std::vector<std::string>& names) {
  std::vector<std::vector<double>> columns(names.size());
  for (TableRows row(csv, names); row.next();)
    for (std::size_t i = 0; i < names.size(); ++i) columns[i].push_back(row.value(i));
  return columns;
}

}  // namespace rockstack
