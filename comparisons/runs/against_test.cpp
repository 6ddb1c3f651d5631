#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {

void compare_with_test(const Job& job, const Scene& scene, const History& history,
                       const std::optional<BodyRecord>& bodies, RunMetrics& row, RunFiles& files) {
  if (!job.scene.measured) return;
  const Measurement& measured = *job.scene.measured;
  const auto readings =
      readings_of(measured, scene, history, bodies ? bodies->centres : centres_of(scene, history));
  const std::size_t width = measured.columns.size();
  CsvWriter csv;
  csv.line("time", numbered("measured_", static_cast<int>(width)),
           numbered("motion_", static_cast<int>(width)));
  const double horizon = horizon_of(job);
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < measured.times.size() && measured.times[i] <= history.times.back(); ++i) {
    const double time = measured.times[i];
    const auto after = std::ranges::upper_bound(history.times, time);
    const auto next = std::min(static_cast<std::size_t>(after - history.times.begin()), history.size() - 1);
    const std::size_t last = next == 0 ? 0 : next - 1;
    const double share =
        next == last ? 0 : (time - history.times[last]) / (history.times[next] - history.times[last]);
    std::vector<std::optional<double>> seen, motion;
    for (std::size_t k = 0; k < width; ++k) {
      const double reading = measured.values[i * width + k];
      motion.push_back(std::lerp(readings[last * width + k], readings[next * width + k], share));
      seen.push_back(std::isnan(reading) ? std::nullopt : std::optional(reading));
      if (!seen.back() || time > horizon) continue;
      squares += std::pow(*motion.back() - reading, 2);
      ++count;
    }
    csv.line(time, seen, motion);
  }
  if (job.suite.wanted.angles && count > 0) row.rms_test_difference = std::sqrt(squares / count);
  if (job.suite.wanted.histories) files["readings.csv"] = csv.text();
}

}  // namespace rockstack
