#include "comparisons/metrics/alignment.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {
namespace {

/// The best alignment of two tails: most pairs first, then least time difference.
struct Score {
  int pairs = 0;
  double difference = 0;  ///< s

  bool better_than(const Score& other) const {
    return pairs != other.pairs ? pairs > other.pairs : difference < other.difference;
  }
};

class Tails {
 public:
  Tails(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine, double window)
      : exact_(exact),
        engine_(engine),
        window_(window),
        columns_(engine.size() + 1),
        scores_((exact.size() + 1) * columns_) {
    for (std::size_t i = exact.size(); i-- > 0;) {
      for (std::size_t j = engine.size(); j-- > 0;) {
        Score best = at(i + 1, j);
        if (at(i, j + 1).better_than(best)) best = at(i, j + 1);
        if (fit(i, j) && paired(i, j).better_than(best)) best = paired(i, j);
        scores_[i * columns_ + j] = best;
      }
    }
  }

  const Score& at(std::size_t i, std::size_t j) const { return scores_[i * columns_ + j]; }

  /// True where the best alignment of the tails from i and j starts with the pair (i, j).
  bool starts_paired(std::size_t i, std::size_t j) const {
    return fit(i, j) && !at(i + 1, j).better_than(paired(i, j)) && !at(i, j + 1).better_than(paired(i, j));
  }

 private:
  bool fit(std::size_t i, std::size_t j) const {
    return exact_[i].interface == engine_[j].interface && sign(exact_[i].side) * sign(engine_[j].side) >= 0 &&
           std::abs(exact_[i].time - engine_[j].time) <= window_;
  }

  Score paired(std::size_t i, std::size_t j) const {
    const Score& rest = at(i + 1, j + 1);
    return {rest.pairs + 1, rest.difference + std::abs(exact_[i].time - engine_[j].time)};
  }

  const std::vector<ImpactTime>& exact_;
  const std::vector<ImpactTime>& engine_;
  double window_;
  std::size_t columns_;
  std::vector<Score> scores_;
};

}  // namespace

std::vector<AlignedImpact> align(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                                 double window) {
  const Tails tails(exact, engine, window);
  std::vector<AlignedImpact> lines;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < exact.size() || j < engine.size()) {
    const bool both = i < exact.size() && j < engine.size();
    const auto number = static_cast<int>(i) + 1;
    if (both && tails.starts_paired(i, j)) {
      lines.push_back(
          {exact[i].interface, number, exact[i].time, engine[j].time, exact[i].side, engine[j].side});
      ++i;
      ++j;
    } else if (j == engine.size() || (both && !tails.at(i, j + 1).better_than(tails.at(i + 1, j)))) {
      lines.push_back({exact[i].interface, number, exact[i].time, {}, exact[i].side, {}});
      ++i;
    } else {
      lines.push_back({engine[j].interface, {}, {}, engine[j].time, {}, engine[j].side});
      ++j;
    }
  }
  return lines;
}

AlignmentCounts count(const std::vector<AlignedImpact>& alignment) {
  AlignmentCounts counts;
  for (const AlignedImpact& line : alignment) {
    ++(!line.engine ? counts.missed : !line.exact ? counts.extra : counts.matched);
  }
  return counts;
}

TimeDifferences time_differences(const std::vector<AlignedImpact>& alignment) {
  TimeDifferences result;
  double squares = 0;
  for (const AlignedImpact& line : alignment) {
    if (!line.exact || !line.engine) continue;
    const double apart = *line.engine - *line.exact;
    squares += apart * apart;
    result.largest = std::max(result.largest, std::abs(apart));
  }
  const int matched = count(alignment).matched;
  if (matched > 0) result.root_mean_square = std::sqrt(squares / matched);
  return result;
}

}  // namespace rockstack
