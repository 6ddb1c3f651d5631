#include "comparisons/measures/metrics/sampled_patterns.hpp"

#include "analytic/scene/lists.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {
namespace {

/// The contacts of one interface, sample by sample, from its relative angles.
std::vector<Contact> contacts(const std::vector<double>& times, const std::vector<double>& angles,
                              double least_time) {
  const std::size_t count = angles.size();
  std::vector<Contact> list = mapped(angles, [](double angle) {
    return std::abs(angle) <= open_angle ? Contact::closed : contact_of(angle < 0 ? -1 : 1);
  });
  for (std::size_t begin = 0, end = 0; begin < count; begin = end + 1) {
    end = begin;
    while (end < count && list[end] == Contact::closed) ++end;
    if (begin == 0 || end == count || times[end] - times[begin - 1] >= least_time) continue;
    Contact side = list[begin - 1];
    for (std::size_t i = begin; i < end; ++i) {
      if (angles[i] * sign(list[end]) >= 0) side = list[end];
      list[i] = side;
    }
  }
  return list;
}

/// The times at which patterns begin, s, and which.
std::vector<std::pair<double, Pattern>> passages(const std::vector<double>& times,
                                                 const std::vector<Pattern>& patterns) {
  std::vector<std::pair<double, Pattern>> list;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (list.empty() || !(list.back().second == patterns[i])) list.emplace_back(times[i], patterns[i]);
  return list;
}

}  // namespace

std::vector<Pattern> sampled_patterns(const Scene& scene, const History& history) {
  std::vector<Pattern> patterns(history.size(), closed_pattern(history.blocks));
  std::vector<double> angles(history.size());
  for (int k = 0; k < history.blocks; ++k) {
    const auto block = static_cast<std::size_t>(k);
    for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = relative_at(history.angles_at(i), block);
    const std::vector<Contact> list = contacts(history.times, angles, settling_duration(scene));
    for (std::size_t i = 0; i < list.size(); ++i)
      patterns[i][k] = flies(scene, history, block, i) ? Contact::apart : list[i];
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
      last = std::ranges::find_if(shares, [&](const PatternShare& one) { return is_pair(one, i); });
      if (last == shares.end()) last = shares.insert(last, {exact[i], engine[i], 0});
    }
    if (i + 1 < times.size()) last->share += (times[i + 1] - times[i]) / whole;
  }
  return shares;
}

double agreement(const std::vector<PatternShare>& shares) {
  double sum = 0;
  for (const PatternShare& one : shares)
    if (one.exact == one.engine) sum += one.share;
  return sum;
}

double sequence_time(const std::vector<double>& times, const std::vector<Pattern>& exact,
                     const std::vector<Pattern>& engine) {
  const auto first = passages(times, exact), second = passages(times, engine);
  const auto alike = [](const auto& a, const auto& b) { return a.second == b.second; };
  const auto [one, other] = std::mismatch(first.begin(), first.end(), second.begin(), second.end(), alike);
  return std::min(one == first.end() ? times.back() : one->first,
                  other == second.end() ? times.back() : other->first);
}

}  // namespace rockstack
