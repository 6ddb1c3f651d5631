#include "comparisons/advise.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "analytic/scene/input_error.hpp"
#include "comparisons/build.hpp"
#include "comparisons/files.hpp"
#include "comparisons/program/commands.hpp"
#include "comparisons/program/output.hpp"
#include "comparisons/stability/study.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/stability.hpp"
#endif

namespace rockstack {
namespace {

void require_positive_option(const char* option, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(fmt::format("{} = {}: must be a finite number > 0", option, value));
}

void print_advice(const Advice& advice, const AdviseArguments& arguments) {
  fmt::print("{:<32} {:>8} {:>14} {:>12}  {}\n", "solver (tuned)", "dt (s)", "angle off (rad)", "time (s)",
             "");
  for (std::size_t i = 0; i < advice.rows.size(); ++i) {
    const Row& row = advice.rows[i];
    const auto cell = [](const std::optional<double>& value) {
      return value ? fmt::format("{:.2e}", *value) : "-";
    };
    const std::string words = row.status != "done"                 ? row.status
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
  const Row& pick = advice.rows[static_cast<std::size_t>(advice.pick)];
  fmt::print("\nrockstack simulate {} --engine {}:{} --dt {} --out DIR\n", arguments.scene, pick.engine,
             pick.solver, pick.dt.value_or(0));
}

}  // namespace

int advise_command(const AdviseArguments& arguments, const Common& common) {
  require_positive_option("--error", arguments.error);
  require_positive_option("--time-limit", arguments.time_limit);
  const NamedScene scene = read_named_scene(find_file(arguments.scene, build::scenes), common.overrides);
  prepare_folder(arguments.out);
  const FolderLock lock(arguments.out);
  Wish wish{.error = arguments.error};
  wish.limits.time = arguments.time_limit;
  const Advice advice = advise(scene, wish, arguments.out, common.command);
  if (common.json) {
    nlohmann::ordered_json json{{"error", arguments.error}, {"pick", nullptr}};
    if (advice.pick >= 0) json["pick"] = row_json(advice.rows[static_cast<std::size_t>(advice.pick)]);
    fmt::print("{}\n", json.dump(2));
  } else if (!common.quiet) {
    print_advice(advice, arguments);
  }
  return advice.pick < 0 ? 1 : 0;
}

int stability_command(const std::filesystem::path& file, const std::filesystem::path& out, std::size_t jobs,
                      const Common& common) {
  const StabilityStudy study = read_stability_study(file, common.overrides);
  prepare_folder(out);
  const FolderLock lock(out);
  const std::vector<StabilityRow> rows = run_stability(study, out, {common.command, jobs, progress(common)});
#ifdef ROCKSTACK_WITH_PLOTS
  draw_stability(out);
#endif
  if (common.quiet) return 0;
  std::map<std::string, int> counts{{"sound", 0}, {"inexact", 0}, {"unstable", 0}, {"failed", 0}};
  for (const StabilityRow& row : rows) {
    if (row.row.dt) ++counts[name(row.verdict.soundness)];
  }
  if (common.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"verdicts", counts}, {"folder", out.string()}}.dump(2));
    return 0;
  }
  for (const auto& [verdict, count] : counts) fmt::print("{:>6} runs {}\n", count, verdict);
  fmt::print("{}\n{}\n", (out / "stability.csv").string(), (out / "steps.csv").string());
  return 0;
}

}  // namespace rockstack
