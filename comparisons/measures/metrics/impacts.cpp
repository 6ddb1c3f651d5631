#include "comparisons/measures/metrics/impacts.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {
namespace {

double stack_height(const Scene& scene) {
  double height = 0;
  for (const Block& block : scene.blocks) height += 2 * block.half_height;
  return height;
}

}  // namespace

Contact side_of(double velocity, double slowest) {
  return std::abs(velocity) < slowest ? Contact::closed : contact_of(velocity < 0 ? -1 : 1);
}

double relative_at(std::span<const double> values, std::size_t interface) {
  return interface == 0 ? values[0] : values[interface] - values[interface - 1];
}

double chatter_speed(const Scene& scene) {
  return 0.02 * std::sqrt(scene.gravity / stack_height(scene));
}

double settling_duration(const Scene& scene) {
  return 0.1 * std::sqrt(stack_height(scene) / scene.gravity);
}

std::vector<ImpactTime> up_to(std::vector<ImpactTime> impacts, double time) {
  std::erase_if(impacts, [&](const ImpactTime& impact) { return impact.time > time; });
  return impacts;
}

std::vector<ImpactTime> reported_impacts(const History& history, double slowest) {
  std::vector<ImpactTime> impacts;
  for (const Event& event : history.events) {
    if (event.kind != EventKind::impact && event.kind != EventKind::closure && event.kind != EventKind::rest)
      continue;
    const auto interface = static_cast<std::size_t>(event.interface - 1);
    const double approach = std::abs(relative_at(event.before, interface));
    if (approach < slowest) continue;
    impacts.push_back(
        {event.time, event.interface, side_of(relative_at(event.after, interface), slowest), approach});
  }
  return impacts;
}

std::vector<ImpactTime> observed_impacts(const History& history, double slowest) {
  std::vector<ImpactTime> impacts;
  for (std::size_t i = 0; i + 1 < history.size(); ++i) {
    const double step = history.times[i + 1] - history.times[i];
    for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
      const double side = relative_at(history.angles_at(i), k) < 0 ? -1 : 1;
      const double gap = side * relative_at(history.angles_at(i), k);
      const double next_gap = side * relative_at(history.angles_at(i + 1), k);
      const double approach = -side * relative_at(history.velocities_at(i), k);
      const double next_approach = -side * relative_at(history.velocities_at(i + 1), k);
      if (approach < slowest) continue;
      const bool passes = next_gap <= 0;
      const bool stops = gap <= approach * step && next_approach < 0.5 * approach;
      if (!passes && !stops) continue;
      const double delay = passes ? step * gap / (gap - next_gap) : gap / approach;
      const std::size_t later = std::min(i + 2, history.size() - 1);
      impacts.push_back({history.times[i] + delay, static_cast<int>(k) + 1,
                         side_of(relative_at(history.velocities_at(later), k), slowest), approach});
    }
  }
  std::stable_sort(impacts.begin(), impacts.end(),
                   [](const ImpactTime& a, const ImpactTime& b) { return a.time < b.time; });
  return impacts;
}

}  // namespace rockstack
