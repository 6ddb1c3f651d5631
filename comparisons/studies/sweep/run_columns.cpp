#include "comparisons/studies/sweep/run_columns.hpp"

#include <cmath>
#include <cstring>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/studies/sweep/make_runs.hpp"

namespace rockstack {
namespace {

/// What a run has in a column; nothing where it has none.
using RunCell = std::variant<std::monostate, double, std::size_t, std::string>;

RunCell outcome_cell(const OutcomeColumn& column, const RunResult& result) {
  const RunOutcome* outcome = result.outcome;
  if (column.name == "status") return outcome ? "done" : "failed";
  if (column.name == reason_column) return result.reason;
  if (!outcome) return {};
  if (const auto* count = std::get_if<OutcomeColumn::Count>(&column.value)) return (*count)(*outcome);
  if (const auto* mode = std::get_if<OutcomeColumn::Mode>(&column.value)) return name(outcome->**mode);
  const std::optional<double> value = std::get<OutcomeColumn::Measure>(column.value)(*outcome);
  return value ? RunCell(*value) : RunCell();
}

/// In the order of run_columns().
std::vector<RunCell> cells_of(const Ensemble& ensemble, const std::vector<OutcomeColumn>& outcomes,
                              const RunResult& result) {
  std::vector<RunCell> cells{result.run};
  cells.reserve(outcomes.size() + result.values.size() + 2);
  for (const Value& value : result.values)
    cells.push_back(value.node.kind == Node::Kind::number ? RunCell(value.node.number) : RunCell(value.text));
  if (!ensemble.summary.indices.empty()) cells.emplace_back(matrix_of(ensemble, result.run));
  for (const OutcomeColumn& column : outcomes) cells.push_back(outcome_cell(column, result));
  return cells;
}

std::string text_of(const RunCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return number_text(*number);
  if (const auto* count = std::get_if<std::size_t>(&cell)) return std::to_string(*count);
  const auto* text = std::get_if<std::string>(&cell);
  return text ? *text : "";
}

double number_of(const RunCell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  const auto* count = std::get_if<std::size_t>(&cell);
  return count ? static_cast<double>(*count) : std::nan("");
}

using RunRows = std::vector<std::vector<RunCell>>;

std::string lines_of(const RunRows& rows) {
  CsvWriter csv;
  for (const std::vector<RunCell>& cells : rows) csv.line(mapped(cells, text_of));
  return csv.text();
}

/// What stands before a column in a block of columns: its bytes as they are there, and uncompressed.
struct Packing {
  std::uint64_t packed = 0, plain = 0;
};

/// Each column by itself: numbers as they lie in memory, texts a line each.
std::string columns_of(const RunRows& rows, const std::vector<RunColumn>& columns) {
  std::string block;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::string plain;
    for (const std::vector<RunCell>& cells : rows) {
      if (columns[c].is_text) {
        std::string text = text_of(cells[c]);
        std::ranges::replace(text, '\n', ' ');
        plain += text;
        plain += '\n';
      } else {
        const double number = number_of(cells[c]);
        plain.append(reinterpret_cast<const char*>(&number), sizeof number);
      }
    }
    const std::string packed = compressed(plain);
    const Packing packing{packed.size(), plain.size()};
    block.append(reinterpret_cast<const char*>(&packing), sizeof packing);
    block += packed;
  }
  return block + "\n";
}

/// The columns of a journal's blocks, of which one of one block is in memory.
class JournalColumns {
 public:
  JournalColumns(const Journal& journal, std::size_t runs) : journal_(journal), runs_(runs) {}

  double number(std::size_t column, std::size_t run) {
    double number = 0;
    std::memcpy(&number, bytes_at(column, run).data() + run % block_size(runs_) * sizeof number,
                sizeof number);
    return number;
  }

  std::string text(std::size_t column, std::size_t run) {
    const std::string& bytes = bytes_at(column, run);
    if (run % block_size(runs_) == 0) place_ = 0;
    const std::size_t begin = place_, end = bytes.find('\n', begin);
    place_ = end + 1;
    return bytes.substr(begin, end - begin);
  }

 private:
  const std::string& bytes_at(std::size_t column, std::size_t run) {
    const std::pair wanted(column, run / block_size(runs_));
    if (wanted == held_) return bytes_;
    const std::string block = journal_.text(wanted.second);
    std::string_view rest = block;
    Packing packing;
    for (std::size_t c = 0; c <= column; ++c) {
      rest.remove_prefix(packing.packed);
      std::memcpy(&packing, rest.data(), sizeof packing);
      rest.remove_prefix(sizeof packing);
    }
    bytes_ = uncompressed(rest.substr(0, packing.packed), packing.plain);
    held_ = wanted;
    return bytes_;
  }

  const Journal& journal_;
  std::size_t runs_;
  std::pair<std::size_t, std::size_t> held_{~std::size_t{0}, 0};  ///< column and block
  std::string bytes_;
  std::size_t place_ = 0;  ///< of the next text
};

void write_failures(const std::filesystem::path& file, std::size_t runs,
                    const std::function<std::string(std::size_t run)>& reason) {
  write_file(file, [&](const Sink& put) {
    put("run," + reason_column + "\n");
    for (std::size_t run = 0; run < runs; ++run) {
      const std::string why = reason(run);
      if (why.empty()) continue;
      CsvWriter line;
      line.line(run, why);
      put(line.text());
    }
  });
}

void write_columns(const std::vector<RunColumn>& columns, const Journal& journal, std::size_t runs,
                   const std::filesystem::path& folder, const std::string& job) {
  JournalColumns blocks(journal, runs);
  std::vector<FileColumn> kept;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto text = [&blocks, c](std::size_t run) { return blocks.text(c, run); };
    const auto number = [&blocks, c](std::size_t run) { return blocks.number(c, run); };
    if (columns[c].name == reason_column)
      write_failures(folder / "failures.csv", runs, text);
    else if (columns[c].is_text)
      kept.push_back({columns[c].name, FileColumn::Text(text)});
    else
      kept.push_back({columns[c].name, FileColumn::Number(number)});
  }
  write_npz(folder / "runs.npz", kept, runs, job);
}

constexpr auto matrix_meaning =
    "a sample's inputs are those of A, of B, drawn independently, or of A with that key's value from B";

bool is_number(const Value& value) {
  return value.node.kind == Node::Kind::number;
}

}  // namespace

RunsFormat usual_format(std::size_t runs) {
  return runs > most_csv_runs ? RunsFormat::npz : RunsFormat::csv;
}

std::vector<RunColumn> run_columns(const Ensemble& ensemble) {
  std::vector<RunColumn> columns{{"run", "number of the run, from 0"}};
  for (const Variation& variation : ensemble.variations) {
    std::string meaning = "scene key";
    for (std::size_t k = 1; k < variation.keys.size(); ++k) meaning += ", also of " + variation.keys[k];
    columns.push_back({variation.name(), meaning, !std::ranges::all_of(variation.values, is_number)});
  }
  if (!ensemble.summary.indices.empty()) columns.push_back({matrix_column, matrix_meaning, true});
  for (const OutcomeColumn& column : outcome_columns(block_count(ensemble))) {
    const bool is_text = std::holds_alternative<std::monostate>(column.value) ||
                         std::holds_alternative<OutcomeColumn::Mode>(column.value);
    columns.push_back({column.name, column.meaning, is_text});
  }
  return columns;
}

std::size_t block_size(std::size_t runs) {
  constexpr std::size_t smallest = 32;  // enough to be solved side by side
  constexpr std::size_t largest = 256, fewest_blocks = 64;
  return std::clamp(runs / fewest_blocks, smallest, largest);
}

std::size_t length_of(std::size_t block, std::size_t runs) {
  return std::min(block_size(runs), runs - block * block_size(runs));
}

std::string journal_part(const Ensemble& ensemble, std::size_t block, MotionLibrary& library,
                         RunsFormat format) {
  const std::size_t runs = run_count(ensemble), first = block * block_size(runs);
  RunRows rows(length_of(block, runs));
  const std::vector<OutcomeColumn> outcomes = outcome_columns(block_count(ensemble));
  make_runs(ensemble, first, first + rows.size(), library, [&](const RunResult& result) {
    rows[result.run - first] = cells_of(ensemble, outcomes, result);
  });
  return format == RunsFormat::csv ? lines_of(rows) : columns_of(rows, run_columns(ensemble));
}

void write_runs(const Ensemble& ensemble, const Journal& journal, const std::filesystem::path& folder,
                RunsFormat format, const std::string& job) {
  const std::vector<RunColumn> columns = run_columns(ensemble);
  if (format == RunsFormat::npz) return write_columns(columns, journal, run_count(ensemble), folder, job);
  write_file(folder / "runs.csv", [&](const Sink& put) {
    CsvWriter header;
    header.line(mapped(columns, &RunColumn::name));
    put(header.text());
    journal.copy_to(put);
  });
}

std::filesystem::path failures_file(const std::filesystem::path& folder) {
  const std::filesystem::path runs = table_file(folder / "runs.csv");
  return runs.extension() == ".npz" ? folder / "failures.csv" : runs;
}

}  // namespace rockstack
