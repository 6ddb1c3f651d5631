#include "comparisons/runs/advise.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/program/commands.hpp"
#include "comparisons/program/output.hpp"
#include "comparisons/results/results_folder.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

void print_advice(const Advice& advice, const AdviseArguments& arguments, const Common& common) {
  fmt::print("{:<32} {:>8} {:>14} {:>12}  {}\n", "solver (tuned)", "dt (s)", "angle off (rad)", "time (s)",
             "");
  for (std::size_t i = 0; i < advice.rows.size(); ++i) {
    const RunMetrics& row = advice.rows[i];
    const auto cell = [](const std::optional<double>& value) {
      return value ? fmt::format("{:.2e}", *value) : "-";
    };
    const std::string words = row.status != RunStatus::done        ? name(row.status)
                              : static_cast<int>(i) == advice.pick ? "<- the cheapest within the error"
                              : meets(row, arguments.error)        ? "within the error"
                                                                   : "";
    fmt::print("{:<32} {:>8} {:>14} {:>12}  {}\n", row.engine + ":" + row.solver, row.dt.value_or(0),
               cell(row.largest_angle_difference), cell(row.stepping_time_minimum), words);
  }
  if (advice.pick < 0) {
    fmt::print("No solver comes within {} rad at a step down to {} s.\n", arguments.error,
               advised_steps().back());
    return;
  }
  const RunMetrics& pick = advice.rows[static_cast<std::size_t>(advice.pick)];
  std::string changes;
  for (const std::string& change : common.overrides) changes += " --set " + shell_word(change);
  fmt::print("\nrockstack simulate {}{} --engine {}:{} --dt {} --out DIR\n", shell_word(arguments.scene),
             changes, pick.engine, pick.solver, pick.dt.value_or(0));
}

}  // namespace

int advise_command(const AdviseArguments& arguments, const Common& common) {
  require_positive_option("--error", arguments.error);
  require_positive_option("--time-limit", arguments.time_limit);
  const NamedScene scene = read_named_scene(find_file(arguments.scene, "scenes"), common.overrides);
  const ResultsFolder folder(arguments.out, Results::advice);
  Wish wish{.error = arguments.error};
  wish.limits.time = arguments.time_limit;
  const Advice advice = advise(scene, wish, arguments.out, common.command);
  if (common.json) {
    nlohmann::ordered_json json{{"error", arguments.error}, {"pick", nullptr}};
    if (advice.pick >= 0) json["pick"] = metrics_json(advice.rows[static_cast<std::size_t>(advice.pick)]);
    fmt::print("{}\n", json.dump(2));
  } else if (!common.quiet) {
    print_advice(advice, arguments, common);
  }
  return advice.pick < 0 ? 1 : 0;
}

}  // namespace rockstack
