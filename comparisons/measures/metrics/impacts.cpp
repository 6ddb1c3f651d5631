#include "comparisons/measures/metrics/impacts.hpp"

#include <map>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

/// What an interface does between two samples of sampled motion.
class SampledInterface {
 public:
  SampledInterface(const Scene& scene, const History& history, std::size_t interface)
      : history_(history), interface_(interface), width_(interface_width(scene, interface)) {}

  /// Whether it is apart by more than blocks may hover, up to the next sample, and goes up or down.
  bool flies(std::size_t sample, double slowest) const {
    if (sample + 1 >= history_.size()) return false;
    const double lower = std::min(gap(sample), gap(sample + 1));
    return lower > open_angle * width_ && !(std::abs(fall(sample)) < slowest * width_);
  }

  /// Impacts at `slowest` times the width or more.
  std::vector<ImpactTime> impacts(double slowest) const {
    std::vector<ImpactTime> list;
    bool may_land = true;  // as it has not landed since it last rose
    for (std::size_t i = 0; i + 1 < history_.size(); ++i) {
      may_land = may_land || (i > 0 && gap(i) > gap(i - 1));
      if (const auto strike = closing(i, slowest)) {
        list.push_back(impact(i, *strike, slowest));
      } else if (const auto landed = landing(i, slowest * width_); landed && may_land) {
        list.push_back(impact(i, *landed, slowest));
        list.back().lands = true;
        may_land = false;
      }
    }
    return list;
  }

 private:
  struct Strike {
    double delay = 0;  ///< after the first sample, s
    double speed = 0;  ///< m/s
  };

  ImpactTime impact(std::size_t sample, const Strike& strike, double slowest) const {
    const std::size_t later = std::min(sample + 2, history_.size() - 1);
    return {history_.times[sample] + strike.delay, static_cast<int>(interface_) + 1,
            side_of(relative_at(history_.velocities_at(later), interface_), slowest), strike.speed};
  }

  double step(std::size_t sample) const { return history_.times[sample + 1] - history_.times[sample]; }
  double gap(std::size_t sample) const {
    return history_.gaps.empty() ? 0 : history_.row(history_.gaps, sample)[interface_];
  }
  double fall(std::size_t sample) const { return (gap(sample) - gap(sample + 1)) / step(sample); }

  /// A relative angle that closes.
  std::optional<Strike> closing(std::size_t i, double slowest) const {
    const auto relative = [&](auto at, std::size_t sample) {
      return relative_at((history_.*at)(sample), interface_);
    };
    const double side = relative(&History::angles_at, i) < 0 ? -1 : 1;
    const double angle = side * relative(&History::angles_at, i);
    const double next_angle = side * relative(&History::angles_at, i + 1);
    const double approach = -side * relative(&History::velocities_at, i);
    const double next_approach = -side * relative(&History::velocities_at, i + 1);
    if (approach < slowest || flies(i, slowest)) return {};
    const bool passes = next_angle <= 0;
    if (!passes && !(angle <= approach * step(i) && next_approach < 0.5 * approach)) return {};
    return Strike{passes ? step(i) * angle / (angle - next_angle) : angle / approach, approach * width_};
  }

  /// A gap that closes: the lines of the fall before and of what follows meet.
  std::optional<Strike> landing(std::size_t i, double slowest) const {
    if (i == 0 || i + 2 >= history_.size() || !(gap(i) > 0)) return {};
    const double approach = fall(i - 1);
    if (!(approach >= slowest) || !std::isfinite(approach)) return {};
    const bool passes = gap(i + 1) <= 0;
    const double next_approach = fall(i + 1);
    const bool stops = gap(i) <= approach * step(i) + open_angle * width_ && next_approach < 0.5 * approach;
    if (!passes && !stops) return {};
    const double delay = passes
                             ? gap(i) / approach
                             : (gap(i) - gap(i + 1) - next_approach * step(i)) / (approach - next_approach);
    return Strike{std::clamp(delay, 0.0, step(i)), approach};
  }

  const History& history_;
  std::size_t interface_;
  double width_;  ///< m
};

/// Both corners of what lands as good as flat strike at once: of impacts that follow a landing by less than a
/// hundredth of the settling duration the side alone is kept.
std::vector<ImpactTime> with_whole_landings(const Scene& scene, const std::vector<ImpactTime>& impacts) {
  const double at_once = 0.01 * settling_duration(scene);
  std::vector<ImpactTime> list;
  std::map<int, std::size_t> landings;  // the last one of each interface
  for (const ImpactTime& impact : impacts) {
    const auto landing = landings.find(impact.interface);
    if (landing != landings.end() && impact.time - list[landing->second].time < at_once) {
      list[landing->second].side = impact.side;
      continue;
    }
    if (impact.lands) landings[impact.interface] = list.size();
    list.push_back(impact);
  }
  return list;
}

}  // namespace

bool flies(const Scene& scene, const History& history, std::size_t interface, std::size_t sample) {
  return leaves_pivots(scene.law) &&
         SampledInterface(scene, history, interface).flies(sample, chatter_speed(scene));
}

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

double interface_width(const Scene& scene, std::size_t interface) {
  return 2 * interface_half_width(scene, static_cast<int>(interface));
}

double approach_speed(const Event& event, double width) {
  return event.approach.value_or(
      width * std::abs(relative_at(event.before, static_cast<std::size_t>(event.interface - 1))));
}

std::vector<ImpactTime> reported_impacts(const Scene& scene, const History& history, double slowest) {
  std::vector<ImpactTime> impacts;
  for (const Event& event : history.events) {
    if (!is_impact(event.kind)) continue;
    const auto interface = static_cast<std::size_t>(event.interface - 1);
    const double width = interface_width(scene, interface), approach = approach_speed(event, width);
    if (approach < slowest * width) continue;
    impacts.push_back({event.time, event.interface, side_of(relative_at(event.after, interface), slowest),
                       approach, event.from.contacts[interface] == Contact::apart});
  }
  return with_whole_landings(scene, impacts);
}

std::vector<ImpactTime> observed_impacts(const Scene& scene, const History& history, double slowest) {
  std::vector<ImpactTime> impacts;
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
    const auto own = SampledInterface(scene, history, k).impacts(slowest);
    impacts.insert(impacts.end(), own.begin(), own.end());
  }
  std::ranges::stable_sort(impacts, {}, &ImpactTime::time);
  return with_whole_landings(scene, impacts);
}

std::optional<double> flat_landing(const History& history, double end) {
  constexpr double flat = 1e-9;  // rad
  std::optional<double> time;
  for (const Event& event : history.events) {
    const auto interface = static_cast<std::size_t>(event.interface - 1);
    if (is_impact(event.kind) && event.from.contacts[interface] == Contact::apart && event.time <= end &&
        std::abs(relative_at(event.angles, interface)) <= flat)
      time = event.time;
  }
  return time;
}

Difference gap_difference(const Scene& scene, const History& first, const History& second) {
  Difference apart = difference(first, second);
  const bool gaps = !first.gaps.empty() && !second.gaps.empty();
  for (std::size_t i = 0; i < apart.times.size(); ++i) {
    const std::span row(apart.values.data() + i * apart.blocks, apart.blocks);
    for (std::size_t k = apart.blocks; k-- > 0;) {
      row[k] = interface_width(scene, k) * std::abs(relative_at(row, k));
      if (!gaps) continue;
      const double gap = first.row(first.gaps, i)[k], other = second.row(second.gaps, i)[k];
      if (gap > 0 && std::isfinite(gap - other)) row[k] += std::abs(gap - other);
    }
  }
  return apart;
}

std::vector<ImpactTime> settlings(const Scene& scene, const History& history) {
  const double slowest = chatter_speed(scene), least_time = settling_duration(scene);
  std::vector<ImpactTime> list;
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k) {
    const SampledInterface interface(scene, history, k);
    const auto is_quiet = [&](std::size_t i) {
      return std::abs(relative_at(history.angles_at(i), k)) <= open_angle &&
             std::abs(relative_at(history.velocities_at(i), k)) < slowest && !interface.flies(i, slowest);
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
