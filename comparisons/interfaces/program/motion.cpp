#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/metrics/branches.hpp"
#include "comparisons/measures/metrics/sizes.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/outcome_columns.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/runs/measure.hpp"
#include "engines/scene_setup.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/figures/figure.hpp"
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

struct SimulateArguments {
  std::string scene;
  std::filesystem::path out;
  std::string engine;
  std::string settings = "tuned";
  std::vector<std::string> parameters;  ///< name=value, changes of those settings
  double dt = 0;                        ///< s
  std::vector<std::string> histories;   ///< "forces", or none
  bool plots = true;                    ///< figures and a page
};

struct SolveArguments {
  std::string scene;
  std::filesystem::path out;
  std::string integrator = "taylor";  ///< or "rk4"
  double step = 2e-4;                 ///< of rk4, s
  double interval = 1e-3;             ///< of samples, s
  bool plots = true;                  ///< figures and a page
  double tolerance = 0;  ///< of taylor: share of the velocity that a step may leave out; 0: rounding
  std::vector<std::string> histories;  ///< kinds_of_histories() to write
  bool branches = false;               ///< follow all motions where contact leaves several
  std::size_t most_branches = 16;
};

/// Numbers that came out of a motion, those that it has.
std::vector<TableCells> outcome_lines(const Json& outcome) {
  std::vector<TableCells> lines{{"outcome", "value"}};
  for (const auto& [name, value] : outcome.items())
    if (!value.is_null())
      lines.push_back(
          {name, value.is_number_float() ? number_text(value.get<double>(), 6) : cell_text(value)});
  return lines;
}

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
  if (common.prints_documents()) print_table(outcome_lines(json), common.table);
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

int run_solve(const SolveArguments& arguments, const Common& common) {
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

int run_simulate(const SimulateArguments& arguments, const Common& common) {
  require_above_zero("--dt", arguments.dt);
  const std::vector<const WorkerEngine*> named = engines_named(arguments.engine);
  const WorkerEngine& engine = *named.front();
  const Parameters changes = read_parameters(arguments.parameters, engine);
  const auto scene = read_one_scene(arguments.scene, common);
  check_step(arguments.dt, scene.scene.duration);
  const ResultsFolder folder(arguments.out, Results::motion, scene.name, common.replace);
  const EngineSeries series = make_series(engine, arguments.settings, {arguments.dt}, changes);
  const auto [history, support] =
      simulate_into(scene, series, arguments.dt, arguments.out, common.command, arguments.histories);
  if (named.size() > 1 && common.prints_text())
    fmt::print("engine: {}, the first of {}\n", engine.full_name(),
               fmt::join(mapped(named, &WorkerEngine::solver), ", "));
  print_history(scene.scene, history, support, arguments.out, common, true);
  if (arguments.plots) show_report(arguments.out, common);
  return 0;
}

void add_solve(CLI::App& command, SolveArguments& arguments) {
  command.add_option("scene", arguments.scene, scene_help)->required();
  add_results(command, arguments.out, [&] { return arguments.scene; });
  command.add_option("--integrator", arguments.integrator, "what makes the steps; rk4 is the baseline")
      ->check(one_of({"taylor", "rk4"}))
      ->capture_default_str();
  command.add_option("--step", arguments.step, "longest step of rk4, s")->capture_default_str();
  command.add_option("--interval", arguments.interval, "interval of samples in history.csv, s")
      ->capture_default_str();
  command
      .add_option("--tolerance", arguments.tolerance,
                  "of taylor: share of the velocity that a step may leave out, and angle below which "
                  "chatter ends, rad; 0: rounding")
      ->check(CLI::Range(0.0, 1e-3))
      ->capture_default_str();
  command.add_option("--histories", arguments.histories, "what else to write at each sample")
      ->delimiter(',')
      ->check(one_of(kinds_of_histories()));
  command.add_flag("--branches", arguments.branches,
                   "follow every motion where contact has several solutions, each into DIR/branches");
  command.add_option("--most-branches", arguments.most_branches, "bound of --branches")
      ->needs("--branches")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  add_plots(command, arguments.plots);
}

void add_simulate(CLI::App& command, SimulateArguments& arguments) {
  command.add_option("scene", arguments.scene, scene_help)->required();
  command.add_option("--engine", arguments.engine, "engine, or engine:solver")->required();
  command.add_option("--dt", arguments.dt, "time step, s")->required();
  command.add_option("--settings", arguments.settings, "parameter set")
      ->check(one_of({"default", "tuned"}))
      ->capture_default_str();
  command
      .add_option("--parameter", arguments.parameters,
                  "change of the parameter set, e.g. erp=0.05; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--histories", arguments.histories, "what else to write of each step")
      ->check(one_of({"forces"}));
  add_results(command, arguments.out, [&] { return arguments.scene; });
  add_plots(command, arguments.plots);
}

}  // namespace

Command solve_command() {
  return with_tables(make_command("solve", "solve a scene exactly", add_solve, run_solve));
}

Command simulate_command() {
  return with_tables(
      make_command("simulate", "run a scene in one physics engine", add_simulate, run_simulate));
}

}  // namespace rockstack
