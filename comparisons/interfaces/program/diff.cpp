#include "comparisons/interfaces/program/change_report.hpp"
#include "comparisons/measures/results/files.hpp"

#include <fmt/format.h>

namespace rockstack {
namespace {

struct DiffArguments {
  std::filesystem::path old_results, new_results;
  std::filesystem::path out;  ///< empty: nothing is written
  ChangeArguments change;
};

void require_factor(const char* option, const std::optional<double>& value) {
  if (value && !(*value >= 1 && *value <= 1e6))
    throw InputError(fmt::format("{} = {}: must be a number from 1 to 1e6", option, *value));
}

void write_tables(const ResultsChange& result, const std::filesystem::path& out, const Common& common) {
  Json json = changes_json(result);
  json["command"] = common.command;
  write_file(out / "diff.csv", changes_csv(result));
  json["title"] = "New results beside old ones";
  json["tables"] = {"diff.csv"};
  write_file(out / "diff.json", json.dump(2) + "\n");
}

int run_diff(const DiffArguments& arguments, const Common& common) {
  refuse_overrides(common, "results are held together as they are");
  const ChangeOptions& options = arguments.change.options;
  read_upper_bounds(arguments.change);
  require_factor("--factor", options.single);
  require_factor("--cost", options.cost);
  const RecordedResults before = read_recorded_results(arguments.old_results),
                        now = read_recorded_results(arguments.new_results);
  const ResultsChange result = hold_against(before, now, options);
  save_results(now, arguments.change);
  std::optional<ResultsFolder> folder;
  if (!arguments.out.empty()) {
    folder.emplace(arguments.out, Results::diff);
    write_tables(result, arguments.out, common);
  }
  const int code = report_change(result, now, arguments.change, common, Json::object(), [&] {
    if (!arguments.out.empty()) fmt::print("results: {}\n", one_line(arguments.out.string()));
  });
  if (!arguments.out.empty()) show_report(arguments.out, common);
  return code;
}

void add_diff(CLI::App& command, DiffArguments& arguments) {
  ChangeOptions& options = arguments.change.options;
  command
      .add_option("old", arguments.old_results,
                  "folder with the results of before, or a baseline in one file")
      ->required();
  command.add_option("new", arguments.new_results, "folder with the new results, or one file")->required();
  add_change_options(command, arguments.change);
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
  return with_tables(make_command(
      "diff",
      "hold two results of `compare` against each other; exit code 1: something got worse, 3: undecided",
      add_diff, run_diff));
}

}  // namespace rockstack
