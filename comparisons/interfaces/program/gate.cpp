#include "comparisons/studies/gate/gate.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/change_report.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

struct GateArguments {
  std::string engine;
  std::filesystem::path baseline;  ///< empty: nothing is judged
  std::string settings = "default";
  std::vector<std::string> parameters;
  std::optional<std::uint64_t> seed;
  ChangeArguments change;
};

/// The one engine that is held to the gate.
EngineSeries gated_series(const GateArguments& arguments) {
  const std::vector<const WorkerEngine*> list = engines_named(arguments.engine);
  if (list.size() > 1)
    throw InputError(
        fmt::format("{}: must be one of its solvers, as {}", arguments.engine, list.front()->full_name()));
  return make_series(*list.front(), arguments.settings, {},
                     read_parameters(arguments.parameters, *list.front()));
}

void require_baseline(const GateArguments& arguments) {
  const std::string how =
      fmt::format("`rockstack gate {} --save FILE` makes one", shell_word(arguments.engine));
  if (arguments.baseline.empty() && arguments.change.save.empty())
    throw InputError("gate: --baseline FILE: missing; " + how);
  if (!arguments.baseline.empty() && !std::filesystem::exists(arguments.baseline))
    throw InputError(fmt::format("{}: no such baseline; {}", arguments.baseline.string(), how));
}

void announce(const Suite& suite, const Common& common) {
  if (!common.prints_text()) return;
  const EngineSeries& series = suite.series.front();
  const std::size_t rows = suite.scenes.size() * series.steps.size();
  fmt::print("{} ({}): {} of {}, {} replicates each: about {}\n", series.engine->full_name(), series.settings,
             counted(rows, "row"), counted(suite.scenes.size(), "scene"), suite.replicates.runs,
             waiting_time(expected_time(suite, all_cores())));
  std::fflush(stdout);
}

Json sensitivity_json(const RowSensitivity& one) {
  return {{"run", one.row->new_row.run},
          {"error", one.error},
          {"factor", one.factor ? Json(*one.factor) : Json()}};
}

/// Which change each row would have shown.
void print_sensitivities(const std::vector<RowSensitivity>& rows, TableForm form) {
  std::vector<TableCells> lines{{"scene", "step", "old error", "is reported from"}};
  for (const RowSensitivity& one : rows)
    lines.push_back({one.row->new_row.scene, quantity_text(one.row->new_row.dt.value_or(0), "s"),
                     fmt::format("{:.2g}", one.error),
                     one.factor ? fmt::format("{:.3g} times that on", *one.factor) : "no growth of it"});
  fmt::print("\n");
  print_table(lines, form);
}

/// Rows of one engine answer the same question, whatever it is called.
ChangeOptions gate_options(ChangeOptions options) {
  options.across = {"engine", "solver", "settings"};
  return options;
}

int run_gate_command(const GateArguments& arguments, const Common& common) {
  refuse_overrides(common, "a gate has scenes of its own");
  require_baseline(arguments);
  read_upper_bounds(arguments.change);
  const RecordedResults before =
      arguments.baseline.empty() ? RecordedResults{} : read_recorded_results(arguments.baseline);
  const Suite suite = gate_suite(gated_series(arguments), arguments.seed);
  announce(suite, common);
  const RecordedResults now = run_gate(suite, progress(common));
  clear_progress(common);
  save_results(now, arguments.change);
  if (arguments.baseline.empty()) {
    if (common.prints_text()) fmt::print("baseline: {}\n", one_line(arguments.change.save.string()));
    return 0;
  }
  const ResultsChange change = hold_against(before, now, gate_options(arguments.change.options));
  const std::vector<RowSensitivity> rows = sensitivities(change, before);
  const int code =
      report_change(change, now, arguments.change, common,
                    {{"sensitivities", mapped(rows, sensitivity_json)}, {"not_seen", not_seen(suite)}}, [&] {
                      print_sensitivities(rows, common.table);
                      fmt::print("not seen: {}\n", joined(not_seen(suite)));
                    });
  if (common.prints_documents()) print_sensitivities(rows, common.table);
  return code;
}

void add_gate(CLI::App& command, GateArguments& arguments) {
  arguments.change.most_lines = 20;
  command
      .add_option("engine", arguments.engine,
                  "a worker program, e.g. ./my_engine.py, or engine:solver from `rockstack list engines`")
      ->required();
  command.add_option("--baseline", arguments.baseline,
                     "what --save has written before: a file, or a folder of `compare gate`");
  command.add_option("--settings", arguments.settings, "its parameter set")
      ->check(one_of({"default", "tuned"}))
      ->capture_default_str();
  command
      .add_option("--parameter", arguments.parameters,
                  "change one of its parameters, erp=0.05; may be repeated")
      ->allow_extra_args(false);
  command.add_option("--seed", arguments.seed, "of replicates; left out: that of the suite `gate`");
  add_change_options(command, arguments.change);
}

}  // namespace

Command gate_command() {
  return with_tables(make_command(
      "gate", "hold an engine to a baseline on small scenes; exit code 1: something got worse, 3: undecided",
      add_gate, run_gate_command));
}

}  // namespace rockstack
