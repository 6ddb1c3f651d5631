#include "comparisons/measures/metrics/contact_patterns.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {
namespace {

/// The contacts of one interface, sample by sample, from its relative angles.
std::vector<Contact> contacts(const std::vector<double>& times, const std::vector<double>& angles,
                              double least_time) {
  const std::size_t count = angles.size();
  std::vector<Contact> list(count, Contact::closed);
  const auto open_side = [&](std::size_t i) {
    return std::abs(angles[i]) <= open_angle ? Contact::closed : contact_of(angles[i] < 0 ? -1 : 1);
  };
  for (std::size_t i = 0; i < count; ++i) list[i] = open_side(i);
  for (std::size_t i = 0; i < count;) {
    if (list[i] != Contact::closed) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < count && open_side(end) == Contact::closed) ++end;
    const bool passing = i > 0 && end < count && times[end] - times[i - 1] < least_time;
    if (passing) {
      Contact side = list[i - 1];
      for (std::size_t j = i; j < end; ++j) {
        if (angles[j] * sign(list[end]) >= 0) side = list[end];
        list[j] = side;
      }
    }
    i = end;
  }
  return list;
}

/// A pattern and when it begins.
struct Passage {
  double time = 0;  ///< s
  Pattern pattern;
};

std::vector<Passage> passages(const std::vector<double>& times, const std::vector<Pattern>& patterns) {
  std::vector<Passage> list;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (list.empty() || !(list.back().pattern == patterns[i])) list.push_back({times[i], patterns[i]});
  }
  return list;
}

}  // namespace

std::vector<Pattern> sampled_patterns(const Scene& scene, const History& history) {
  std::vector<Pattern> patterns(history.size(), closed_pattern(history.blocks));
  std::vector<double> angles(history.size());
  for (int k = 0; k < history.blocks; ++k) {
    const auto block = static_cast<std::size_t>(k);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const auto absolute = history.angles_at(i);
      angles[i] = absolute[block] - (k == 0 ? 0 : absolute[block - 1]);
    }
    const std::vector<Contact> list = contacts(history.times, angles, settling_duration(scene));
    for (std::size_t i = 0; i < list.size(); ++i) patterns[i][k] = list[i];
  }
  return patterns;
}

std::vector<PatternShare> pattern_shares(const std::vector<double>& times, const std::vector<Pattern>& exact,
                                         const std::vector<Pattern>& engine) {
  std::vector<PatternShare> shares;
  auto last = shares.end();
  const auto is_pair = [&](const PatternShare& one, std::size_t i) {
    return one.exact == exact[i] && one.engine == engine[i];
  };
  const double whole = times.back() - times.front();
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (last == shares.end() || !is_pair(*last, i)) {
      last = std::find_if(shares.begin(), shares.end(),
                          [&](const PatternShare& one) { return is_pair(one, i); });
      if (last == shares.end()) last = shares.insert(last, {exact[i], engine[i], 0});
    }
    if (i + 1 < times.size()) last->share += (times[i + 1] - times[i]) / whole;
  }
  return shares;
}

double agreement(const std::vector<PatternShare>& shares) {
  double sum = 0;
  for (const PatternShare& one : shares) {
    if (one.exact == one.engine) sum += one.share;
  }
  return sum;
}

double sequence_time(const std::vector<double>& times, const std::vector<Pattern>& exact,
                     const std::vector<Pattern>& engine) {
  const auto first = passages(times, exact), second = passages(times, engine);
  const double end = times.back();
  for (std::size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
    const bool both = i < first.size() && i < second.size();
    if (both && first[i].pattern == second[i].pattern) continue;
    return std::min(i < first.size() ? first[i].time : end, i < second.size() ? second[i].time : end);
  }
  return end;
}

}  // namespace rockstack
