#include "comparisons/measures/results/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace rockstack {
namespace {

using Cells = std::vector<std::string>;

std::string place(const std::filesystem::path& file, std::size_t line) {
  return fmt::format("{}:{}", file.string(), line);
}

/// Takes one quoted cell from the front of `rest`, which starts with the opening quote.
std::string take_quoted(std::string_view& rest, const std::string& where) {
  std::string cell;
  for (std::size_t i = 1; i < rest.size(); ++i) {
    if (rest[i] != '"') {
      cell += rest[i];
    } else if (i + 1 < rest.size() && rest[i + 1] == '"') {
      cell += rest[++i];
    } else {
      rest.remove_prefix(i + 1);
      return cell;
    }
  }
  throw InputError(where + ": a quote is not closed");
}

/// Splits a line into `cells`, whose memory is used again.
void split(std::string_view rest, Cells& cells, const std::string& file, std::size_t line) {
  cells.clear();
  for (bool more = true; more;) {
    std::string quoted;
    const bool is_quoted = !rest.empty() && rest.front() == '"';
    if (is_quoted) quoted = take_quoted(rest, place(file, line));
    const std::size_t end = std::min(rest.find(','), rest.size());
    if (is_quoted && end != 0) throw InputError(place(file, line) + ": text after a closing quote");
    cells.push_back(is_quoted ? std::move(quoted) : std::string(rest.substr(0, end)));
    if (cells.back().starts_with('\'') && needs_guard(cells.back())) cells.back().erase(0, 1);
    more = end < rest.size();
    rest.remove_prefix(more ? end + 1 : end);
  }
}

/// Calls `header` with the names, then `row` with the cells and number of each line.
void read_rows(const std::filesystem::path& file, const std::function<void(const Cells&)>& header,
               const std::function<void(const Cells&, std::size_t line)>& row) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string() + ": cannot be read");
  std::string text;
  Cells cells;
  std::size_t width = 0;
  for (std::size_t line = 1; std::getline(in, text); ++line) {
    if (!text.empty() && text.back() == '\r') text.pop_back();
    split(text, cells, file.string(), line);
    if (line == 1) {
      width = cells.size();
      header(cells);
    } else if (cells.size() != width) {
      throw InputError(fmt::format("{}: {} cells; must be {}", place(file, line), cells.size(), width));
    } else {
      row(cells, line);
    }
  }
  if (width == 0) throw InputError(place(file, 1) + ": empty; must start with a header line");
}

}  // namespace

Table read_table(const std::filesystem::path& file) {
  Table table;
  read_rows(
      file, [&](const Cells& cells) { table.columns = cells; },
      [&](const Cells& cells, std::size_t) { table.rows.push_back(cells); });
  return table;
}

std::size_t column(const Table& table, const std::string& name, const std::filesystem::path& file) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  if (found == table.columns.end()) throw InputError(fmt::format("{}: no column {}", place(file, 1), name));
  return static_cast<std::size_t>(found - table.columns.begin());
}

void CsvLine::read(const std::function<void()>& header, const std::function<void()>& row) {
  read_rows(
      file_,
      [&](const Cells& names) {
        header_.columns = names;
        header();
      },
      [&](const Cells& cells, std::size_t number) {
        cells_ = &cells;
        number_ = number;
        row();
      });
}

bool CsvLine::has(const std::string& name) const {
  return std::ranges::find(names(), name) != names().end();
}

CsvLine::Indices CsvLine::indices(const std::vector<std::string>& names) const {
  Indices list;
  for (const std::string& name : names) list.push_back(index(name));
  return list;
}

double CsvLine::value(std::size_t index) const {
  if (const std::optional<double> value = number_in(text(index))) return *value;
  return number(text(index), place(), names()[index]);
}

std::optional<double> CsvLine::known(std::size_t index) const {
  return text(index).empty() ? std::nullopt : std::optional(value(index));
}

int CsvLine::whole(std::size_t index, int least, int most) const {
  return whole_number(text(index), place(), names()[index], least, most);
}

void CsvLine::add(const Indices& columns, std::vector<double>& list) const {
  for (const std::size_t one : columns) list.push_back(value(one));
}

std::string CsvLine::place() const {
  return rockstack::place(file_, number_);
}

std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<std::string>& names) {
  std::vector<std::vector<double>> columns(names.size());
  CsvLine line(file);
  CsvLine::Indices indices;
  line.read([&] { indices = line.indices(names); },
            [&] {
              for (std::size_t i = 0; i < names.size(); ++i) columns[i].push_back(line.value(indices[i]));
            });
  return columns;
}

std::vector<std::string> numbered(const std::string& stem, int count) {
  std::vector<std::string> names;
  for (int k = 1; k <= count; ++k) names.push_back(stem + std::to_string(k));
  return names;
}

bool needs_guard(std::string_view text) {
  if (text.starts_with('\'')) return needs_guard(text.substr(1));
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos &&
         text.find_first_not_of("0123456789+-.eE ") != std::string_view::npos;
}

std::optional<double> number_in(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size() ? std::optional(value) : std::nullopt;
}

double number(std::string_view cell, const std::string& where, const std::string& column_name) {
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::optional<double> value = number_in(cell);
  if (!value) throw InputError(fmt::format("{}: {} = \"{}\": must be a number", where, column_name, cell));
  return *value;
}

int whole_number(std::string_view cell, const std::string& where, const std::string& column_name, int least,
                 int most) {
  const double value = number(cell, where, column_name);
  if (!(value >= least && value <= most) || value != std::floor(value))
    throw InputError(fmt::format("{}: {} = \"{}\": must be a whole number from {} to {}", where, column_name,
                                 cell, least, most));
  return static_cast<int>(value);
}

void CsvWriter::end_line() {
  text_ += '\n';
  begun_ = false;
}

void CsvWriter::separate() {
  if (begun_) text_ += ',';
  begun_ = true;
}

void CsvWriter::write(double number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
}

void CsvWriter::write(std::ptrdiff_t number) {
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
}

void CsvWriter::write(std::string_view text) {
  separate();
  const char* guard = needs_guard(text) ? "'" : "";
  if (text.find_first_of(",\"\n") == std::string_view::npos) {
    text_ += guard;
    text_ += text;
    return;
  }
  text_ += '"';
  text_ += guard;
  for (const char letter : text) {
    if (letter == '"') text_ += '"';
    text_ += letter == '\n' ? ' ' : letter;
  }
  text_ += '"';
}

}  // namespace rockstack
