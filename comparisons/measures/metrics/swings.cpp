#include "comparisons/measures/metrics/swings.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {

double angle_at(const History& history, std::size_t block, double time) {
  const auto after = std::lower_bound(history.times.begin(), history.times.end(), time);
  const auto last = static_cast<std::ptrdiff_t>(history.size()) - 1;
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - history.times.begin(), 1, last));
  const double fraction = (time - history.times[i - 1]) / (history.times[i] - history.times[i - 1]);
  const double from = history.angles_at(i - 1)[block];
  return from + fraction * (history.angles_at(i)[block] - from);
}

std::vector<Swing> swings(const History& history, std::size_t block) {
  std::vector<Swing> list(1);
  double side = history.angles_at(0)[block];
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double angle = history.angles_at(i)[block];
    if (angle * side < 0) {
      list.back().end = history.times[i];
      list.emplace_back();
      side = angle;
    }
    if (std::abs(angle) > list.back().peak) {
      list.back().peak = std::abs(angle);
      list.back().peak_time = history.times[i];
    }
  }
  return list;
}

Swing largest_swing(const History& history, std::size_t block) {
  const auto list = swings(history, block);
  return *std::max_element(list.begin(), list.end(),
                           [](const Swing& a, const Swing& b) { return a.peak < b.peak; });
}

}  // namespace rockstack
