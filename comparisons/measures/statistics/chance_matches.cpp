#include "comparisons/measures/statistics/chance_matches.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "comparisons/measures/metrics/alignment.hpp"
#include "comparisons/measures/statistics/draws.hpp"
#include "comparisons/measures/statistics/quantile.hpp"

namespace rockstack {
namespace {

constexpr int chance_draws = 101;  // an odd number, whose median is one of them

/// Draws 101 sequences and takes the median of how many impacts match.
template <class Draw>
int median_matched(const std::vector<ImpactTime>& exact, const std::vector<double>& windows,
                   const Draw& drawn) {
  std::vector<double> matched;
  for (std::uint64_t run = 0; run < chance_draws; ++run) {
    std::vector<ImpactTime> impacts = drawn(run);
    std::stable_sort(impacts.begin(), impacts.end(),
                     [](const ImpactTime& a, const ImpactTime& b) { return a.time < b.time; });
    matched.push_back(count(align(exact, impacts, windows)).matched);
  }
  return static_cast<int>(median(std::move(matched)));
}

double uniform(double low, double high, std::uint64_t run, std::size_t key) {
  return draw({Distribution::Kind::uniform, low, high}, {1, run, static_cast<std::uint32_t>(key)});
}

}  // namespace

ChanceMatches chance_matches(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                             const std::vector<double>& windows, double duration) {
  const auto random = [&](std::uint64_t run) {
    std::vector<ImpactTime> impacts = engine;
    for (std::size_t i = 0; i < impacts.size(); ++i) impacts[i].time = uniform(0, duration, run, i);
    return impacts;
  };
  const auto shifted = [&](std::uint64_t run) {
    std::vector<ImpactTime> impacts = engine;
    const double shift = uniform(0.1 * duration, 0.9 * duration, run, 0);
    for (ImpactTime& impact : impacts) impact.time = std::fmod(impact.time + shift, duration);
    return impacts;
  };
  return {median_matched(exact, windows, random), median_matched(exact, windows, shifted)};
}

}  // namespace rockstack
