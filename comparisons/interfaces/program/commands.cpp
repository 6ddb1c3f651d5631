#include "comparisons/interfaces/program/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "analytic/solve.hpp"
#include "comparisons/interfaces/program/comparison_output.hpp"
#include "comparisons/interfaces/program/executor_choice.hpp"
#include "comparisons/interfaces/program/output.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/runs/compare.hpp"
#include "comparisons/runs/measure.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/suites/shipped.hpp"
#include "engines/engine.hpp"
#include "engines/scene_setup.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/figures/motions/animation.hpp"
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

/// The suite or scene that an input of `compare` names.
std::filesystem::path find_input(const std::string& input) {
  return input_file(input, {"suites", "scenes"});
}

/// A suite says by itself what it runs.
void refuse_choice(const std::string& suite, const SceneChoice& choice) {
  const std::string option = !choice.engines.empty() ? "--engine " + choice.engines.front()
                             : !choice.steps.empty() ? fmt::format("--dt {}", choice.steps.front())
                             : choice.quick          ? "--quick"
                             : choice.softness       ? "--softness"
                                                     : "";
  if (!option.empty())
    throw InputError(fmt::format("{}: must be left out of {}, a suite or study says its own", option, suite));
}

Suite read_input(const std::string& input, const CompareArguments& arguments, const Common& common) {
  const auto file = find_input(input);
  const InputKind kind = kind_of(file);
  if (kind == InputKind::scene) return suite_for(read_named_scene(file, common.overrides), arguments.choice);
  refuse_choice(input, arguments.choice);
  return kind == InputKind::stability_study ? read_stability_study(file, common.overrides).suite
                                            : read_suite(file, common.overrides);
}

std::vector<Suite> read_inputs(const CompareArguments& arguments, const Common& common) {
  std::vector<Suite> suites;
  for (const std::string& input : arguments.inputs) {
    Suite& suite = suites.emplace_back(read_input(input, arguments, common));
    if (arguments.draws > 0) set_runs(suite.draws, arguments.draws);
    if (arguments.history_interval) suite.history_interval = *arguments.history_interval;
  }
  if (arguments.record) replace_made_up_motion(suites, *arguments.record);
  return suites;
}

/// Says how much disk a comparison takes where that is much.
void announce_disk_use(const std::vector<Suite>& suites, const std::filesystem::path& out,
                       const Common& common) {
  constexpr double megabyte = 1e6, much = 200 * megabyte;
  const double bytes = history_bytes(suites);
  if (bytes < much || common.quiet) return;
  fmt::print(
      stderr,
      "about {:.0f} MB of histories will be written to {}; --history-interval 0.01 keeps a sample every "
      "10 ms\n",
      bytes / megabyte, out.string());
}

#ifdef ROCKSTACK_WITH_PLOTS
void print_animations(const std::vector<std::filesystem::path>& files, const Common& common) {
  if (common.quiet || common.json) return;
  for (const auto& file : files) fmt::print("film: {}\n", file.string());
}

/// Figures of thousands of scenes take hours: they are drawn when asked for.
void draw_few(const std::vector<Suite>& suites, const std::filesystem::path& results, const Common& common) {
  constexpr std::size_t most = 100;
  std::size_t scenes = 0;
  for (const Suite& suite : suites) scenes += suite.scenes.size();
  if (scenes <= most) return plots::show(results);
  if (!common.quiet)
    fmt::print(stderr, "{} scenes: figures and report are drawn by `rockstack plot {}`\n", scenes,
               results.string());
}
#endif

int study_command(const std::filesystem::path& file, const std::filesystem::path& out, const Common& common) {
  refuse_overrides(common, "a study of impact laws makes its own scenes");
  const ImpactLawStudy study = read_impact_law_study(file);
  const ResultsFolder folder(out, Results::impact_laws);
  const ImpactLawResults results = run_study(study);
  write_results(study, results, out, common.command);
  print_impact_laws(results, out, common);
  show_report(out, common);
  const bool failed = std::any_of(results.cases.begin(), results.cases.end(), [](const AskedCase& asked) {
    return std::any_of(asked.verdicts.begin(), asked.verdicts.end(),
                       [](const EngineVerdict& verdict) { return !verdict.failure.empty(); });
  });
  return failed ? 1 : 0;
}

/// Which one it was where a name stands for several.
void print_first_of(const std::vector<const WorkerEngine*>& engines, const Common& common) {
  if (common.quiet || common.json) return;
  std::vector<std::string> solvers;
  solvers.reserve(engines.size());
  for (const WorkerEngine* engine : engines) solvers.push_back(engine->solver);
  fmt::print("engine: {}, the first of {}\n", engines.front()->full_name(), fmt::join(solvers, ", "));
}

}  // namespace

NamedScene read_one_scene(const std::string& input, const Common& common) {
  const auto file = input_file(input, {"scenes", "suites"});
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored) && kind_of(file) != InputKind::scene)
    throw InputError(input + ": must be a scene, this is a suite, which `rockstack compare` takes");
  return read_named_scene(file, common.overrides);
}

void require_positive_option(const char* option, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(fmt::format("{} = {}: must be a finite number > 0", option, value));
}

void refuse_overrides(const Common& common, const char* reason) {
  if (!common.overrides.empty())
    throw InputError(fmt::format("--set {}: must be left out, {}", common.overrides.front(), reason));
}

int solve_command(const SolveArguments& arguments, const Common& common) {
  require_positive_option("--step", arguments.step);
  require_positive_option("--interval", arguments.interval);
  const auto scene = read_one_scene(arguments.scene, common);
  const SolveOptions options{
      .integrator = arguments.integrator == "rk4" ? Integrator::rk4 : Integrator::taylor,
      .sample_times = regular_times(arguments.interval, scene.scene.duration),
      .validity = true,
      .peaks = true,
      .resolution = arguments.tolerance,
      .tolerance = arguments.tolerance,
      .step = arguments.step};
  const ResultsFolder folder(arguments.out, Results::motion);
  const History history = solve_into(scene, options, arguments.histories, arguments.out, common.command);
  print_history(scene.scene, history, {}, arguments.out, common);
  if (arguments.plots) show_report(arguments.out, common);
  return 0;
}

int simulate_command(const SimulateArguments& arguments, const Common& common) {
  require_positive_option("--dt", arguments.dt);
  const std::vector<const WorkerEngine*> named = engines_named(arguments.engine);
  const WorkerEngine& engine = *named.front();
  const Parameters changes = read_parameters(arguments.parameters, engine);
  const auto scene = read_one_scene(arguments.scene, common);
  check_step(arguments.dt, scene.scene.duration);
  const ResultsFolder folder(arguments.out, Results::motion);
  const EngineSeries series = make_series(engine, arguments.settings, {arguments.dt}, changes);
  const auto [history, support] = simulate_into(scene, series, arguments.dt, arguments.out, common.command);
  if (named.size() > 1) print_first_of(named, common);
  print_history(scene.scene, history, support, arguments.out, common);
  if (arguments.plots) show_report(arguments.out, common);
  return 0;
}

int compare_command(const CompareArguments& arguments, const Common& common) {
  for (const double step : arguments.choice.steps) require_positive_option("--dt", step);
  if (arguments.history_interval) require_positive_option("--history-interval", *arguments.history_interval);
  const auto executor = make_executor(arguments.jobs);
  if (!executor->leads()) {
    serve_comparison(
        *executor, [&] { return read_inputs(arguments, common); }, common.command);
    return 0;
  }
  for (const std::string& input : arguments.inputs) {
    const auto file = find_input(input);
    const InputKind kind = kind_of(file);
    if (kind == InputKind::scene || kind == InputKind::suite) continue;
    refuse_choice(input, arguments.choice);
    if (arguments.history_interval)
      throw InputError(
          fmt::format("--history-interval {}: must be left out of a study, which keeps no histories",
                      *arguments.history_interval));
    if (arguments.inputs.size() > 1) throw InputError(input + ": a study must be the only input");
    if (arguments.record)
      throw InputError(fmt::format("--record {}: must be left out of a study", *arguments.record));
    if (kind == InputKind::stability_study)
      return stability_command(file, arguments.out, *executor, arguments.draws, common);
    return study_command(file, arguments.out, common);
  }
  const std::vector<Suite> suites = read_inputs(arguments, common);
  require_comparable(suites);
  const ResultsFolder folder(arguments.out, Results::comparison);
  announce_disk_use(suites, arguments.out, common);
  print_legend(suites, common);
  const CompareResult result =
      compare(suites, arguments.out, *executor,
              {.command = common.command, .progress = progress(common), .rows = row_printer(common)});
#ifdef ROCKSTACK_WITH_PLOTS
  draw_few(suites, arguments.out, common);
#endif
  print_report(arguments.out, common);
  print_comparison(result, arguments.out, common);
  const auto failed = std::count_if(result.rows.begin(), result.rows.end(),
                                    [](const RunMetrics& row) { return row.status != RunStatus::done; });
  return end_of_runs(static_cast<std::size_t>(failed), result.rows.size(), "comparison.csv");
}

int plot_command(const PlotArguments& arguments, const Common& common) {
  refuse_overrides(common, "figures are of results that are there");
  const std::filesystem::path& results = arguments.results;
  const FolderLock lock(results);
#ifdef ROCKSTACK_WITH_PLOTS
  if (arguments.animate && !plots::has_runs(results))
    throw InputError(fmt::format("plot {} --animate: must be a folder of `rockstack compare` or `teach`",
                                 results.string()));
  plots::show(results);
  print_report(results, common);
  if (arguments.animate) print_animations(plots::draw_animations(results), common);
  return 0;
#else
  static_cast<void>(common);
  throw InputError(
      fmt::format("plot {}: must be asked of a build with ROCKSTACK_PLOTS=ON", results.string()));
#endif
}

}  // namespace rockstack
