#include "comparisons/measures/metrics/rest.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/measures/metrics/contact_patterns.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {
std::vector<ImpactTime> settlings(const Scene& scene, const History& history) {
  const double slowest = chatter_speed(scene), least_time = settling_duration(scene);
  std::vector<ImpactTime> list;
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
    const auto is_quiet = [&](std::size_t i) {
      return std::abs(relative_at(history.angles_at(i), k)) <= open_angle &&
             std::abs(relative_at(history.velocities_at(i), k)) < slowest;
    };
    for (std::size_t i = 0; i < history.size(); ++i) {
      if (!is_quiet(i)) continue;
      const std::size_t start = i;
      while (i + 1 < history.size() && is_quiet(i + 1)) ++i;
      if (start > 0 && history.times[i] - history.times[start] >= least_time)
        list.push_back({history.times[start], static_cast<int>(k) + 1, Contact::closed});
    }
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const ImpactTime& a, const ImpactTime& b) { return a.time < b.time; });
  return list;
}

std::optional<double> residual_motion(const History& exact, const History& engine) {
  const std::size_t count = std::min(exact.size(), engine.size());
  const double start = 0.9 * exact.times[count - 1];
  double sum = 0;
  std::size_t values = 0;
  for (std::size_t i = count; i-- > 0 && exact.times[i] >= start;) {
    if (!is_closed(exact.patterns[i])) return {};
    for (const double velocity : engine.velocities_at(i)) {
      sum += velocity * velocity;
      ++values;
    }
  }
  return std::sqrt(sum / static_cast<double>(values));
}

}  // namespace rockstack
