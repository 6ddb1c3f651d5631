#include "comparisons/runs/advise.hpp"

#include <limits>

#include "comparisons/results/files.hpp"
#include "comparisons/results/tables.hpp"
#include "comparisons/runs/identity.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {
namespace {

Suite suite_of(const NamedScene& scene, const Wish& wish) {
  Suite suite;
  suite.title = scene.scene.title;
  suite.scenes = {scene};
  suite.wanted = {.angles = true, .impacts = false, .patterns = false, .bodies = false, .histories = false};
  suite.repeats = wish.repeats;
  suite.limits = wish.limits;
  for (const WorkerEngine& engine : engines())
    suite.series.push_back(make_series(engine, "tuned", advised_steps()));
  return suite;
}

}  // namespace

std::vector<double> advised_steps() {
  return {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5};
}

bool meets(const RunMetrics& row, double error) {
  return row.status == RunStatus::done && row.largest_angle_difference &&
         *row.largest_angle_difference <= error && !differ(row.toppling_verdict);
}

int cheapest(const std::vector<RunMetrics>& rows, double error) {
  int best = -1;
  double time = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!meets(rows[i], error) || !(rows[i].stepping_time_minimum.value_or(time) < time)) continue;
    time = *rows[i].stepping_time_minimum;
    best = static_cast<int>(i);
  }
  return best;
}

Advice advise(const NamedScene& scene, const Wish& wish, const std::filesystem::path& folder,
              const std::string& command) {
  const Suite suite = suite_of(scene, wish);
  Advice advice;
  std::vector<bool> given_up(suite.series.size(), false);
  for (const double dt : advised_steps()) {
    for (std::size_t i = 0; i < suite.series.size(); ++i) {
      if (given_up[i]) continue;
      const Job job{suite, scene, dt, &suite.series[i]};
      const auto made = finished_run(folder / "runs" / describe(job).run, identity(job));
      const RunMetrics row = made ? *made : measure(job, folder, command, 1);
      advice.rows.push_back(row);
      advice.pick = cheapest(advice.rows, wish.error);
      const double best = advice.pick < 0
                              ? std::numeric_limits<double>::infinity()
                              : *advice.rows[static_cast<std::size_t>(advice.pick)].stepping_time_minimum;
      given_up[i] = meets(row, wish.error) || row.status == RunStatus::time_limit ||
                    row.stepping_time_minimum.value_or(0) > best;
    }
  }
  write_file(folder / "advice.csv", comparison_csv(advice.rows));
  return advice;
}

}  // namespace rockstack
