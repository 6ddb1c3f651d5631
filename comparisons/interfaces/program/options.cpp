#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/tables.hpp"

namespace rockstack {
namespace {

constexpr const char* scene_help = "scene file, or a name from `rockstack list scenes`";

/// One of some words; of what is none of them the nearest is named.
CLI::Validator one_of(const std::vector<std::string>& words) {
  const CLI::IsMember listed(words);
  const auto check = [listed, words](std::string& given) {
    const std::string complaint = listed(given);
    return complaint.empty() ? complaint : complaint + did_you_mean(given, words);
  };
  return {check, listed.get_description()};
}

constexpr const char* usual_folder = "rockstack-results";

/// The folder for results of a command; where none is given, its name is of the command and its input.
void add_results(CLI::App& command, std::filesystem::path& out, std::function<std::string()> input,
                 const char* more = "") {
  const std::string name = command.get_name();
  command
      .add_option("--out", out,
                  fmt::format("folder for results{}; left out: {}/{}-INPUT", more, usual_folder, name))
      ->check([](const std::string& text) { return std::string(text.empty() ? "must be a folder" : ""); });
  command.parse_complete_callback([name, &out, input = std::move(input)] {
    if (out.empty())
      out = std::filesystem::path(usual_folder) /
            folder_name(name + "-" + std::filesystem::path(input()).stem().string());
  });
}

void add_plots(CLI::App& command, bool& plots) {
  command.add_flag_callback(
      "--no-plots", [&plots] { plots = false; }, "leave out the figure and the page with the player");
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
  add_results(command, arguments.out, [&] { return arguments.scene; });
  add_plots(command, arguments.plots);
}

void add_compare(CLI::App& command, CompareArguments& arguments) {
  command.add_option("inputs", arguments.inputs, "scene or suite files, or names from `rockstack list`")
      ->required();
  command.add_option(
      "--record", arguments.record,
      "record in the place of those of scenes and of synthetic motions, scaled to their peak, and to its end");
  command
      .add_option("--jobs", arguments.jobs,
                  "runs at a time; with more than one, times are those of runs that share the machine")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.add_option("--draws", arguments.choice.replicates,
                     "replicates behind each number of an engine: runs at nearby steps of nearly the same "
                     "scene; left out: "
                     "as the suite says, for a scene the least that can tell its sets apart, 5 or more");
  command
      .add_option(
          "--engine", arguments.choice.scenes.engines,
          "of scenes: engine, or engine:solver; may be repeated or a list, ode:step,bullet; left out: "
          "the first solver of Bullet, in both precisions, and of ODE")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option("--dt", arguments.choice.scenes.steps,
                  "of scenes: time step, s; may be repeated or a list, 1e-2,1e-3; left out: 1e-2,1e-3,1e-4")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_flag("--quick", arguments.choice.scenes.quick,
                   "of scenes: steps of 1e-2 and 1e-3 s, one timed run, 2000 samples of each history");
  command.add_flag(
      "--softness", arguments.choice.scenes.softness,
      "of scenes: split each engine's difference into contact model, contact softness and time step");
  command.add_option(
      "--history-interval", arguments.choice.history_interval,
      "least time between the samples that files keep, s; numbers are of all samples; left out: 1e-3");
  add_results(
      command, arguments.out, [&] { return arguments.inputs.front(); },
      ", where a comparison that was stopped goes on and runs that are done stay");
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

void add_fit(CLI::App& command, FitArguments& arguments) {
  command.add_option("scene", arguments.scene, "scene file with a table [measured]")->required();
  command
      .add_option("--vary", arguments.vary, "key of the scene and its range, KEY=LOW:HIGH; may be repeated")
      ->required()
      ->allow_extra_args(false);
  add_results(command, arguments.out, [&] { return arguments.scene; });
}

void add_sweep(CLI::App& command, SweepArguments& arguments) {
  command
      .add_option("ensemble", arguments.ensemble, "ensemble file, or a name from `rockstack list ensembles`")
      ->required();
  command
      .add_option("--threads", arguments.threads,
                  "threads, as many as the machine has if left out; under mpirun, one a rank")
      ->check(CLI::Range(1, 1024));
  add_results(
      command, arguments.out, [&] { return arguments.ensemble; }, ", where a sweep that was stopped goes on");
}

void add_plot(CLI::App& command, std::filesystem::path& results) {
  command.add_option("folder", results, "folder with results")->required();
}

void add_record(CLI::App& command, RecordArguments& arguments) {
  command.add_option("file", arguments.file, "record, or record:channel")->required();
  command.add_option("--out", arguments.out, "folder for results; left out: none are written");
  command.add_option("--base-line", arguments.base_line, "line to take off the accelerations first")
      ->check(one_of({"none", "fitted"}))
      ->capture_default_str();
}

void add_diff(CLI::App& command, DiffArguments& arguments) {
  ChangeOptions& options = arguments.options;
  command.add_option("old", arguments.old_results, "folder with the results of before")->required();
  command.add_option("new", arguments.new_results, "folder with the new results")->required();
  command
      .add_option("--level", options.level,
                  "chance that any number with replicates is reported as changed where nothing has changed")
      ->capture_default_str();
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

void add_teach(CLI::App& command, TeachArguments& arguments) {
  command.add_option("lesson", arguments.lesson, "name of a lesson, or all; left out, or list: list them");
  add_results(command, arguments.out, [&] { return arguments.lesson; });
  command.add_flag("--pdf", arguments.pdf, "slides as PDF too, by Chromium");
  command
      .add_option("--sheet", arguments.sheet,
                  "write a problem sheet instead, its numbers drawn from this seed, and its key")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53U));
}

#ifdef ROCKSTACK_WITH_LIVE
void add_live(CLI::App& command, LiveArguments& arguments) {
  command
      .add_option("input", arguments.input,
                  "scene file, name of a scene or lesson, folder of `rockstack teach`, or a link of a page")
      ->capture_default_str();
  command.add_option("--record", arguments.records, "record that the page may choose; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--port", arguments.port, "of 127.0.0.1; left out: any that is free")
      ->check(CLI::Range(1, 65535));
  command.add_flag_callback(
      "--no-browser", [&] { arguments.browser = false; }, "print the address alone");
}
#endif

void add_list(CLI::App& command, KindArguments& arguments) {
  command.add_option("what", arguments.kind, "scenes, suites, ensembles, lessons or engines; left out: all")
      ->check(one_of({"scenes", "suites", "ensembles", "lessons", "engines"}));
}

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
  command.add_option("--settings", settings, "parameter sets; left out: both")
      ->delimiter(',')
      ->check(one_of({"default", "tuned"}));
}

void add_check_engine(CLI::App& command, CheckEngineArguments& arguments) {
  command
      .add_option("engine", arguments.engine,
                  "worker program, e.g. ./my_engine.py, or a name from `rockstack list engines`")
      ->required();
  add_settings(command, arguments.settings);
  command.add_option("--check", arguments.checks, "names of checks; left out: all")->delimiter(',');
}

void add_canon(CLI::App& command, CanonArguments& arguments) {
  command.add_option("engines", arguments.engines,
                     "worker programs, or names from `rockstack list engines`; left out: all");
  add_settings(command, arguments.settings);
  add_results(
      command, arguments.out, [&] { return arguments.engines.empty() ? "all" : arguments.engines.front(); },
      ", where a canon that was stopped goes on");
}

void add_keys(CLI::App& command, KindArguments& arguments) {
  command.add_option("kind", arguments.kind, "scene, suite or ensemble; left out: all")
      ->check(one_of({"scene", "suite", "ensemble"}));
}

void add_new(CLI::App& command, NewArguments& arguments) {
  command.add_option("kind", arguments.kind, "scene, suite or ensemble")
      ->check(one_of({"scene", "suite", "ensemble"}))
      ->capture_default_str();
  command.add_option("--record", arguments.record, "record that shakes the scene");
  command.add_option("--out", arguments.out, "new file to write; left out: standard output");
}

}  // namespace

std::map<const CLI::App*, std::function<int()>> add_commands(CLI::App& app, const Common& common) {
  std::map<const CLI::App*, std::function<int()>> commands;
  // `add` gives a subcommand its options, which fill arguments of its own.
  const auto command = [&]<class Arguments>(const char* name, const char* what,
                                            void (*add)(CLI::App&, Arguments&),
                                            int (*run)(const Arguments&, const Common&)) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* made = app.add_subcommand(name, what);
    add(*made, *arguments);
    commands[made] = [arguments, run, &common] { return run(*arguments, common); };
  };
  command("solve", "solve a scene exactly", add_solve, solve_command);
  command("simulate", "run a scene in one physics engine", add_simulate, simulate_command);
  command("compare", "run scenes or suites on the exact solver and the engines", add_compare,
          compare_command);
  command("advise", "find the cheapest engine, solver and step for a scene within an error", add_advise,
          advise_command);
  command("fit", "find what a test does not tell of its scene, such as a ratio of restitution", add_fit,
          fit_command);
  command("sweep", "solve a scene many times with values varied", add_sweep, sweep_command);
  command("diff",
          "hold two results of `compare` against each other; exit code 1: something got worse, 3: undecided",
          add_diff, diff_command);
  command("plot", "draw figures and the report from a results folder", add_plot, plot_command);
  command("record", "measure an accelerogram", add_record, record_command);
  command("teach", "list the lessons, or run one and write its page and slides", add_teach, teach_command);
#ifdef ROCKSTACK_WITH_LIVE
  command("live", "serve a page on this machine with sliders, on which solver and engines answer at once",
          add_live, live_command);
#endif
  command("list", "list what there is, with a line on each", add_list, list_command);
  command("check-engine", "hold an engine to the laws that every engine must follow", add_check_engine,
          check_engine_command);
  command("canon", "run small scenes with closed forms on engines: which law do they follow?", add_canon,
          canon_command);
  command("keys", "explain every key of input files: unit, default, range, meaning", add_keys, keys_command);
  command("new", "print a commented input file to begin with", add_new, new_command);
  return commands;
}

}  // namespace rockstack
