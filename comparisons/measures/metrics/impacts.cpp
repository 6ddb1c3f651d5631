#include "comparisons/measures/metrics/impacts.hpp"

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

double stack_height(const Scene& scene) {
  double height = 0;
  for (const Block& block : scene.blocks) height += 2 * block.half_height;
  return height;
}

/// The contacts of one interface, sample by sample, from its relative angles.
std::vector<Contact> contacts(const std::vector<double>& times, const std::vector<double>& angles,
                              double least_time) {
  const std::size_t count = angles.size();
  std::vector<Contact> list = each_of(angles, [](double angle) {
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

Contact side_of(double velocity, double slowest) {
  return std::abs(velocity) < slowest ? Contact::closed : contact_of(velocity < 0 ? -1 : 1);
}

double relative_at(std::span<const double> values, std::size_t interface) {
  return interface == 0 ? values[0] : values[interface] - values[interface - 1];
}

double chatter_speed(const Scene& scene) {
  return 0.02 * std::sqrt(scene.gravity / stack_height(scene));
}

double settling_duration(const Scene& scene) {
  return 0.1 * std::sqrt(stack_height(scene) / scene.gravity);
}

std::vector<ImpactTime> up_to(std::vector<ImpactTime> impacts, double time) {
  std::erase_if(impacts, [&](const ImpactTime& impact) { return impact.time > time; });
  return impacts;
}

bool is_impact(EventKind kind) {
  return kind == EventKind::impact || kind == EventKind::closure || kind == EventKind::rest;
}

std::vector<ImpactTime> reported_impacts(const History& history, double slowest) {
  std::vector<ImpactTime> impacts;
  for (const Event& event : history.events) {
    if (!is_impact(event.kind)) continue;
    const auto interface = static_cast<std::size_t>(event.interface - 1);
    const double approach = std::abs(relative_at(event.before, interface));
    if (approach < slowest) continue;
    impacts.push_back(
        {event.time, event.interface, side_of(relative_at(event.after, interface), slowest), approach});
  }
  return impacts;
}

std::vector<ImpactTime> observed_impacts(const History& history, double slowest) {
  std::vector<ImpactTime> impacts;
  for (std::size_t i = 0; i + 1 < history.size(); ++i) {
    const double step = history.times[i + 1] - history.times[i];
    for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
      const double side = relative_at(history.angles_at(i), k) < 0 ? -1 : 1;
      const double gap = side * relative_at(history.angles_at(i), k);
      const double next_gap = side * relative_at(history.angles_at(i + 1), k);
      const double approach = -side * relative_at(history.velocities_at(i), k);
      const double next_approach = -side * relative_at(history.velocities_at(i + 1), k);
      if (approach < slowest) continue;
      const bool passes = next_gap <= 0;
      const bool stops = gap <= approach * step && next_approach < 0.5 * approach;
      if (!passes && !stops) continue;
      const double delay = passes ? step * gap / (gap - next_gap) : gap / approach;
      const std::size_t later = std::min(i + 2, history.size() - 1);
      impacts.push_back({history.times[i] + delay, static_cast<int>(k) + 1,
                         side_of(relative_at(history.velocities_at(later), k), slowest), approach});
    }
  }
  std::ranges::stable_sort(impacts, {}, &ImpactTime::time);
  return impacts;
}

std::vector<Pattern> sampled_patterns(const Scene& scene, const History& history) {
  std::vector<Pattern> patterns(history.size(), closed_pattern(history.blocks));
  std::vector<double> angles(history.size());
  for (int k = 0; k < history.blocks; ++k) {
    const auto block = static_cast<std::size_t>(k);
    for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = relative_at(history.angles_at(i), block);
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

std::vector<ImpactTime> settlings(const Scene& scene, const History& history) {
  const double slowest = chatter_speed(scene), least_time = settling_duration(scene);
  std::vector<ImpactTime> list;
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
    const auto is_quiet = [&](std::size_t i) {
      return std::abs(relative_at(history.angles_at(i), k)) <= open_angle &&
             std::abs(relative_at(history.velocities_at(i), k)) < slowest;
    };
    for (std::size_t i = 0; i < history.size(); ++i) {
      if (!is_quiet(i)) continue;
      const std::size_t start = i;
      while (i + 1 < history.size() && is_quiet(i + 1)) ++i;
      if (start > 0 && history.times[i] - history.times[start] >= least_time)
        list.push_back({history.times[start], static_cast<int>(k) + 1, Contact::closed});
    }
  }
  std::ranges::stable_sort(list, {}, &ImpactTime::time);
  return list;
}

std::optional<double> residual_motion(const History& exact, const History& engine) {
  const std::size_t count = std::min(exact.size(), engine.size());
  const double start = 0.9 * exact.times[count - 1];
  double sum = 0;
  std::size_t values = 0;
  for (std::size_t i = count; i-- > 0 && exact.times[i] >= start;) {
    if (!is_closed(exact.patterns[i])) return {};
    for (const double velocity : engine.velocities_at(i)) {
      sum += velocity * velocity;
      ++values;
    }
  }
  return std::sqrt(sum / static_cast<double>(values));
}

}  // namespace rockstack
