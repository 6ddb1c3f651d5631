#include "comparisons/interfaces/program/change_report.hpp"

#include <fmt/format.h>

#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

std::string settings_of(const RowChange& row) {
  const std::string& before = row.old_row.settings;
  const std::string& now = row.new_row.settings;
  return before == now ? before : before + " > " + now;
}

std::string spread_text(const ValueSpread& spread) {
  return spread.values > 1 ? fmt::format("{:.2e} ({:.1e}…{:.1e})", spread.median, spread.lower, spread.upper)
                           : fmt::format("{:.2e}", spread.median);
}

/// A line of the table, cell by cell.
TableCells cells_of(const TurnedNumber& number) {
  const RowChange& row = *number.row;
  const QuantityChange& change = *number.change;
  const bool all = row.old_row.scene.empty();
  return {name(change.trend),
          all ? "all" : row.old_row.scene,
          row.old_row.engine + (row.old_row.solver.empty() ? "" : ":" + row.old_row.solver),
          settings_of(row),
          all              ? "all"
          : row.old_row.dt ? fmt::format("{}", *row.old_row.dt)
                           : "",
          change.quantity,
          spread_text(change.old_values),
          spread_text(change.new_values),
          fmt::format("{:.3g}", number.ratio()),
          change.adjusted_p_value ? fmt::format("{:.0e}", *change.adjusted_p_value) : ""};
}

/// The worst first, at most so many.
void print_turned(const std::vector<TurnedNumber>& numbers, std::size_t most, TableForm form) {
  std::vector<TableCells> lines{{"", "scene", "engine:solver", "settings", "dt (s)", "number",
                                 "old (quartiles)", "new (quartiles)", "new/old", "p-value"}};
  for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i) lines.push_back(cells_of(numbers[i]));
  print_table(lines, form);
}

void print_tests(const ResultsChange& result) {
  if (result.tests > 0)
    fmt::print("numbers tested: {} ({} more could show nothing); chance of a false alarm among all: {}\n",
               result.counted, result.tests - result.counted, result.level);
}

void print_singles(const ResultsChange& result, const ChangeOptions& options) {
  const auto single = std::ranges::count_if(
      result.rows, [](const RowChange& row) { return !row.replicated && row.old_row.steps; });
  if (single == 0) return;
  if (options.single)
    fmt::print("rows of single runs: {}; a number of theirs is reported from {} times on\n", single,
               *options.single);
  else
    fmt::print(
        "rows of single runs: {}; only failures of theirs are reported, --factor F reports numbers too\n",
        single);
}

void print_names(const char* what, const std::vector<std::string>& names) {
  if (!names.empty()) fmt::print("{}: {}\n", what, fmt::join(names, "; "));
}

void print_change(const ResultsChange& result, const ChangeArguments& arguments) {
  const auto count = [&](const auto& counts) { return std::ranges::count_if(result.rows, counts); };
  if (const std::size_t turned = turned_numbers(result).size(); turned > arguments.most_lines)
    fmt::print("and {} more\n", turned - arguments.most_lines);
  fmt::print("rows in both: {}, to the bit {}, of the nominal run alone {}; worse {}, better alone {}\n",
             result.rows.size(), count([](const RowChange& row) { return row.bits == "same"; }),
             count([](const RowChange& row) { return row.bits == "nominal"; }),
             count([](const RowChange& row) { return row.worst() == Trend::worse; }),
             count([](const RowChange& row) { return row.worst() == Trend::better; }));
  print_tests(result);
  print_singles(result, arguments.options);
  if (const ValueSpread cost = cost_ratio(result); cost.values > 0)
    fmt::print("time of a step, new over old: {:.2f}, of single rows {:.2f} to {:.2f}\n", cost.median,
               cost.lower, cost.upper);
  print_names("only in the old results", result.only_old);
  print_names("only in the new results", result.only_new);
  print_names("not held together, for they ask something else", result.other_questions);
  print_names("made otherwise", result.other_environment);
  std::vector<std::string> moved;
  for (const RowChange& row : result.rows)
    if (row.old_row.engine == "exact" && row.bits == "different") moved.push_back(row.old_row.scene);
  print_names("the exact motion itself has other bits in", moved);
  print_names("looks worse, with too few replicates to decide", result.in_doubt);
  print_names("more replicates than before", result.more_failures);
  print_names("nothing can be said of", result.undecided);
}

/// Rows above a bound.
void print_bounds(const std::vector<BoundedRow>& bounds) {
  for (const BoundedRow& bound : bounds)
    if (bound.above()) fmt::print("{}: {}\n", bound.run->row.run, bound.text());
}

Json bound_json(const BoundedRow& bound) {
  return {{"run", bound.run->row.run},
          {"quantity", bound.bound->quantity->name},
          {"at_most", bound.bound->value},
          {"median", bound.median ? Json(*bound.median) : Json()},
          {"above", bound.above()}};
}

}  // namespace

void add_change_options(CLI::App& command, ChangeArguments& arguments) {
  command
      .add_option("--level", arguments.options.level,
                  "chance that any number with replicates is reported as changed where nothing has changed")
      ->capture_default_str();
  command
      .add_option(
          "--fail-above", arguments.fail_above,
          "QUANTITY=VALUE, as angles=10mrad or first-impact=5ms: exit code 1 where a new row's median is "
          "above; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--junit", arguments.junit,
                     "file for JUnit XML: a test case each row and number that counts");
  command.add_option("--markdown", arguments.markdown, "file for a summary in Markdown");
  command.add_option(
      "--save", arguments.save,
      "file for the new results, a baseline that `diff` takes as OLD and `gate` as --baseline");
}

std::vector<UpperBound> read_upper_bounds(const ChangeArguments& arguments) {
  const double level = arguments.options.level;
  if (!(level > 0 && level < 1))
    throw InputError(fmt::format("--level = {}: must be a number between 0 and 1", level));
  return mapped(arguments.fail_above, read_upper_bound);
}

void save_results(const RecordedResults& results, const ChangeArguments& arguments) {
  if (!arguments.save.empty()) write_file(arguments.save, packed_results(results));
}

int report_change(const ResultsChange& change, const RecordedResults& now, const ChangeArguments& arguments,
                  const Common& common, Json json, const std::function<void()>& more) {
  const std::vector<UpperBound> asked = read_upper_bounds(arguments);
  const std::vector<BoundedRow> bounds = bounded_rows(asked, now);
  const JudgedChange judged{change, bounds};
  if (!arguments.junit.empty()) write_file(arguments.junit, junit_xml(judged));
  if (!arguments.markdown.empty()) write_file(arguments.markdown, summary_markdown(judged));
  json.update(changes_json(change));
  json["bounds"] = mapped(bounds, bound_json);
  json["headline"] = judged.headline();
  if (const auto turned = turned_numbers(change);
      common.prints_documents() || (common.prints_text() && !turned.empty()))
    print_turned(turned, arguments.most_lines, common.table);
  if (print_json(json, common)) {
    print_change(change, arguments);
    print_bounds(bounds);
    more();
    fmt::print("\n{}\n", judged.headline());
  }
  return judged.exit_code();
}

}  // namespace rockstack
