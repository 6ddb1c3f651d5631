#include "comparisons/studies/canon/canon.hpp"

#include <cstdio>

#include "comparisons/interfaces/program/check_engine.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

/// Answers as they come, and how long the rest may take.
class CanonTeller {
 public:
  CanonTeller(const Suite& suite, const std::vector<CanonRow>& rows, const Common& common)
      : suite_(suite), show_(progress(common)) {
    for (const CanonRow& row : rows)
      paces_.push_back(
          pace_of(*row.engine, make_series(*row.engine, row.settings, {}).parameters, suite.limits));
    total_ = rows.size() * suite.scenes.size();
    if (common.prints_text())
      fmt::print("answers: {}, in about {}; scene {} comes first, in {}\n", total_, waiting_time(rest(0, 0)),
                 suite.scenes.front().name, waiting_time(rest(0, 0) - rest(1, 0)));
    table_.emplace(
        std::vector<TableColumn>{{"engine", 28, false, 0},
                                 {"set", 8},
                                 {"scene", 16},
                                 {"verdict", 12},
                                 {fmt::format("by a fit over steps of {:g} to {:g} ms",
                                              1e3 * canon_steps.front(), 1e3 * canon_steps.back())}},
        common);
  }

  void begins(std::size_t scene, std::size_t row, const CanonRow& of) {
    const std::string what =
        fmt::format("{} {} {}", of.engine->full_name(), of.settings, suite_.scenes[scene].name);
    show_({scene * paces_.size() + row, total_, "", what, rest(scene, row)});
  }

  void tell(const CanonRow& row) const {
    const CanonAnswer& answer = row.answers.back();
    table_->print({row.engine->full_name(), row.settings, answer.scene, answer.verdict, answer.reason});
  }

 private:
  /// Time of all answers from this one on, s.
  double rest(std::size_t scene, std::size_t row) const {
    double time = 0;
    for (; scene < suite_.scenes.size(); ++scene, row = 0)
      for (std::size_t i = row; i < paces_.size(); ++i)
        time += canon_time(paces_[i], suite_, suite_.scenes[scene]);
    return time;
  }

  const Suite& suite_;
  std::function<void(const Progress&)> show_;
  std::vector<WorkerPace> paces_;  ///< of each row
  std::optional<PrintedTable> table_;
  std::size_t total_ = 0;
};

std::vector<CanonRow> asked_rows(const CheckEngineArguments& arguments) {
  std::vector<CanonRow> rows;
  for (const WorkerEngine* engine : engines_named(arguments.engines, [] { return engines(); }))
    for (const std::string& settings : arguments.settings) rows.push_back({engine, settings, {}});
  return rows;
}

void add_canon(CLI::App& command, CheckEngineArguments& arguments) {
  add_check_engine(command, arguments);
  arguments.canon = true;
}

}  // namespace

int run_canon(const CheckEngineArguments& arguments, const Common& common) {
  const std::filesystem::path out =
      arguments.out.empty()
          ? default_results("canon", arguments.engines.empty() ? "all" : arguments.engines.front())
          : arguments.out;
  Suite suite = read_suite(find_file("canon", "suites"), common.overrides);
  suite.scenes = chosen_from(suite.scenes, arguments.scenes, std::mem_fn(&NamedScene::name));
  std::vector<CanonRow> rows = asked_rows(arguments);
  const ResultsFolder folder(out, Results::canon);
  CanonTeller teller(suite, rows, common);
  std::size_t off = 0;
  for (std::size_t scene = 0; scene < suite.scenes.size(); ++scene) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CanonRow& row = rows[i];
      teller.begins(scene, i, row);
      row.answers.push_back(
          kept_canon_answer(suite, suite.scenes[scene], *row.engine, row.settings, out / "answers"));
      if (!follows_law(row.answers.back())) ++off;
      teller.tell(row);
    }
  }
  const std::string json = canon_json(suite, rows, common.command);
  write_file(out / "canon.csv", canon_csv(rows));
  write_file(out / "canon.json", json);
  if (common.json) fmt::print("{}", json);
  show_report(out, common);
  if (common.prints_text())
    fmt::print("{}\n{} of {} answers neither agree nor converge{}\n", canon_headline(suite, rows), off,
               rows.size() * suite.scenes.size(), off > 0 ? ": exit code 1" : "");
  return off == 0 ? 0 : 1;
}

Command canon_command() {
  return with_tables(make_command(
      "canon", "check-engine --canon: which law of contact does an engine follow?", add_canon, run_canon));
}

}  // namespace rockstack
