#include "comparisons/studies/lessons/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analytic/solve.hpp"
#include "comparisons/suites/engine_series.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {

History answer(const std::string& engine, const std::string& settings, const Scene& scene, double dt,
               const Parameters& changes) {
  const EngineSeries series = make_series(find_engine(engine), settings, {dt}, changes);
  return simulate(*series.engine, scene, dt, series.parameters).history;
}

History exact_answer(const Scene& scene, double interval) {
  return solve(scene, {.sample_times = regular_times(interval, scene.duration)});
}

const RunMetrics& find_run(const std::vector<RunMetrics>& rows, const std::string& engine,
                           const std::string& settings, double dt) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const RunMetrics& row) {
    return (row.engine == engine || row.engine + ":" + row.solver == engine) && row.settings == settings &&
           row.dt == dt;
  });
  if (found == rows.end())
    throw std::logic_error(fmt::format("lesson: no run of {}, {}, {} s", engine, settings, dt));
  return *found;
}

const Event* first_event(const History& history, EventKind kind) {
  const auto found = std::find_if(history.events.begin(), history.events.end(),
                                  [&](const Event& event) { return event.kind == kind; });
  return found == history.events.end() ? nullptr : &*found;
}

double first_gap(const History& history, int interface, double size) {
  const auto upper = static_cast<std::size_t>(interface) - 1;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto angles = history.angles_at(i);
    if (std::abs(angles[upper] - (upper > 0 ? angles[upper - 1] : 0)) > size) return history.times[i];
  }
  return -1;
}

}  // namespace rockstack
