#include <fmt/format.h>

#include <cstdio>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/check_engine.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "engines/conformance/check.hpp"
#include "engines/worker/pace.hpp"

namespace rockstack {
namespace {

/// What became of a check.
struct Finding {
  std::string engine, settings, check;
  std::string what = {};           ///< of the value, with its unit; or the reason
  std::string verdict = "no run";  ///< or "holds", "fails", "known limit"
  double value = std::numeric_limits<double>::quiet_NaN(),
         limit = value;      ///< not numbers where none is known
  std::size_t warnings = 0;  ///< of its runs
};

/// A worker that does not answer costs a row.
const Limits limits;

/// `warnings` counts those of all runs.
Adapter adapter_of(const WorkerEngine& engine, const std::string& settings, std::size_t& warnings) {
  const Capabilities& able = engine.capabilities;
  return {able.single_precision,
          able.center_of_mass,
          able.applied_forces,
          settings == "tuned" ? able.tuned_lead : able.lead,
          make_series(engine, settings, {}).parameters,
          [&engine, &warnings](const Setup& setup, const Parameters& given) {
            Trajectory made = run(engine, setup, given, true, limits, 0, true);
            warnings += made.warnings;
            return made;
          }};
}

Finding judge(const WorkerEngine& engine, const std::string& settings, const Check& check) {
  Finding finding{engine.full_name(), settings, check.name};
  const std::string limit = known_limit(engine.name, engine.solver, settings, check.name);
  try {
    const Judgement verdict = check.judge(adapter_of(engine, settings, finding.warnings));
    finding.verdict = verdict.holds() ? "holds" : "fails";
    finding.value = verdict.value;
    finding.limit = verdict.limit;
    finding.what = verdict.what;
  } catch (const std::exception& error) {
    finding.what = error.what();
  }
  if (finding.verdict == "holds" || limit.empty()) return finding;
  finding.verdict = "known limit";
  finding.what = limit;
  return finding;
}

/// The finest step and the longest scene that come with the program: 0.1 ms and 25 s.
constexpr double most_steps = 250000;

/// Empty, or what the user of a slow worker meets.
std::string slowness(double step_time) {
  if (most_steps * step_time < limits.time) return "";
  return fmt::format("; slow: 25 s of motion at 0.1 ms a step take {:.0f} s, more than a run's {:.0f} s",
                     most_steps * step_time, limits.time);
}

/// Time that checks may take with a parameter set, s.
double expected_time(const WorkerEngine& engine, const std::string& settings,
                     const std::vector<Check>& chosen) {
  std::size_t warnings = 0;
  const Adapter adapter = adapter_of(engine, settings, warnings);
  const WorkerPace pace = pace_of(engine, adapter.parameters, limits);
  double time = 0;
  for (const Check& check : chosen) {
    const CheckWork work = work_of(check, adapter);
    time += pace.of(static_cast<double>(work.runs), static_cast<double>(work.block_steps));
  }
  return time;
}

/// What an engine says of itself, and what a run of a resting block tells that is asked for everything that
/// an answer may have: the wall time of a step and the processor time of the whole worker for a hundred steps
/// and as many timed ones, s. @throws std::runtime_error where it is not done.
Json capabilities_json(const WorkerEngine& engine, const std::string& settings) {
  const Scene scene = at_rest({make_block(1, 1, 2500)}, 0.1);
  const Parameters parameters = make_series(engine, settings, {}).parameters;
  const WorkerRun made = run_in_worker(engine, scene, 1e-3, parameters, 1, limits, true);
  if (made.status != "done") throw std::runtime_error(made.status + ": " + made.reason);
  const Capabilities& able = engine.capabilities;
  return {{"engine", engine.full_name()},
          {"version", engine.version},
          {"licence", engine.licence},
          {"worker", engine.program.string()},
          {"largest_friction", std::isfinite(able.largest_friction) ? Json(able.largest_friction) : Json()},
          {"kinetic_friction", able.kinetic_friction},
          {"single_precision", able.single_precision},
          {"planar", able.planar},
          {"center_of_mass", able.center_of_mass},
          {"applied_forces", able.applied_forces},
          {"lead", able.lead},
          {"tuned_lead", able.tuned_lead},
          {"moves_ground", engine.default_parameters().count("shaking") != 0},
          {"tells_contacts", made.run.bodies->contacts.has_value()},
          {"step_time", made.seconds.front() / static_cast<double>(made.run.history.size() - 1)},
          {"processor_time", made.processor_time},
          {"settings", mapped(engine.settings, [](const Setting& setting) {
             return Json{
                 {"name", setting.name},   {"unit", setting.unit},   {"default", setting.default_value},
                 {"tuned", setting.tuned}, {"least", setting.least}, {"most", setting.most}};
           })}};
}

void print_capabilities(const Json& able) {
  const auto yes = [&](const char* key) { return able[key].get<bool>() ? "yes" : "no"; };
  fmt::print("{}  {}\n", able["engine"].get<std::string>(), able["version"].get<std::string>());
  fmt::print(
      "  friction up to {}, {}; {} precision; planar {}; centre of mass off the middle: {}; pushes and restraints: {}; places lead by {} "
      "steps; really moves the ground: {}; tells contacts: {}; {} settings\n  a step takes {}, the whole worker "
      "for two hundred {}{}\n",
      able["largest_friction"].is_null() ? "any" : able["largest_friction"].dump(),
      able["kinetic_friction"].get<bool>() ? "static and kinetic" : "one coefficient",
      able["single_precision"].get<bool>() ? "single" : "double",
      able["planar"].get<bool>() ? "by nature" : "by constraint", yes("center_of_mass"),
      yes("applied_forces"),
      able["lead"] == able["tuned_lead"] ? able["lead"].dump()
                                         : able["lead"].dump() + ", tuned " + able["tuned_lead"].dump(),
      yes("moves_ground"), yes("tells_contacts"), able["settings"].size(),
      quantity_text(able["step_time"].get<double>(), "s"),
      quantity_text(able["processor_time"].get<double>(), "s"), slowness(able["step_time"].get<double>()));
}

/// As text an engine's name stands above its findings.
std::vector<TableColumn> finding_columns(TableForm form) {
  std::vector<TableColumn> columns{
      {"set", 8, false, 2}, {"check", 32}, {"verdict", 11}, {"value of limit", 24}, {"meaning", 0, false, 2}};
  if (form != TableForm::text) columns.insert(columns.begin(), TableColumn{"engine"});
  return columns;
}

void print_finding(const Finding& finding, TableForm form) {
  TableCells cells{
      finding.settings, finding.check, finding.verdict,
      std::isnan(finding.value) ? "" : fmt::format("{:>10.3g} of {:<10.3g}", finding.value, finding.limit),
      finding.what + (finding.warnings > 0 ? fmt::format("; {} warnings", finding.warnings) : "")};
  if (form != TableForm::text) cells.insert(cells.begin(), finding.engine);
  fmt::print("{}", table_line(finding_columns(form), cells, form));
  std::fflush(stdout);
}

bool is_broken(const Finding& finding) {
  return finding.verdict == "fails" || finding.verdict == "no run";
}

/// Says at once what does not hold, whatever is printed of all checks in the end.
void announce_failure(const Finding& finding) {
  const std::string size = std::isnan(finding.value)
                               ? ""
                               : fmt::format(" is {:.3g}, of at most {:.3g}", finding.value, finding.limit);
  fmt::print(stderr, "first failure: {} of {}, {}: {}{}\n", finding.check, finding.engine, finding.settings,
             one_line(finding.what), size);
}

Json to_json(const Finding& finding) {
  return {{"engine", finding.engine},   {"settings", finding.settings}, {"check", finding.check},
          {"verdict", finding.verdict}, {"value", finding.value},       {"limit", finding.limit},
          {"what", finding.what},       {"warnings", finding.warnings}};
}

/// "24 checks hold", or how many do not, and the first.
std::string headline(const std::vector<Finding>& findings) {
  const auto broken = std::ranges::count_if(findings, is_broken);
  const auto first = std::ranges::find_if(findings, is_broken);
  if (first == findings.end()) return fmt::format("0 of {} checks do not hold", findings.size());
  return fmt::format("{} of {} checks do not hold; the first: {} of {}, {}", broken, findings.size(),
                     first->check, first->engine, first->settings);
}

/// An engine under its parameter sets, each finding told as it comes; returns what the engine says of itself.
Json check_sets(const WorkerEngine& engine, const CheckEngineArguments& arguments,
                const std::vector<Check>& chosen, const Common& common,
                const std::function<void(const Finding&)>& tell) {
  Json able;
  try {
    able = capabilities_json(engine, arguments.settings.front());
  } catch (const std::exception& error) {
    tell({engine.full_name(), arguments.settings.front(), "FirstRun", error.what()});
    return able;
  }
  if (common.prints_text()) print_capabilities(able);
  for (const std::string& settings : arguments.settings) {
    // What no check can be held to is not run, unless checks are named.
    const std::string beyond =
        arguments.scenes.empty() ? known_limit(engine.name, engine.solver, settings, "*") : "";
    if (!beyond.empty()) {
      tell({engine.full_name(), settings, "all", beyond, "known limit"});
      continue;
    }
    if (common.prints_text()) {
      fmt::print("  {}: {} in about {}\n", settings, counted(chosen.size(), "check"),
                 waiting_time(expected_time(engine, settings, chosen)));
      std::fflush(stdout);
    }
    for (const Check& check : chosen) tell(judge(engine, settings, check));
  }
  return able;
}

/// The short form: some forty laws.
int check_laws(const CheckEngineArguments& arguments, const Common& common) {
  refuse_overrides(common, "its scenes are its own");
  const std::vector<Check> chosen = chosen_from(checks(), arguments.scenes, std::mem_fn(&Check::name));
  std::optional<ResultsFolder> folder;
  if (!arguments.out.empty()) folder.emplace(arguments.out, Results::canon);
  Json report{{"engines", Json::array()}};
  std::vector<Finding> findings;
  if (common.prints_documents()) fmt::print("{}", table_head(finding_columns(common.table), common.table));
  for (const WorkerEngine* engine : engines_named(arguments.engines, [] { return engines(); })) {
    Json able = check_sets(*engine, arguments, chosen, common, [&](const Finding& finding) {
      const bool first = is_broken(finding) && std::ranges::none_of(findings, is_broken);
      findings.push_back(finding);
      if (common.prints_tables()) print_finding(finding, common.table);
      if (first) announce_failure(finding);
    });
    if (!able.is_null()) report["engines"].push_back(std::move(able));
  }
  if (common.prints_documents()) fmt::print("{}", table_foot(common.table));
  const auto broken = std::ranges::count_if(findings, is_broken);
  report["checks"] = mapped(findings, to_json);
  report["broken"] = broken;
  if (print_json(report, common)) fmt::print("{}\n", headline(findings));
  if (arguments.out.empty()) return broken == 0 ? 0 : 1;
  report.update({{"title", "Which laws an engine follows"},
                 {"headline", headline(findings) + "."},
                 {"tables", {"checks.csv"}},
                 {"command", common.command}});
  write_file(arguments.out / "checks.csv", csv_of(report["checks"]));
  write_file(arguments.out / "checks.json", report.dump(2) + "\n");
  show_report(arguments.out, common);
  return broken == 0 ? 0 : 1;
}

int run_check_engine(const CheckEngineArguments& arguments, const Common& common) {
  return arguments.canon ? run_canon(arguments, common) : check_laws(arguments, common);
}

}  // namespace

void add_check_engine(CLI::App& command, CheckEngineArguments& arguments) {
  command.add_option(
      "engines", arguments.engines,
      "worker programs, e.g. ./my_engine.py, or names from `rockstack list engines`; left out: all");
  add_settings(command, arguments.settings);
  command
      .add_option("--scene,--check", arguments.scenes,
                  "names of scenes: of checks, or of the canon; left out: all")
      ->delimiter(',');
  command.add_flag("--canon", arguments.canon,
                   "the long form: sixteen scenes, most with a closed form, at five steps");
  command.add_option(
      "--out", arguments.out,
      "folder for results, where a canon that was stopped goes on; left out: none are written, of "
      "a canon rockstack-results/canon-ENGINE");
}

Command check_engine_command() {
  return with_tables(make_command("check-engine", "hold engines to the laws that every engine must follow",
                                  add_check_engine, run_check_engine));
}

}  // namespace rockstack
