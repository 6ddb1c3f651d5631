#include "comparisons/measures/metrics/toppling.hpp"

#include <fmt/format.h>

namespace rockstack {
namespace {

/// In the order of TopplingVerdict.
constexpr std::array<const char*, 5> verdict_names{"", "neither", "both", "exact alone", "engine alone"};

std::optional<Toppling> reported(const History& history) {
  if (history.events.empty() || !ends_motion(history.events.back().kind)) return {};
  return Toppling{history.events.back().interface, history.events.back().time};
}

std::optional<Toppling> observed(const Scene& scene, const History& history) {
  if (history.times.empty()) return {};
  const auto last = history.angles_at(history.size() - 1);
  for (int k = 0; k < history.blocks; ++k)
    if (std::abs(last[static_cast<std::size_t>(k)]) > toppling_angle(scene, k))
      return Toppling{k + 1, history.times.back()};
  return {};
}

std::string text_of(const std::optional<Toppling>& toppling) {
  return toppling ? fmt::format("block {} at {} s", toppling->block, toppling->time) : "";
}

}  // namespace

std::optional<Toppling> toppling_of(const Scene& scene, const History& history) {
  const std::optional<Toppling> told = reported(history);
  return told ? told : observed(scene, history);
}

std::string reported_toppling(const History& history) {
  return text_of(reported(history));
}

std::string observed_toppling(const Scene& scene, const History& history) {
  return text_of(observed(scene, history));
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
