#include "comparisons/measures/metrics/alignment.hpp"

#include <set>

namespace rockstack {
namespace {

/// How many pairs an alignment has, and less the sum of their time differences, s: the greater, the better.
using Score = std::pair<int, double>;

/// The impacts of one interface, by their numbers in both sequences.
class InterfaceAlignment {
 public:
  InterfaceAlignment(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                     const std::vector<double>& windows, int interface)
      : exact_(exact),
        engine_(engine),
        windows_(windows),
        exact_numbers_(of_interface(exact, interface)),
        engine_numbers_(of_interface(engine, interface)),
        columns_(engine_numbers_.size() + 1),
        scores_((exact_numbers_.size() + 1) * columns_) {
    for (std::size_t i = exact_numbers_.size(); i-- > 0;)
      for (std::size_t j = engine_numbers_.size(); j-- > 0;)
        scores_[i * columns_ + j] = std::max({at(i + 1, j), at(i, j + 1), paired(i, j)});
  }

  void append_to(std::vector<AlignedImpact>& lines) const {
    std::size_t i = 0, j = 0;
    while (i < exact_numbers_.size() || j < engine_numbers_.size()) {
      const bool both = i < exact_numbers_.size() && j < engine_numbers_.size();
      const bool pair = both && at(i, j) == paired(i, j);
      const bool takes_exact = pair || j == engine_numbers_.size() || (both && at(i + 1, j) >= at(i, j + 1));
      AlignedImpact& line = lines.emplace_back();
      if (pair || !takes_exact) {
        const ImpactTime& impact = engine_at(j++);
        line.interface = impact.interface;
        line.engine = impact.time;
        line.engine_side = impact.side;
      }
      if (takes_exact) {
        const ImpactTime& impact = exact_at(i++);
        line.interface = impact.interface;
        line.number = static_cast<int>(exact_numbers_[i - 1]) + 1;
        line.exact = impact.time;
        line.exact_side = impact.side;
      }
    }
  }

 private:
  static std::vector<std::size_t> of_interface(const std::vector<ImpactTime>& impacts, int interface) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < impacts.size(); ++i)
      if (impacts[i].interface == interface) numbers.push_back(i);
    return numbers;
  }

  const ImpactTime& exact_at(std::size_t i) const { return exact_[exact_numbers_[i]]; }
  const ImpactTime& engine_at(std::size_t j) const { return engine_[engine_numbers_[j]]; }

  /// Of the best alignment of the tails from i and j.
  const Score& at(std::size_t i, std::size_t j) const { return scores_[i * columns_ + j]; }

  /// Of the best one that starts with the pair (i, j); less than any where these cannot be a pair.
  Score paired(std::size_t i, std::size_t j) const {
    const double apart = std::abs(exact_at(i).time - engine_at(j).time);
    if (sign(exact_at(i).side) * sign(engine_at(j).side) < 0 || !(apart <= windows_[exact_numbers_[i]]))
      return {-1, 0};
    return {at(i + 1, j + 1).first + 1, at(i + 1, j + 1).second - apart};
  }

  const std::vector<ImpactTime>& exact_;
  const std::vector<ImpactTime>& engine_;
  const std::vector<double>& windows_;
  std::vector<std::size_t> exact_numbers_, engine_numbers_;
  std::size_t columns_;
  std::vector<Score> scores_;
};

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

/// The largest difference of an interface's relative angle in a stretch of time, rad.
double largest_relative(const Difference& apart, std::size_t interface, double begin, double end) {
  const auto first = std::ranges::lower_bound(apart.times, begin);
  double largest = 0;
  for (auto i = static_cast<std::size_t>(first - apart.times.begin());
       i < apart.times.size() && apart.times[i] <= end; ++i)
    largest = std::max(largest, std::abs(relative_at(apart.at(i), interface)));
  return largest;
}

double window_of(const std::vector<ImpactTime>& exact, std::size_t number, const Difference& apart,
                 double dt) {
  const ImpactTime& impact = exact[number];
  const auto interface = static_cast<std::size_t>(impact.interface - 1);
  const double least = window_steps * dt, widest = std::max(least, widest_window(exact, number));
  double window = least;
  while (window < widest) {
    const double apart_at_most = largest_relative(apart, interface, impact.time - window, impact.time);
    const double wider = least + 2 * apart_at_most / impact.approach;
    if (wider <= window) break;
    window = wider;
  }
  return std::min(window, widest);
}

}  // namespace

std::vector<AlignedImpact> align(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                                 const std::vector<double>& windows) {
  std::set<int> interfaces;
  for (const auto* impacts : {&exact, &engine})
    for (const ImpactTime& impact : *impacts) interfaces.insert(impact.interface);
  std::vector<AlignedImpact> lines;
  for (const int interface : interfaces)
    InterfaceAlignment(exact, engine, windows, interface).append_to(lines);
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
