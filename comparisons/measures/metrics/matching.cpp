#include "comparisons/measures/metrics/matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rockstack {
namespace {

/// An engine answers one step late, reading takes one more, and the phase between step and impact a third.
constexpr double window_steps = 3;

/// Half the time to the nearest exact impact of the same interface, s.
double widest_window(const std::vector<ImpactTime>& exact, std::size_t number) {
  double widest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (i == number || exact[i].interface != exact[number].interface) continue;
    widest = std::min(widest, 0.5 * std::abs(exact[i].time - exact[number].time));
  }
  return widest;
}

/// The largest difference of an interface's relative angle in a stretch of time, rad.
double largest_relative(const Difference& apart, std::size_t interface, double begin, double end) {
  const auto first = std::lower_bound(apart.times.begin(), apart.times.end(), begin);
  double largest = 0;
  for (auto i = static_cast<std::size_t>(first - apart.times.begin());
       i < apart.times.size() && apart.times[i] <= end; ++i) {
    const std::span blocks(apart.values.data() + i * apart.blocks, apart.blocks);
    largest = std::max(largest, std::abs(relative_at(blocks, interface)));
  }
  return largest;
}

double window_of(const std::vector<ImpactTime>& exact, std::size_t number, const Difference& apart,
                 double dt) {
  const ImpactTime& impact = exact[number];
  const double least = window_steps * dt, widest = std::max(least, widest_window(exact, number));
  double window = least;
  while (window < widest) {
    const double drift = 2 *
                         largest_relative(apart, static_cast<std::size_t>(impact.interface - 1),
                                          impact.time - window, impact.time) /
                         impact.approach;
    const double wider = least + drift;
    if (wider <= window) break;
    window = wider;
  }
  return std::min(window, widest);
}

}  // namespace

std::vector<double> matching_windows(const std::vector<ImpactTime>& exact, const Difference& apart,
                                     double dt) {
  std::vector<double> windows;
  for (std::size_t i = 0; i < exact.size(); ++i) windows.push_back(window_of(exact, i, apart, dt));
  return windows;
}

std::vector<double> still_windows(const std::vector<ImpactTime>& exact, double dt) {
  return std::vector<double>(exact.size(), window_steps * dt);
}

}  // namespace rockstack
