#include "comparisons/studies/diff/changes.hpp"

#include <fmt/format.h>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

struct DiffArguments {
  std::filesystem::path old_results, new_results;
  std::filesystem::path out;  ///< empty: nothing is written
  ChangeOptions options;
};

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
std::vector<std::string> cells_of(const TurnedNumber& number) {
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

void print_turned(const std::vector<TurnedNumber>& numbers) {
  std::vector<std::vector<std::string>> lines{{"", "scene", "engine:solver", "settings", "dt (s)", "number",
                                               "old (quartiles)", "new (quartiles)", "new/old", "p-value"}};
  lines.reserve(numbers.size() + 1);
  for (const TurnedNumber& number : numbers) lines.push_back(cells_of(number));
  print_table(lines);
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

void print_change(const ResultsChange& result, const ChangeOptions& options) {
  const auto count = [&](const auto& counts) { return std::ranges::count_if(result.rows, counts); };
  const auto turned = turned_numbers(result);
  if (!turned.empty()) print_turned(turned);
  fmt::print("rows in both: {}, to the bit {}, of the nominal run alone {}; worse {}, better alone {}\n",
             result.rows.size(), count([](const RowChange& row) { return row.bits == "same"; }),
             count([](const RowChange& row) { return row.bits == "nominal"; }),
             count([](const RowChange& row) { return row.worst() == Trend::worse; }),
             count([](const RowChange& row) { return row.worst() == Trend::better; }));
  print_tests(result);
  print_singles(result, options);
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

void require_factor(const char* option, const std::optional<double>& value) {
  if (value && !(*value >= 1 && *value <= 1e6))
    throw InputError(fmt::format("{} = {}: must be a number from 1 to 1e6", option, *value));
}

int run_diff(const DiffArguments& arguments, const Common& common) {
  refuse_overrides(common, "results are held together as they are");
  const ChangeOptions& options = arguments.options;
  if (!(options.level > 0 && options.level < 1))
    throw InputError(fmt::format("--level = {}: must be a number between 0 and 1", options.level));
  require_factor("--factor", options.single);
  require_factor("--cost", options.cost);
  const RecordedResults before = read_recorded_results(arguments.old_results);
  const ResultsChange result = hold_against(before, read_recorded_results(arguments.new_results), options);
  Json json = changes_json(result);
  std::optional<ResultsFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out, Results::diff);
    json["command"] = common.command;
    write_file(arguments.out / "diff.csv", changes_csv(result));
    json["title"] = "New results beside old ones";
    json["tables"] = {"diff.csv"};
    write_file(arguments.out / "diff.json", json.dump(2) + "\n");
  }
  if (print_json(json, common)) {
    print_change(result, options);
    if (!arguments.out.empty()) fmt::print("results: {}\n", one_line(arguments.out.string()));
    fmt::print("\n{}\n", result.headline());
  }
  if (!arguments.out.empty()) show_report(arguments.out, common);
  constexpr int undecided = 3;
  return result.worse() ? 1 : result.decided() ? 0 : undecided;
}

void add_diff(CLI::App& command, DiffArguments& arguments) {
  ChangeOptions& options = arguments.options;
  command.add_option("old", arguments.old_results, "folder with the results of before")->required();
  command.add_option("new", arguments.new_results, "folder with the new results")->required();
  command
      .add_option("--level", options.level,
                  "chance that any number with replicates is reported as changed where nothing has changed")
      ->capture_default_str();
  command.add_option(
      "--factor", options.single,
      "of rows of single runs: from how many times on a number is reported as changed; left out: only "
      "failures are reported");
  command.add_option(
      "--cost", options.cost,
      "from how many times on the time of a step is reported as changed, where the repeats of both lie "
      "apart; left out: none is");
  command.add_option("--across", options.across, "what may differ between two rows that are held together")
      ->delimiter(',')
      ->check(one_of(row_names()));
  command.add_flag(
      "--common", options.common_alone,
      "ask nothing of rows that the old results alone have; left out: they leave the result undecided");
  command.add_option("--out", arguments.out, "folder for diff.json and diff.csv; left out: none are written");
}

}  // namespace

Command diff_command() {
  return make_command(
      "diff",
      "hold two results of `compare` against each other; exit code 1: something got worse, 3: undecided",
      add_diff, run_diff);
}

}  // namespace rockstack
