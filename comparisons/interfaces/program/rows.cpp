#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

/// `width`: of names, in letters.
std::vector<TableColumn> row_columns(std::size_t width) {
  return {{"step ms", 7, true, 0},   {"engine:solver (set)", width, false, 3},
          {"angles mrad", 19, true}, {"centres mm", 10, true},
          {"impact ms", 10, true},   {"time ms", 9, true},
          {"outcome", 0, false, 2}};
}

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
  std::string median = shown_or_blank(row.rms_angle_difference);
  if (!row.rms_angle_difference_lower) return median;
  return fmt::format("{} ({}-{})", median, thousandths(*row.rms_angle_difference_lower),
                     thousandths(*row.rms_angle_difference_upper));
}

std::string signed_or_blank(const std::optional<double>& value) {
  return value ? (*value > 0 ? "+" : "") + thousandths(*value) : "";
}

/// What becomes of a run, and how far it is from the scene's test.
std::string outcome_text(const RunMetrics& row) {
  if (!row.rms_test_difference) return row.outcome;
  return fmt::format("{}{}test {}", row.outcome, row.outcome.empty() ? "" : "; ",
                     thousandths(*row.rms_test_difference));
}

/// Set of an engine, or which exact solution.
std::string row_name(const RunMetrics& row) {
  if (is_engine(row)) return set_name(row);
  if (row.engine == "exact") return "exact, law " + row.law;
  return row.solver.empty() ? row.engine : "exact, " + row.engine;
}

TableCells row_cells(const RunMetrics& row) {
  return {shown_or_blank(row.dt),
          row_name(row),
          angles(row),
          shown_or_blank(row.rms_position_difference),
          signed_or_blank(row.first_impact_time_difference),
          shown_or_blank(row.stepping_time_minimum) + (row.timed_cold ? " cold" : ""),
          outcome_text(row)};
}

/// Prints one scene and step; nothing where no difference is significant.
void print_nearest(const std::vector<RunMetrics>& rows) {
  std::vector<std::string> first;
  bool significant = false;
  for (const RunMetrics& row : rows) {
    if (row.rank == 1) first.push_back(set_name(row));
    significant = significant || row.rank > 1;
  }
  if (significant) fmt::print("{:>7} * {}\n", shown_or_blank(rows.front().dt), joined(first));
}

/// Up to when histories can be compared: the horizon, or where the exact motion ends before.
std::string comparable_text(const RunMetrics& exact) {
  const double horizon = exact.horizon.value_or(0);
  if (exact.toppled.empty() || end_time(exact.toppled) > horizon) return quantity_text(horizon, "s");
  return fmt::format("{}, where it topples", quantity_text(end_time(exact.toppled), "s"));
}

/// What there is to know of a scene before its engines.
void print_exact_rows(const std::vector<RunMetrics>& rows, std::size_t width) {
  for (const RunMetrics& row : rows) {
    if (row.engine != "exact") {
      fmt::print("{}",
                 table_line(row_columns(width), {"", row_name(row), shown_or_blank(row.rms_angle_difference)},
                            TableForm::text));
      continue;
    }
    fmt::print("\n{}, law {}: ", row.scene, row.law);
    if (row.status != RunStatus::done) {
      fmt::print("no exact motion: {}\n", row.reason);
      continue;
    }
    fmt::print("{}; can be compared up to {}; solved in {}\n", impacts_text(row), comparable_text(row),
               quantity_text(row.stepping_time_minimum.value_or(0), "s"));
    if (row.rms_test_difference) fmt::print("from the test: {}\n", thousandths(*row.rms_test_difference));
    fmt::print("{}", table_head(row_columns(width), TableForm::text));
  }
}

/// How many letters the longest name of a set has.
std::size_t longest_name(const std::vector<Suite>& suites) {
  std::size_t length = std::string_view("engine:solver (set)").size();
  for (const Suite& suite : suites)
    for (const EngineSeries& one : suite.series)
      length = std::max(length, set_name(one.engine->name, one.engine->solver, one.settings).size());
  return length;
}

/// Which engines do not tell what sticks from what slides, where scenes do.
void print_single_coefficients(const std::vector<Suite>& suites) {
  std::set<std::string> names;
  for (const Suite& suite : suites)
    if (std::ranges::any_of(suite.scenes,
                            [](const NamedScene& one) { return !one.scene.kinetic_friction.empty(); }))
      for (const EngineSeries& one : suite.series)
        if (!one.files && !one.engine->capabilities.kinetic_friction) names.insert(one.engine->full_name());
  if (!names.empty())
    fmt::print("kinetic_friction: not of {}, whose single coefficient is friction\n", fmt::join(names, ", "));
}

}  // namespace

void print_legend(const std::vector<Suite>& suites, const Common& common) {
  if (!common.prints_text()) return;
  int replicates = 1;
  double bound = 0;
  bool tested = false, ratio = false;
  for (const Suite& suite : suites) {
    for (const NamedScene& scene : suite.scenes) {
      tested = tested || scene.measured.has_value();
      ratio = ratio || !scene.scene.restitution.empty();
    }
    replicates = std::max(replicates, suite.replicates.runs);
    bound = std::max(bound, suite.replicates.most_steps);
  }
  const std::string fewer =
      bound > 0 ? fmt::format(", fewer where they take {:.0f} steps together", bound) : "";
  fmt::print(
      "angles, centres: RMS differences from the exact motion up to the horizon{}\n"
      "impact: the first one, engine less exact; time: the shortest wall time of stepping (cold: before the "
      "engine's runtime was warm)\n"
      "*: nearest of their scene and step, where any can be told from others; several that are named cannot be "
      "told apart\n",
      replicates > 1 ? fmt::format(", medians of {} replicates{} (quartiles)", replicates, fewer) : "");
  if (ratio) fmt::print("restitution: of the exact motion alone, engines run without\n");
  print_single_coefficients(suites);
  if (tested) fmt::print("test: RMS difference from what was measured, mrad, or mm of a point\n");
  std::fflush(stdout);
}

void print_rows(const std::vector<Suite>& suites, const Common& common, CompareOptions& options) {
  if (!common.prints_text()) return;
  const std::size_t width = longest_name(suites);
  options.row = [&common, width](const RunMetrics& row) {
    clear_progress(common);
    fmt::print("{}", table_line(row_columns(width), row_cells(row), TableForm::text));
    std::fflush(stdout);
  };
  options.rows = [&common, width](const std::vector<RunMetrics>& rows) {
    clear_progress(common);
    is_engine(rows.front()) ? print_nearest(rows) : print_exact_rows(rows, width);
    std::fflush(stdout);
  };
}

void print_rows(const std::vector<RunMetrics>& rows, TableForm form) {
  std::vector<TableColumn> columns = row_columns(0);
  columns.insert(columns.begin(), {{"scene"}, {"nearest"}});
  fmt::print("{}", table_head(columns, form));
  for (const RunMetrics& row : rows) {
    const bool nearest = row.rank == 1 && std::ranges::any_of(rows, [&](const RunMetrics& other) {
                           return other.scene == row.scene && other.dt == row.dt && other.rank > 1;
                         });
    TableCells cells = row_cells(row);
    cells.insert(cells.begin(), {row.scene, nearest ? "*" : ""});
    fmt::print("{}", table_line(columns, cells, form));
  }
  fmt::print("{}", table_foot(form));
}

}  // namespace rockstack
