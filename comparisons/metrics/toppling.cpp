#include "comparisons/metrics/toppling.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rockstack {

std::string reported_toppling(const History& history) {
  if (history.events.empty() || history.events.back().kind != EventKind::topple) return "";
  return fmt::format("block {} at {} s", history.events.back().interface, history.events.back().time);
}

std::string observed_toppling(const Scene& scene, const History& history) {
  const auto last = history.angles_at(history.size() - 1);
  for (std::size_t k = 0; k < last.size(); ++k) {
    if (std::abs(last[k]) <= toppling_angle(scene, static_cast<int>(k))) continue;
    return fmt::format("block {} at {} s", k + 1, history.times.back());
  }
  return "";
}

std::string toppling_verdict(bool exact, bool engine) {
  if (exact == engine) return exact ? "both" : "neither";
  return exact ? "exact alone" : "engine alone";
}

}  // namespace rockstack
