#include "comparisons/studies/advise/advise.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

struct AdviseArguments {
  std::string scene;
  std::filesystem::path out;
  double error = 1e-3;     ///< rad, and of the least block height
  double within = 60;      ///< of the whole search, s
  double time_limit = 60;  ///< of each run, s
  std::vector<std::string> engines = {};
};

std::vector<TableColumn> trial_columns() {
  return {{"solver (tuned)", 34, false, 0},
          {"dt (s)", 8, true},
          {"off (rad, h)", 14, true},
          {"time (s)", 12, true},
          {"within", 8, true},
          {"confirmed", 9, true},
          {"", 0, false, 2}};
}

TableCells trial_cells(const Trial& trial) {
  const auto cell = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2e}", *value) : "-";
  };
  const RunMetrics& row = trial.row;
  const std::optional<double> off = std::max(row.largest_angle_difference, row.relative_position_difference);
  const std::string remark = row.status != RunStatus::done ? name(row.status)
                             : trial.passes()              ? "holds"
                             : trial.within > 0            ? "luck"
                                                           : "";
  return {row.engine + ":" + row.solver,
          fmt::format("{}", row.dt.value_or(0)),
          cell(off),
          cell(row.stepping_time_minimum),
          fmt::format("{} / {}", trial.within, trial.replicates),
          trial.confirming > 0 ? fmt::format("{} / {}", trial.confirmed, trial.confirming) : "-",
          remark};
}

/// What the columns mean, and how long it may take.
void print_legend(const AdviceRequest& request) {
  fmt::print(
      "tries {} from large steps to small ones, for {} at most (--within)\n"
      "off: the largest difference of an angle, rad, or of a centre, in least heights; of replicates their median\n"
      "within: replicates that are off by {} at most, of steps up to {:.0f} % longer and shorter and scenes that\n"
      "differ in the sixth digit; {:.0f} of 100 must be\n"
      "confirmed: the same of others, of steps up to {:.0f} % longer and shorter\n\n",
      counted(request.engines.size(), "solver"), waiting_time(request.within), request.error,
      100 * request.replicates.steps, 100 * passing_share, 100 * request.confirming.steps);
}

/// Has each trial named while it runs, and printed once it is done.
AdviceListener listener(const AdviceRequest& request, const PrintedTable& table, const Common& common) {
  AdviceListener listener;
  if (shows_progress(common))
    listener.begin = [&request](const EngineSeries& series, double dt, double elapsed) {
      fmt::print(stderr, "\r\033[K[{:.0f} of at most {:.0f} s] running {} at {} s", elapsed, request.within,
                 series.engine->full_name(), dt);
      std::fflush(stderr);
    };
  listener.trial = [&table](const Trial& trial) { table.print(trial_cells(trial)); };
  return listener;
}

void print_advice(const Advice& advice, const AdviseArguments& arguments, const AdviceRequest& request,
                  double duration, const Common& common) {
  fmt::print("\n{}\n", fmt::join(advice_sentences(request, advice, duration), "\n"));
  if (advice.pick < 0) return;
  for (const DistributionDistance& one : advice.beyond)  // after histories have parted
    fmt::print("  whole scene, {}: exact mean {:.4g}, this solver {:.4g}; distance {:.2f}, {}\n",
               one.quantity, one.exact_mean, one.other_mean, one.apart.distance,
               one.apart.p_value < 0.05 ? "another distribution" : "not to be told apart");
  const RunMetrics& pick = advice.trials[static_cast<std::size_t>(advice.pick)].row;
  const std::string changes = joined_texts(
      common.overrides, [](const std::string& change) { return " --set " + shell_word(change); });
  fmt::print("rockstack simulate {}{} --engine {}:{} --dt {}\n", shell_word(arguments.scene), changes,
             pick.engine, pick.solver, pick.dt.value_or(0));
}

int run_advise(const AdviseArguments& arguments, const Common& common) {
  require_above_zero("--error", arguments.error);
  require_above_zero("--within", arguments.within);
  require_above_zero("--time-limit", arguments.time_limit);
  const NamedScene scene = read_one_scene(arguments.scene, common);
  const ResultsFolder folder(arguments.out, Results::advice, scene.name, common.replace);
  warn_of_sizes(scene.scene, common);
  AdviceRequest request{.error = arguments.error,
                        .within = arguments.within,
                        .engines = engines_named(arguments.engines, usual_engines)};
  request.limits.time = std::min(arguments.time_limit, arguments.within);
  if (common.prints_text()) print_legend(request);
  const PrintedTable table(trial_columns(), common);
  const Advice advice =
      advise(scene, request, arguments.out, common.command, listener(request, table, common));
  if (print_json(advice_json(scene, request, advice, common.command), common))
    print_advice(advice, arguments, request, scene.scene.duration, common);
  show_report(arguments.out, common);
  return advice.pick < 0 ? 1 : 0;
}

void add_advise(CLI::App& command, AdviseArguments& arguments) {
  command.add_option("scene", arguments.scene, scene_help)->required();
  command
      .add_option(
          "--error", arguments.error,
          "largest difference from the exact motion: of angles, rad, and of centres, in least heights")
      ->capture_default_str();
  command.add_option("--within", arguments.within, "of the whole search, s")->capture_default_str();
  command.add_option("--engine", arguments.engines, "engine, or engine:solver; more than one may be given");
  command.add_option("--time-limit", arguments.time_limit, "of each run, s")->capture_default_str();
  add_results(command, arguments.out, [&] { return arguments.scene; });
}

}  // namespace

Command advise_command() {
  return with_tables(make_command("advise",
                                  "find the cheapest engine, solver and step for a scene within an error",
                                  add_advise, run_advise));
}

}  // namespace rockstack
