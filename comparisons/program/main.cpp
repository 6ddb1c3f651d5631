#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "comparisons/program/commands.hpp"

namespace {

using namespace rockstack;

std::string command_line(int count, char** words) {
  std::string line = "rockstack";
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    line += word.find_first_of(" \t[]\"'*$") == std::string::npos ? " " + word : " '" + word + "'";
  }
  return line;
}

int run(int count, char** words) {
  CLI::App app{"Stacked rocking blocks: the exact theory beside physics engines", "rockstack"};
  app.require_subcommand(1);
  app.fallthrough();
  Common common;
  common.command = command_line(count, words);
  app.add_option("--set", common.overrides, "override a scene key: key=value, e.g. blocks.1.height=3")
      ->allow_extra_args(false);
  app.add_flag("--quiet", common.quiet, "print nothing but errors");
  app.add_flag("--json", common.json, "print the result as JSON");

  SolveArguments solve;
  CLI::App* solve_app = app.add_subcommand("solve", "solve a scene exactly");
  solve_app->add_option("scene", solve.scene, "scene file, or a name from `rockstack list scenes`")
      ->required();
  solve_app->add_option("--out", solve.out, "folder for results")->required();
  solve_app->add_option("--step", solve.step, "longest step of the rk4 integrator, s")->capture_default_str();
  solve_app->add_option("--interval", solve.interval, "interval of samples in history.csv, s")
      ->capture_default_str();

  SimulateArguments simulate;
  CLI::App* simulate_app = app.add_subcommand("simulate", "run a scene in one physics engine");
  simulate_app->add_option("scene", simulate.scene, "scene file, or a name from `rockstack list scenes`")
      ->required();
  simulate_app->add_option("--engine", simulate.engine, "engine, or engine:solver")->required();
  simulate_app->add_option("--dt", simulate.dt, "time step, s")->required();
  simulate_app->add_option("--settings", simulate.settings, "parameter set")
      ->check(CLI::IsMember({"default", "tuned"}))
      ->capture_default_str();
  simulate_app->add_option("--out", simulate.out, "folder for results")->required();

  CompareArguments compare;
  CLI::App* compare_app =
      app.add_subcommand("compare", "run scenes or suites on the exact solver and the engines");
  compare_app->add_option("inputs", compare.inputs, "scene or suite files, or names from `rockstack list`")
      ->required();
  compare_app->add_option("--record", compare.record,
                          "record in the place of synthetic motions, scaled to their peak");
  compare_app->add_option("--out", compare.out, "folder for results")->required();

  std::filesystem::path results;
  CLI::App* plot_app = app.add_subcommand("plot", "draw figures and the report from a results folder");
  plot_app->add_option("folder", results, "folder written by `rockstack compare` or `rockstack record`")
      ->required();

  RecordArguments record;
  CLI::App* record_app = app.add_subcommand("record", "measure an accelerogram");
  record_app->add_option("file", record.file, "record, or record:channel")->required();
  record_app->add_option("--out", record.out, "folder for results");
  record_app->add_option("--base-line", record.base_line, "line to take off the accelerations first")
      ->check(CLI::IsMember({"none", "fitted"}))
      ->capture_default_str();

  std::string what;
  CLI::App* list_app = app.add_subcommand("list", "list what there is");
  list_app->add_option("what", what, "scenes, suites or engines")
      ->required()
      ->check(CLI::IsMember({"scenes", "suites", "engines"}));

  try {
    app.parse(count, words);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
  if (*solve_app) return solve_command(solve, common);
  if (*simulate_app) return simulate_command(simulate, common);
  if (*compare_app) return compare_command(compare, common);
  if (*plot_app) return plot_command(results, common);
  if (*record_app) return record_command(record, common);
  return list_command(what, common);
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(count, words);
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "rockstack: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "rockstack: {}\n", error.what());
    return 1;
  }
}
