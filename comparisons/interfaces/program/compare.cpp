#include <fmt/format.h>

#include <cstdio>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/interfaces/program/record_limits.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/suites/shipped.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

struct CompareArguments {
  std::vector<std::string> inputs;    ///< scenes or suites
  std::optional<std::string> record;  ///< in the place of made-up motions
  std::filesystem::path out;
  std::vector<std::string> trajectories;  ///< NAME=FILE.csv
  std::size_t jobs = 1;                   ///< runs at a time; without effect under mpirun
  CompareChoice choice;
};

/// The file that an input of `compare` names.
std::filesystem::path compared_file(const std::string& input) {
  auto file = input_file(input, {"suites", "scenes"});
  require_kind(input, file, "a scene or a suite",
               {InputKind::scene, InputKind::suite, InputKind::stability_study, InputKind::impact_law_study});
  return file;
}

Suite read_input(const std::string& input, const CompareArguments& arguments, const Common& common) {
  const auto file = compared_file(input);
  const InputKind kind = kind_of(file);
  SceneChoice of_scenes = arguments.choice.scenes;
  of_scenes.trajectories = named_trajectories(arguments.trajectories);
  if (kind == InputKind::scene) return suite_for(read_named_scene(file, common.overrides), of_scenes);
  refuse(of_scenes, input, "--");
  return kind == InputKind::stability_study ? read_stability_study(file, common.overrides).suite
                                            : read_suite(file, common.overrides);
}

std::vector<Suite> read_inputs(const CompareArguments& arguments, Common common) {
  const RecordLimits limits = arguments.record ? take_record_limits(common) : RecordLimits::usual;
  std::vector<Suite> suites;
  for (const std::string& input : arguments.inputs)
    apply(arguments.choice, suites.emplace_back(read_input(input, arguments, common)));
  if (arguments.record) replace_motion(suites, *arguments.record, limits);
  return suites;
}

/// Says how much disk a comparison takes where that is much.
void announce_disk_use(const std::vector<Suite>& suites, const std::filesystem::path& out,
                       const Common& common) {
  constexpr double megabyte = 1e6, much = 200 * megabyte;
  const double bytes = result_bytes(suites);
  if (bytes < much || common.quiet) return;
  fmt::print(stderr,
             "about {:.0f} MB will be written to {}; --history-interval 0.01 keeps a sample every 10 ms\n",
             bytes / megabyte, out.string());
}

/// Says where another comparison like this one could not show a change.
void announce_undecided(const std::vector<Suite>& suites, const Common& common) {
  std::map<std::string, std::vector<int>> sets;  // how often each of a set's rows is run
  for (const Job& job : jobs_of(suites))
    if (job.series != nullptr && !is_recorded(job))
      sets[set_name(describe(job))].push_back(replicates_of(job).runs);
  const auto runs = mapped(sets, [](const auto& set) { return set.second; });
  const std::vector<bool> shown = sets_that_can_change(runs, change_level);
  const auto rows = mapped(runs, [](const std::vector<int>& set) { return set.size(); });
  if (const auto hidden = std::ranges::count(shown, false); hidden > 0 && common.prints_text())
    fmt::print("`rockstack diff` can show no change of {} of {}; with --draws {} it can\n", hidden,
               counted(sets.size(), "set"), replicates_that_show_changes(rows, change_level));
}

/// Exit code of rows, as exit_code() has it.
int end_of_rows(const std::vector<RunMetrics>& rows, const char* file) {
  const auto is_failed = [](const RunMetrics& row) { return row.status != RunStatus::done; };
  const auto first = std::ranges::find_if(rows, is_failed);
  return exit_code(static_cast<std::size_t>(std::ranges::count_if(rows, is_failed)), rows.size(), file,
                   first == rows.end() ? "" : first->reason);
}

#ifdef ROCKSTACK_WITH_PLOTS
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

void print_left_out(const std::vector<std::string>& names) {
  if (!names.empty()) fmt::print("left out of this build: {}\n", joined(names));
}

/// What the study comes to, with its tables.
void print_impact_laws(const ImpactLawStudy& study, const ImpactLawResults& results,
                       const std::filesystem::path& folder, const Common& common) {
  const std::vector<ResultTable> list = tables(results);
  const std::vector<std::string> sentences = headline(study, results);
  const Json json{{"headline", sentences}, {"kinds", list.front().rows}, {"folder", folder.string()}};
  if (common.prints_tables())
    for (const ResultTable& one : list)
      if (one.file != "impact-laws-answers.csv") print_table(one.rows, common.table);
  if (!print_json(json, common)) return;
  for (const std::string& sentence : sentences) fmt::print("{}\n", sentence);
  print_left_out(study.engines.left_out);
  fmt::print("results: {}\n", one_line(folder.string()));
}

int study_command(const std::filesystem::path& file, const std::filesystem::path& out, const Common& common) {
  refuse_overrides(common, "a study of impact laws makes its own scenes");
  const ImpactLawStudy study = read_impact_law_study(file);
  const ResultsFolder folder(out, Results::impact_laws, subject_of(file), common.replace);
  const ImpactLawResults results = run_study(study);
  write_results(study, results, out, common.command);
  print_impact_laws(study, results, out, common);
  show_report(out, common);
  const bool failed = std::ranges::any_of(results.cases, [](const ImpactCase& asked) {
    return std::ranges::any_of(asked.verdicts,
                               [](const EngineVerdict& verdict) { return !verdict.failure.empty(); });
  });
  return failed ? 1 : 0;
}

void print_counts(const std::map<std::string, int>& counts, TableForm form) {
  std::vector<TableCells> lines{{"verdict", "runs"}};
  for (const auto& [verdict, count] : counts) lines.push_back({verdict, std::to_string(count)});
  print_table(lines, form);
}

void print_verdicts(const std::vector<StabilityRun>& rows, const std::filesystem::path& out,
                    const Common& common) {
  if (common.quiet) return;
  std::map<std::string, int> counts{{"sound", 0}, {"inexact", 0}, {"unstable", 0}, {"failed", 0}};
  for (const StabilityRun& row : rows)
    if (row.row.dt) ++counts[name(row.verdict.soundness)];
  if (common.prints_documents()) print_counts(counts, common.table);
  if (!print_json({{"verdicts", counts}, {"folder", out.string()}}, common)) return;
  for (const auto& [verdict, count] : counts) fmt::print("{:>6} runs {}\n", count, verdict);
  fmt::print("{}\n{}\n", one_line((out / "stability.csv").string()), one_line((out / "steps.csv").string()));
}

int stability_command(const std::filesystem::path& file, const CompareArguments& arguments,
                      Executor& executor, const Common& common) {
  StabilityStudy study = read_stability_study(file, common.overrides);
  apply(arguments.choice, study.suite);
  require_comparable({study.suite});
  const ResultsFolder folder(arguments.out, Results::stability, subject_of(file), common.replace);
  const std::vector<StabilityRun> rows = run_stability(
      study, arguments.out, executor, {.command = common.command, .progress = progress(common)});
  print_verdicts(rows, arguments.out, common);
  show_report(arguments.out, common);
  return end_of_rows(mapped(rows, &StabilityRun::row), "stability.csv");
}

/// The verdict, what was left out, and where the results are; or all of it as JSON.
void print_comparison(const CompareResult& result, const std::vector<std::string>& left_out,
                      const std::filesystem::path& folder, const Common& common) {
  if (common.prints_documents()) print_rows(result.rows, common.table);
  if (!print_json({{"headline", result.verdict.headline}, {"rows", result.rows}, {"folder", folder.string()}},
                  common))
    return;
  fmt::print("\n");
  if (std::ranges::any_of(result.rows,
                          [](const RunMetrics& row) { return row.runs_at_a_time.value_or(1) > 1; }))
    fmt::print("times are those of runs that shared the machine\n");
  if (result.reused > 0) fmt::print("{} of {} runs were there already\n", result.reused, result.rows.size());
  print_left_out(left_out);
  fmt::print("results: {}\n\n", one_line(folder.string()));
  for (const std::string& sentence : result.verdict.headline) fmt::print("{}\n", sentence);
}

int run_compare(const CompareArguments& arguments, const Common& common) {
  require_valid(arguments.choice, {"--dt", "--draws", "--history-interval"});
  if (!arguments.trajectories.empty()) {
    const std::string given = "--trajectory " + arguments.trajectories.front();
    if (arguments.inputs.size() > 1) throw InputError(given + ": must be left out of several inputs");
    if (arguments.record) throw InputError(given + ": must be left out beside --record");
  }
  const auto executor = make_executor(arguments.jobs);
  if (!executor->leads()) {
    serve_comparison(
        *executor, [&] { return read_inputs(arguments, common); }, common.command);
    return 0;
  }
  for (const std::string& input : arguments.inputs) {
    const auto file = compared_file(input);
    const InputKind kind = kind_of(file);
    if (kind == InputKind::scene || kind == InputKind::suite) continue;
    refuse(arguments.choice.scenes, input, "--");
    if (arguments.choice.history_interval)
      throw InputError(
          fmt::format("--history-interval {}: must be left out of a study, which keeps no histories",
                      *arguments.choice.history_interval));
    if (arguments.inputs.size() > 1) throw InputError(input + ": a study must be the only input");
    if (arguments.record)
      throw InputError(fmt::format("--record {}: must be left out of a study", *arguments.record));
    if (kind == InputKind::stability_study) return stability_command(file, arguments, *executor, common);
    return study_command(file, arguments.out, common);
  }
  const std::vector<Suite> suites = read_inputs(arguments, common);
  require_comparable(suites);
  const std::string inputs = fmt::format("{}", fmt::join(mapped(arguments.inputs, subject_of), ", "));
  const ResultsFolder folder(arguments.out, Results::comparison, inputs, common.replace);
  for (const Suite& suite : suites)
    for (const NamedScene& scene : suite.scenes) warn_of_sizes(scene.scene, common);
  announce_disk_use(suites, arguments.out, common);
  announce_undecided(suites, common);
  print_legend(suites, common);
  CompareOptions options{.command = common.command, .progress = progress(common)};
  print_rows(suites, common, options);
  const CompareResult result = compare(suites, arguments.out, *executor, options);
#ifdef ROCKSTACK_WITH_PLOTS
  draw_few(suites, arguments.out, common);
#endif
  print_report(arguments.out, common);
  print_comparison(result, engines_left_out(suites), arguments.out, common);
  return end_of_rows(result.rows, "comparison.csv");
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
  command
      .add_option(
          "--trajectory", arguments.trajectories,
          "of a scene: NAME=FILE.csv, a motion that another program has written, beside the engines; may be "
          "repeated, of one name as replicates")
      ->allow_extra_args(false);
  command.add_flag("--forces", arguments.choice.scenes.forces,
                   "of scenes: contact forces of engines that tell them, and impulses of impacts");
  command.add_option(
      "--history-interval", arguments.choice.history_interval,
      "least time between the samples that files keep, s; numbers are of all samples; left out: 1e-3");
  add_results(
      command, arguments.out, [&] { return arguments.inputs.front(); },
      ", where a comparison that was stopped goes on and runs that are done stay");
}

}  // namespace

Command compare_command() {
  return with_tables(make_command("compare", "run scenes or suites on the exact solver and the engines",
                                  add_compare, run_compare));
}

}  // namespace rockstack
