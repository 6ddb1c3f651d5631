#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/canon/canon.hpp"
#include "comparisons/suites/shipped.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {
namespace {

void print(const CanonRow& row, const CanonAnswer& answer) {
  fmt::print("{:<28} {:<8} {:<16} {:<12} {}\n", row.engine->full_name(), row.settings, answer.scene,
             answer.verdict, answer.reason);
  std::fflush(stdout);
}

}  // namespace

int canon_command(const CanonArguments& arguments, const Common& common) {
  Suite suite = read_suite(find_file("canon", "suites"), common.overrides);
  const std::vector<const WorkerEngine*> asked = engines_named(arguments.engines, [] { return engines(); });
  const std::vector<std::string> sets = both_if_empty(arguments.settings);
  const ResultsFolder folder(arguments.out, Results::canon);
  const bool talk = !common.quiet && !common.json;
  if (talk)
    fmt::print("{:<28} {:<8} {:<16} {:<12} by a fit over steps of {:g} to {:g} ms\n", "engine", "set",
               "scene", "verdict", 1e3 * canon_steps.front(), 1e3 * canon_steps.back());
  const auto show = progress(common);
  const std::size_t total = asked.size() * sets.size() * suite.scenes.size();
  std::size_t done = 0, off = 0;
  std::vector<CanonRow> rows;
  for (const WorkerEngine* engine : asked) {
    for (const std::string& settings : sets) {
      CanonRow& row = rows.emplace_back(CanonRow{engine, settings, {}});
      for (const NamedScene& scene : suite.scenes) {
        const std::string what = fmt::format("{} {} {}", engine->full_name(), settings, scene.name);
        show({done++, total, "", what, {}});
        row.answers.push_back(kept_canon_answer(suite, scene, *engine, settings, arguments.out / "answers"));
        if (!follows_law(row.answers.back())) ++off;
        clear_progress(common);
        if (talk) print(row, row.answers.back());
      }
    }
  }
  const std::string json = canon_json(suite, rows, common.command);
  write_file(arguments.out / "canon.csv", canon_csv(rows));
  write_file(arguments.out / "canon.json", json);
  if (common.json) fmt::print("{}", json);
  show_report(arguments.out, common);
  if (talk)
    fmt::print("{} of {} answers neither agree nor converge{}\n", off, total, off > 0 ? ": exit code 1" : "");
  return off == 0 ? 0 : 1;
}

}  // namespace rockstack
