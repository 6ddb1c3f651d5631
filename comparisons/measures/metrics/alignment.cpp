#include "comparisons/measures/metrics/alignment.hpp"

namespace rockstack {
namespace {

/// How many pairs an alignment has, and less the sum of their time differences, s: the greater, the better.
using Score = std::pair<int, double>;

/// The numbers of those of one interface.
std::vector<std::size_t> of_interface(const std::vector<ImpactTime>& impacts, int interface) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < impacts.size(); ++i)
    if (impacts[i].interface == interface) numbers.push_back(i);
  return numbers;
}

void align_interface(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                     const std::vector<double>& windows, int interface, std::vector<AlignedImpact>& lines) {
  const auto firsts = of_interface(exact, interface), seconds = of_interface(engine, interface);
  std::vector<std::vector<Score>> best(firsts.size() + 1,  // of the tails from i and j
                                       std::vector<Score>(seconds.size() + 1));
  // Score of the best alignment that starts with the pair (i, j); less than any where these cannot be a pair.
  const auto paired = [&](std::size_t i, std::size_t j) -> Score {
    const ImpactTime &one = exact[firsts[i]], &other = engine[seconds[j]];
    const double apart = std::abs(one.time - other.time);
    if (sign(one.side) * sign(other.side) < 0 || !(apart <= windows[firsts[i]])) return {-1, 0};
    return {best[i + 1][j + 1].first + 1, best[i + 1][j + 1].second - apart};
  };
  for (std::size_t i = firsts.size(); i-- > 0;)
    for (std::size_t j = seconds.size(); j-- > 0;)
      best[i][j] = std::max({best[i + 1][j], best[i][j + 1], paired(i, j)});
  for (std::size_t i = 0, j = 0; i < firsts.size() || j < seconds.size();) {
    const bool both = i < firsts.size() && j < seconds.size();
    const bool pair = both && best[i][j] == paired(i, j);
    const bool takes_exact = pair || j == seconds.size() || (both && best[i + 1][j] >= best[i][j + 1]);
    AlignedImpact& line = lines.emplace_back();
    line.interface = interface;
    if (pair || !takes_exact) {
      const ImpactTime& impact = engine[seconds[j++]];
      line.engine = impact.time;
      line.engine_side = impact.side;
    }
    if (takes_exact) {
      line.number = static_cast<int>(firsts[i]) + 1;
      const ImpactTime& impact = exact[firsts[i++]];
      line.exact = impact.time;
      line.exact_side = impact.side;
    }
  }
}

double time_of(const AlignedImpact& line) {
  return line.exact ? *line.exact : *line.engine;
}

/// An engine answers one step late, reading takes one more, and the phase between step and impact a third.
constexpr double window_steps = 3;

/// Half the time to the nearest exact impact of the same interface, s.
double widest_window(const std::vector<ImpactTime>& exact, std::size_t number) {
  double widest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < exact.size(); ++i)
    if (i != number && exact[i].interface == exact[number].interface)
      widest = std::min(widest, 0.5 * std::abs(exact[i].time - exact[number].time));
  return widest;
}

/// The largest difference of an interface's gap in a stretch of time, m.
double largest_of(const Difference& apart, std::size_t interface, double begin, double end) {
  const auto first = std::ranges::lower_bound(apart.times, begin);
  double largest = 0;
  for (auto i = static_cast<std::size_t>(first - apart.times.begin());
       i < apart.times.size() && apart.times[i] <= end; ++i)
    largest = std::max(largest, apart.at(i)[interface]);
  return largest;
}

double window_of(const std::vector<ImpactTime>& exact, std::size_t number, const Difference& apart,
                 double dt) {
  const ImpactTime& impact = exact[number];
  const auto interface = static_cast<std::size_t>(impact.interface - 1);
  const double least = window_steps * dt, widest = std::max(least, widest_window(exact, number));
  double window = least;
  while (window < widest) {
    const double apart_at_most = largest_of(apart, interface, impact.time - window, impact.time);
    const double wider = least + 2 * apart_at_most / impact.approach;
    if (wider <= window) break;
    window = wider;
  }
  return std::min(window, widest);
}

}  // namespace

std::vector<AlignedImpact> align(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                                 const std::vector<double>& windows) {
  std::vector<AlignedImpact> lines;
  for (int interface = 1; interface <= max_blocks; ++interface)
    align_interface(exact, engine, windows, interface, lines);
  std::ranges::stable_sort(lines, {}, time_of);
  return lines;
}

std::vector<AlignedImpact> up_to(std::vector<AlignedImpact> alignment, double time) {
  std::erase_if(alignment, [&](const AlignedImpact& line) { return time_of(line) > time; });
  return alignment;
}

AlignmentCounts count(const std::vector<AlignedImpact>& alignment) {
  AlignmentCounts counts;
  double squares = 0;
  for (const AlignedImpact& line : alignment) {
    ++(!line.engine ? counts.missed : !line.exact ? counts.extra : counts.matched);
    const double apart = line.exact && line.engine ? *line.engine - *line.exact : 0;
    squares += apart * apart;
    counts.largest_apart = std::max(counts.largest_apart, std::abs(apart));
  }
  if (counts.matched > 0) counts.rms_apart = std::sqrt(squares / counts.matched);
  return counts;
}

double thread_lost(const std::vector<AlignedImpact>& alignment, int interface) {
  int missed = 0, extra = 0;
  for (const AlignedImpact& line : alignment) {
    if (line.interface != interface) continue;
    if (line.exact && line.engine)
      missed = extra = 0;
    else
      ++(line.exact ? missed : extra);
    if (missed > 1 && extra > 1) return time_of(line);
  }
  return std::numeric_limits<double>::infinity();
}

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
