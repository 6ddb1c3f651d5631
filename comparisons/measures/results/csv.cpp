#include "comparisons/measures/results/csv.hpp"

#include <charconv>
#include <cmath>
#include <limits>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

using Cells = std::vector<std::string>;

/// Whether a spreadsheet would take a text, not numbers alone, for something to compute, or for one that is
/// guarded against that: it is written behind a ', which reading takes off again.
bool needs_guard(std::string_view text) {
  if (text.starts_with('\'')) return needs_guard(text.substr(1));
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos &&
         text.find_first_not_of("0123456789+-.eE ") != std::string_view::npos;
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

/// Splits a line into `cells`, whose memory is used again. `where` is file:line for errors.
void split(std::string_view rest, Cells& cells, const std::string& where) {
  cells.clear();
  for (bool more = true; more;) {
    const bool is_quoted = !rest.empty() && rest.front() == '"';
    std::string& cell = cells.emplace_back(is_quoted ? take_quoted(rest, where) : "");
    const std::size_t end = std::min(rest.find(','), rest.size());
    if (is_quoted && end != 0) throw InputError(where + ": text after a closing quote");
    if (!is_quoted) cell = rest.substr(0, end);
    if (cell.starts_with('\'') && needs_guard(cell)) cell.erase(0, 1);
    more = end < rest.size();
    rest.remove_prefix(more ? end + 1 : end);
  }
}

}  // namespace

Table read_table(const std::filesystem::path& file) {
  CsvLine line(file);
  Table table{line.names(), {}};
  while (line.next()) table.rows.push_back(line.cells());
  return table;
}

CsvLine::CsvLine(const std::filesystem::path& file) : file_(file), in_(regular_file(file)) {
  if (!in_) throw InputError(file.string() + ": cannot be read");
  if (!next()) throw InputError(fmt::format("{}:1: empty; must start with a header line", file.string()));
  names_ = cells_;
}

bool CsvLine::next() {
  if (!std::getline(in_, line_)) return false;
  ++number_;
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  split(line_, cells_, place());
  if (number_ > 1 && cells_.size() != names_.size())
    throw InputError(fmt::format("{}: {} cells; must be {}", place(), cells_.size(), names_.size()));
  return true;
}

bool CsvLine::has(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::size_t CsvLine::index(const std::string& name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end()) throw InputError(fmt::format("{}:1: no column {}", file_.string(), name));
  return static_cast<std::size_t>(found - names_.begin());
}

CsvLine::Indices CsvLine::indices(const std::vector<std::string>& names) const {
  return mapped(names, [&](const std::string& name) { return index(name); });
}

double CsvLine::value(std::size_t index) const {
  if (const std::optional<double> value = number_in(text(index))) return *value;
  if (text(index).empty()) return std::numeric_limits<double>::quiet_NaN();
  throw InputError(fmt::format("{}: {} = \"{}\": must be a number", place(), names_[index], text(index)));
}

std::optional<double> CsvLine::known(std::size_t index) const {
  return text(index).empty() ? std::nullopt : std::optional(value(index));
}

int CsvLine::whole(std::size_t index, int least, int most) const {
  const double number = value(index);
  if (!(number >= least && number <= most) || number != std::floor(number))
    throw InputError(fmt::format("{}: {} = \"{}\": must be a whole number from {} to {}", place(),
                                 names_[index], text(index), least, most));
  return static_cast<int>(number);
}

void CsvLine::add(const Indices& columns, std::vector<double>& list) const {
  for (const std::size_t one : columns) list.push_back(value(one));
}

std::string CsvLine::place() const {
  return fmt::format("{}:{}", file_.string(), number_);
}

std::vector<std::vector<double>> read_columns(const std::filesystem::path& file,
                                              const std::vector<std::string>& names) {
  std::vector<std::vector<double>> columns(names.size());
  CsvLine line(file);
  const CsvLine::Indices indices = line.indices(names);
  while (line.next())
    for (std::size_t i = 0; i < names.size(); ++i) columns[i].push_back(line.value(indices[i]));
  return columns;
}

std::vector<std::string> numbered(const std::string& stem, int count) {
  return numbered_in_turn({stem}, count);
}

std::vector<std::string> numbered_in_turn(const std::vector<std::string>& stems, int count) {
  std::vector<std::string> names;
  for (int k = 1; k <= count; ++k)
    for (const std::string& stem : stems) names.push_back(stem + std::to_string(k));
  return names;
}

std::optional<double> number_in(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size() ? std::optional(value) : std::nullopt;
}

void CsvWriter::end_line() {
  text_ += '\n';
  begun_ = false;
}

void CsvWriter::separate() {
  if (begun_) text_ += ',';
  begun_ = true;
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
