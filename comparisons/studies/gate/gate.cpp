#include "comparisons/studies/gate/gate.hpp"

#include <fmt/format.h>
#include <stdlib.h>  // mkdtemp is POSIX, not in <cstdlib>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/verdict/verdict.hpp"
#include "comparisons/suites/shipped.hpp"
#include "engines/worker/pace.hpp"

namespace rockstack {
namespace {

/// A folder of this process that goes with it.
struct RunsFolder {
  std::filesystem::path path;

  RunsFolder() : path(std::filesystem::temp_directory_path() / "rockstack-gate-XXXXXX") {
    std::string made = path.string();
    if (mkdtemp(made.data()) == nullptr) throw std::runtime_error(made + ": no such folder can be made");
    path = made;
  }
  RunsFolder(const RunsFolder&) = delete;
  RunsFolder& operator=(const RunsFolder&) = delete;
  ~RunsFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// The largest chance with which one number that counts most is reported, however the others come out.
double reporting_chance(const ResultsChange& change) {
  std::size_t tests = 0;
  for (const std::vector<RowChange>* rows : {&change.rows, &change.sets})
    for (const RowChange& row : *rows)
      for (const QuantityChange& one : row.quantities) tests += one.foremost && one.could_show ? 1 : 0;
  return foremost_share * change.level / static_cast<double>(std::max<std::size_t>(1, tests));
}

std::optional<double> least_factor(const std::vector<double>& errors, double chance) {
  constexpr double least = 1.01, most = 1e6, rounding = 1e-12;  // as judge() reports
  const auto is_shown = [&](double factor) {
    const auto grown = mapped(errors, [&](double error) { return factor * error; });
    return median(grown) - median(errors) > rounding && mann_whitney(errors, grown).p_value <= chance;
  };
  if (!is_shown(most)) return {};
  double low = least, high = is_shown(least) ? least : most;
  while (high / low > 1.001) (is_shown(std::sqrt(low * high)) ? high : low) = std::sqrt(low * high);
  return high;
}

template <class Holds>
bool none(const Suite& suite, const Holds& holds) {
  return std::ranges::none_of(suite.scenes, [&](const NamedScene& one) { return holds(one.scene); });
}

}  // namespace

Suite gate_suite(const EngineSeries& engine, const std::optional<std::uint64_t>& seed) {
  Suite suite = read_suite(find_file("gate", "suites"), {});
  const std::vector<double> steps = suite.series.empty()  // its engines are left out of this build
                                        ? std::vector<double>{*default_steps.begin()}
                                        : suite.series.front().steps;
  suite.series = {engine};
  suite.series.front().steps = steps;
  if (seed) suite.replicates.seed = *seed;
  return suite;
}

double expected_time(const Suite& suite, std::size_t cores) {
  const EngineSeries& series = suite.series.front();
  const WorkerPace pace = pace_of(*series.engine, series.parameters, suite.limits);
  const std::vector<Suite> suites{suite};  // jobs keep references to it
  double time = 0;
  for (const Job& job : jobs_of(suites)) {
    if (job.series == nullptr) continue;
    const double block_steps =
        job.scene.scene.duration / job.dt * static_cast<double>(job.scene.scene.blocks.size());
    time += pace.of(1, (1 + suite.repeats) * block_steps) +
            (replicates_of(job).runs - 1) * pace.of(1, block_steps) / static_cast<double>(cores);
  }
  return time;
}

RecordedResults run_gate(const Suite& suite, const std::function<void(const Progress&)>& progress) {
  const RunsFolder folder;
  compare({suite}, folder.path, *make_threads(1), {.progress = progress});
  return read_recorded_results(folder.path);
}

std::vector<RowSensitivity> sensitivities(const ResultsChange& change, const RecordedResults& before) {
  const double chance = reporting_chance(change);
  std::vector<RowSensitivity> rows;
  for (const RowChange& row : change.rows) {
    if (!row.replicated || !is_engine(row.old_row)) continue;
    const auto run = std::ranges::find_if(
        before.runs, [&](const RecordedRun& one) { return one.row.run == row.old_row.run; });
    const std::vector<double> errors = values_of(quantity_named("error"), *run);
    if (!errors.empty()) rows.push_back({&row, median(errors), least_factor(errors, chance)});
  }
  return rows;
}

std::vector<std::string> not_seen(const Suite& suite) {
  std::vector<std::string> list{"motion out of the plane"};
  std::size_t blocks = 0;
  double duration = 0;
  for (const NamedScene& one : suite.scenes) {
    blocks = std::max(blocks, one.scene.blocks.size());
    duration = std::max(duration, one.scene.duration);
  }
  list.push_back(fmt::format("stacks of more than {} blocks", blocks));
  list.push_back(fmt::format("what takes more than {}", quantity_text(duration, "s")));
  list.push_back(fmt::format(
      "time steps other than {}",
      fmt::join(mapped(suite.series.front().steps, [](double dt) { return quantity_text(dt, "s"); }),
                " and ")));
  if (none(suite, [](const Scene& scene) { return !scene.horizontal.empty() || !scene.vertical.empty(); }))
    list.emplace_back("moving ground");
  if (none(suite, [](const Scene& scene) { return scene.point_restitution > 0; }))
    list.emplace_back("restitution");
  return list;
}

}  // namespace rockstack
