#include "comparisons/studies/canon/canon.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

struct CanonArguments {
  std::vector<std::string> engines;  ///< empty: all
  std::vector<std::string> settings{"default", "tuned"};
  std::filesystem::path out;
};

void print(const CanonRow& row, const CanonAnswer& answer) {
  fmt::print("{:<28} {:<8} {:<16} {:<12} {}\n", row.engine->full_name(), row.settings, answer.scene,
             answer.verdict, answer.reason);
  std::fflush(stdout);
}

int run_canon(const CanonArguments& arguments, const Common& common) {
  Suite suite = read_suite(find_file("canon", "suites"), common.overrides);
  const std::vector<const WorkerEngine*> asked = engines_named(arguments.engines, [] { return engines(); });
  const ResultsFolder folder(arguments.out, Results::canon);
  if (common.prints_text())
    fmt::print("{:<28} {:<8} {:<16} {:<12} by a fit over steps of {:g} to {:g} ms\n", "engine", "set",
               "scene", "verdict", 1e3 * canon_steps.front(), 1e3 * canon_steps.back());
  const auto show = progress(common);
  const std::size_t total = asked.size() * arguments.settings.size() * suite.scenes.size();
  std::size_t done = 0, off = 0;
  std::vector<CanonRow> rows;
  for (const WorkerEngine* engine : asked) {
    for (const std::string& settings : arguments.settings) {
      CanonRow& row = rows.emplace_back(CanonRow{engine, settings, {}});
      for (const NamedScene& scene : suite.scenes) {
        const std::string what = fmt::format("{} {} {}", engine->full_name(), settings, scene.name);
        show({done++, total, "", what, {}});
        row.answers.push_back(kept_canon_answer(suite, scene, *engine, settings, arguments.out / "answers"));
        if (!follows_law(row.answers.back())) ++off;
        clear_progress(common);
        if (common.prints_text()) print(row, row.answers.back());
      }
    }
  }
  const std::string json = canon_json(suite, rows, common.command);
  write_file(arguments.out / "canon.csv", canon_csv(rows));
  write_file(arguments.out / "canon.json", json);
  if (common.json) fmt::print("{}", json);
  show_report(arguments.out, common);
  if (common.prints_text())
    fmt::print("{}\n{} of {} answers neither agree nor converge{}\n", canon_headline(suite, rows), off, total,
               off > 0 ? ": exit code 1" : "");
  return off == 0 ? 0 : 1;
}

void add_canon(CLI::App& command, CanonArguments& arguments) {
  command.add_option("engines", arguments.engines,
                     "worker programs, or names from `rockstack list engines`; left out: all");
  add_settings(command, arguments.settings);
  add_results(
      command, arguments.out, [&] { return arguments.engines.empty() ? "all" : arguments.engines.front(); },
      ", where a canon that was stopped goes on");
}

}  // namespace

Command canon_command() {
  return make_command("canon", "run small scenes with closed forms on engines: which law do they follow?",
                      add_canon, run_canon);
}

}  // namespace rockstack
