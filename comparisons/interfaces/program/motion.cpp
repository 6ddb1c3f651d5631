#include <fmt/format.h>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/metrics/branches.hpp"
#include "comparisons/measures/metrics/sizes.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/outcome_columns.hpp"
#include "comparisons/runs/measure.hpp"
#include "engines/scene_setup.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/figures/figure.hpp"
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

/// The verdict on a motion, its events by kind, peak angles, warnings, and where the files are; in between
/// what is said of other motions that obey. `sampled`: an engine's, which tells no events.
void print_history(const Scene& scene, const History& history, const SupportLoss& support,
                   const std::filesystem::path& folder, const Common& common, bool sampled,
                   const std::vector<std::string>& lines_of_others = {},
                   const Json& others = Json::object()) {
  std::map<std::string, int> events;
  for (const Event& event : history.events) ++events[name(event.kind)];
  const std::string verdict = motion_verdict(scene, history, support);
  const std::vector<double> peaks = peak_angles(history);
  std::vector<std::string> warnings = size_warnings(scene);
  for (std::string& warning : validity_warnings(scene, history)) warnings.push_back(std::move(warning));
  Json json = outcome_json(run_outcome(scene, history), sampled);
  json.update({{"verdict", verdict},
               {"events", events},
               {"peak_angles", peaks},
               {"warnings", warnings},
               {"folder", folder.string()}});
  json.update(others);
  if (!print_json(json, common)) return;
  fmt::print("{}\n", verdict);
  for (const GroundMotion* motion : {&scene.horizontal, &scene.vertical})
    if (!motion->samples.empty() && !motion->made_up) fmt::print("ground: {}\n", motion->source);
  for (const auto& [kind, number] : events) fmt::print("{}: {}\n", kind, number);
  constexpr double rounding = 1e-12;
  for (std::size_t k = 0; const double peak : peaks)
    fmt::print("peak angle of block {}: {:.6g} rad\n", ++k, peak < rounding ? 0 : peak);
  for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
  for (const std::string& line : lines_of_others) fmt::print("{}\n", line);
  fmt::print("results: {}\n", one_line(folder.string()));
}

/// Follows all motions; returns 1 where one was given up.
int solve_all(const SolveJob& job, std::size_t most, const Common& common) {
  const BranchTree tree = solve_branches_into(job, most);
  const Scene& scene = job.scene.scene;
  print_history(scene, tree.branches.front().history, {}, job.folder, common, false,
                branch_lines(scene, tree, most),
                {{"branches", branches_json(scene, tree)}, {"branches_left_out", tree.left_out}});
  const auto given_up = [](const Branch& branch) { return !branch.unfinished.empty(); };
  return std::ranges::any_of(tree.branches, given_up) ? 1 : 0;
}

}  // namespace

int solve_command(const SolveArguments& arguments, const Common& common) {
  require_above_zero("--step", arguments.step);
  require_above_zero("--interval", arguments.interval);
  if (arguments.integrator == "rk4" && arguments.tolerance > 0)
    throw InputError(
        fmt::format("--tolerance = {}: must be left out beside --integrator rk4, which takes --step",
                    arguments.tolerance));
  const auto scene = read_one_scene(arguments.scene, common);
  const SolveOptions options{
      .integrator = arguments.integrator == "rk4" ? Integrator::rk4 : Integrator::taylor,
      .sample_times = regular_times(arguments.interval, scene.scene.duration),
      .validity = true,
      .peaks = true,
      .resolution = arguments.tolerance,
      .tolerance = arguments.tolerance,
      .step = arguments.step};
  const ResultsFolder folder(arguments.out, Results::motion, scene.name, common.replace);
  const SolveJob job{scene, options, arguments.histories, arguments.out, common.command};
  int code = 0;
  if (arguments.branches)
    code = solve_all(job, arguments.most_branches, common);
  else
    print_history(scene.scene, solve_into(job), {}, arguments.out, common, false);
  if (arguments.plots) show_report(arguments.out, common);
  return code;
}

int simulate_command(const SimulateArguments& arguments, const Common& common) {
  require_above_zero("--dt", arguments.dt);
  const std::vector<const WorkerEngine*> named = engines_named(arguments.engine);
  const WorkerEngine& engine = *named.front();
  const Parameters changes = read_parameters(arguments.parameters, engine);
  const auto scene = read_one_scene(arguments.scene, common);
  check_step(arguments.dt, scene.scene.duration);
  const ResultsFolder folder(arguments.out, Results::motion, scene.name, common.replace);
  const EngineSeries series = make_series(engine, arguments.settings, {arguments.dt}, changes);
  const auto [history, support] = simulate_into(scene, series, arguments.dt, arguments.out, common.command);
  if (named.size() > 1 && common.prints_text())
    fmt::print("engine: {}, the first of {}\n", engine.full_name(),
               fmt::join(mapped(named, &WorkerEngine::solver), ", "));
  print_history(scene.scene, history, support, arguments.out, common, true);
  if (arguments.plots) show_report(arguments.out, common);
  return 0;
}

int plot_command(const std::filesystem::path& results, const Common& common) {
  refuse_overrides(common, "figures are of results that are there");
  const FolderLock lock(results);
#ifdef ROCKSTACK_WITH_PLOTS
  plots::show(results);
  print_report(results, common);
  return 0;
#else
  static_cast<void>(common);
  throw InputError(
      fmt::format("plot {}: must be asked of a build with ROCKSTACK_PLOTS=ON", results.string()));
#endif
}

}  // namespace rockstack
