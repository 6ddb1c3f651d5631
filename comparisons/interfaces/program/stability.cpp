#include "comparisons/studies/stability/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

void print_verdicts(const std::vector<StabilityRun>& rows, const std::filesystem::path& out,
                    const Common& common) {
  if (common.quiet) return;
  std::map<std::string, int> counts{{"sound", 0}, {"inexact", 0}, {"unstable", 0}, {"failed", 0}};
  for (const StabilityRun& row : rows) {
    if (row.row.dt) ++counts[name(row.verdict.soundness)];
  }
  if (common.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"verdicts", counts}, {"folder", out.string()}}.dump(2));
    return;
  }
  for (const auto& [verdict, count] : counts) fmt::print("{:>6} runs {}\n", count, verdict);
  fmt::print("{}\n{}\n", (out / "stability.csv").string(), (out / "steps.csv").string());
}

}  // namespace

int stability_command(const std::filesystem::path& file, const std::filesystem::path& out, Executor& executor,
                      int draws, const Common& common) {
  StabilityStudy study = read_stability_study(file, common.overrides);
  if (draws > 0) set_runs(study.suite.draws, draws);
  require_comparable({study.suite});
  const ResultsFolder folder(out, Results::stability);
  const std::vector<StabilityRun> rows =
      run_stability(study, out, executor, {.command = common.command, .progress = progress(common)});
  print_verdicts(rows, out, common);
  show_report(out, common);
  const auto failed = std::count_if(
      rows.begin(), rows.end(), [](const StabilityRun& row) { return row.row.status != RunStatus::done; });
  return end_of_runs(static_cast<std::size_t>(failed), rows.size(), "stability.csv");
}

}  // namespace rockstack
