#include "comparisons/measures/metrics/toppling.hpp"

#include <fmt/format.h>

namespace rockstack {
namespace {

/// In the order of TopplingVerdict.
constexpr std::array<const char*, 5> verdict_names{"", "neither", "both", "exact alone", "engine alone"};

}  // namespace

std::string reported_toppling(const History& history) {
  if (history.events.empty() || !ends_motion(history.events.back().kind)) return "";
  return fmt::format("block {} at {} s", history.events.back().interface, history.events.back().time);
}

std::string observed_toppling(const Scene& scene, const History& history) {
  const auto last = history.angles_at(history.size() - 1);
  for (std::size_t k = 0; k < last.size(); ++k)
    if (std::abs(last[k]) > toppling_angle(scene, static_cast<int>(k)))
      return fmt::format("block {} at {} s", k + 1, history.times.back());
  return "";
}

TopplingVerdict toppling_verdict(bool exact, bool engine) {
  if (exact == engine) return exact ? TopplingVerdict::both : TopplingVerdict::neither;
  return exact ? TopplingVerdict::exact_alone : TopplingVerdict::engine_alone;
}

std::string name(TopplingVerdict verdict) {
  return verdict_names.at(static_cast<std::size_t>(verdict));
}

TopplingVerdict named_verdict(const std::string& name) {
  const auto found = std::find(verdict_names.begin(), verdict_names.end(), name);
  return found == verdict_names.end() ? TopplingVerdict::unknown
                                      : static_cast<TopplingVerdict>(found - verdict_names.begin());
}

bool differ(TopplingVerdict verdict) {
  return verdict == TopplingVerdict::exact_alone || verdict == TopplingVerdict::engine_alone;
}

}  // namespace rockstack
