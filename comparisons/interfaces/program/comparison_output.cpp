#include "comparisons/interfaces/program/comparison_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/output.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/verdict/outcome.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* line_format = "{:>7} {:1} {:<36} {:>19} {:>10} {:>10} {:>9}  {}\n";

/// A number of thousandths with three digits, and no more than four behind the point: "0.0012", "12.3", "0".
std::string thousandths(double value) {
  const double shown = 1e3 * value;
  constexpr double least = 5e-5;
  if (std::abs(shown) < least) return "0";
  const int digits = std::clamp(2 - static_cast<int>(std::floor(std::log10(std::abs(shown)))), 0, 4);
  return fmt::format("{:.{}f}", shown, digits);
}

std::string shown_or_blank(const std::optional<double>& value) {
  return value ? thousandths(*value) : "";
}

std::string angles(const RunMetrics& row) {
  const std::string quartiles = row.rms_angle_difference_lower
                                    ? fmt::format(" ({}-{})", thousandths(*row.rms_angle_difference_lower),
                                                  thousandths(*row.rms_angle_difference_upper))
                                    : "";
  return shown_or_blank(row.rms_angle_difference) + quartiles;
}

std::string signed_or_blank(const std::optional<double>& value) {
  return value ? (*value > 0 ? "+" : "") + thousandths(*value) : "";
}

/// Of one scene and step. Where nothing is told apart none is marked.
void print_engine_rows(const std::vector<RunMetrics>& rows) {
  const bool told =
      std::any_of(rows.begin(), rows.end(), [](const RunMetrics& row) { return row.rank.value_or(1) > 1; });
  for (const RunMetrics& row : rows)
    fmt::print(line_format, shown_or_blank(row.dt), told && row.rank == 1 ? "*" : "", set_name(row),
               angles(row), shown_or_blank(row.rms_position_difference),
               signed_or_blank(row.first_impact_time_difference),
               shown_or_blank(row.stepping_time_minimum) + (row.timed_cold ? " cold" : ""), row.outcome);
}

/// What there is to know of a scene before its engines.
void print_exact_rows(const std::vector<RunMetrics>& rows) {
  for (const RunMetrics& row : rows) {
    if (row.engine != "exact") {
      fmt::print("{:>9} {:<36} {:>19}\n", "", "exact, " + row.engine,
                 shown_or_blank(row.rms_angle_difference));
      continue;
    }
    fmt::print("\n{}, law {}: ", row.scene, row.law);
    if (row.status != RunStatus::done) {
      fmt::print("no exact motion: {}\n", row.reason);
      continue;
    }
    fmt::print("{}, {} with chatter; can be compared up to {}; solved in {}\n",
               counted(static_cast<std::size_t>(row.impacts.value_or(0)), "impact"),
               row.impacts.value_or(0) + row.slower_impacts.value_or(0),
               quantity_text(row.horizon.value_or(0), "s"),
               quantity_text(row.stepping_time_minimum.value_or(0), "s"));
    fmt::print(line_format, "step ms", "", "engine:solver (set)", "angles mrad", "centres mm", "impact ms",
               "time ms", "outcome");
  }
}

bool is_printed(const Common& common) {
  return !common.quiet && !common.json;
}

}  // namespace

void print_legend(const std::vector<Suite>& suites, const Common& common) {
  if (!is_printed(common)) return;
  int replicates = 1, finest = 0;
  for (const Suite& suite : suites) {
    replicates = std::max(replicates, suite.draws.runs);
    finest = std::max(finest, suite.draws.finest);
  }
  const std::string fewer = finest > 0 ? fmt::format(", {} at the finest step", finest) : "";
  fmt::print(
      "angles, centres: RMS differences from the exact motion up to the horizon{}\n"
      "impact: the first one, engine less exact; time: the shortest wall time of stepping (cold: before the "
      "engine's runtime was warm)\n"
      "*: nearest of its scene and step; those that share it cannot be told apart, and none has it where no "
      "row can\n",
      replicates > 1 ? fmt::format(", medians of {} replicates{} (quartiles)", replicates, fewer) : "");
  std::fflush(stdout);
}

std::function<void(const std::vector<RunMetrics>&)> row_printer(const Common& common) {
  if (!is_printed(common)) return [](const std::vector<RunMetrics>&) {};
  return [&common](const std::vector<RunMetrics>& rows) {
    clear_progress(common);
    if (!rows.empty() && !is_engine(rows.front())) {
      print_exact_rows(rows);
    } else {
      print_engine_rows(rows);
    }
    std::fflush(stdout);
  };
}

void print_comparison(const CompareResult& result, const std::filesystem::path& folder,
                      const Common& common) {
  if (common.json) {
    Json rows = Json::array();
    for (const RunMetrics& row : result.rows) rows.push_back(metrics_json(row));
    fmt::print(
        "{}\n",
        Json{{"headline", result.verdict.headline}, {"rows", rows}, {"folder", folder.string()}}.dump(2));
    return;
  }
  if (common.quiet) return;
  fmt::print("\n");
  if (std::any_of(result.rows.begin(), result.rows.end(),
                  [](const RunMetrics& row) { return row.runs_at_a_time.value_or(1) > 1; }))
    fmt::print("times are those of runs that shared the machine\n");
  if (result.reused > 0) fmt::print("{} of {} runs were there already\n", result.reused, result.rows.size());
  for (const std::string& name : engines_left_out()) fmt::print("left out of this build: {}\n", name);
  fmt::print("results: {}\n\n", folder.string());
  for (const std::string& sentence : result.verdict.headline) fmt::print("{}\n", sentence);
}

}  // namespace rockstack
