#include "tests/analytic/unilateral/track.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analytic/mechanics/impact.hpp"
#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {
namespace {

double closing_speed(const Event& event) {
  if (event.kind == EventKind::opening || event.kind == EventKind::topple) return never;
  double least = never;
  for (int k = 0; k < event.to.size; ++k) {
    const auto block = static_cast<std::size_t>(k);
    if (event.from[k] == event.to[k] && k + 1 != event.interface) continue;
    least = std::min(least, std::abs(event.before[block] - (k > 0 ? event.before[block - 1] : 0)));
  }
  return least;
}

void note_end(Track& track, double time, Parting reason) {
  if (reason == Parting::none || time >= track.end) return;
  track.end = time;
  track.reason = reason;
}

/// What the impulses of an impact ask for that interfaces do not give. Those of chatter are too small for the
/// demands of a history.
Parting asked_of_impact(const Scene& scene, const Event& event) {
  if (event.consistency == Consistency::none) return Parting::no_pattern;
  if (event.kind != EventKind::impact) return Parting::none;
  const auto model = make_model<double>(scene);
  const auto size = static_cast<Eigen::Index>(scene.blocks.size());
  State<double> before{event.from, Vector<double>(size), Vector<double>(size)};
  std::copy(event.angles.begin(), event.angles.end(), before.angles.begin());
  std::copy(event.before.begin(), event.before.end(), before.velocities.begin());
  before.angles = relative(before.angles);
  before.velocities = relative(before.velocities);
  const auto solution = velocities_after(model, Impact<double>{before, {}}, event.to);
  for (Eigen::Index k = 0; k < size; ++k) {
    const double normal = solution.reactions.normal[k];
    const double friction = scene.friction[static_cast<std::size_t>(k)];
    if (std::abs(solution.reactions.tangential[k]) >
        friction * normal + (1 + friction) * solution.rounding[k])
      return Parting::impact_friction;
  }
  return Parting::none;
}

Moment moment_of(const Event& event) {
  std::vector<double> rates = event.before;
  rates.insert(rates.end(), event.after.begin(), event.after.end());
  return {name(event.kind), event.interface, name(event.to), event.time, event.angles, rates};
}

std::vector<Moment> moments_of_samples(const History& history) {
  std::vector<Moment> moments;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto angles = history.angles_at(i);
    const auto rates = history.velocities_at(i);
    moments.push_back(
        {"", 0, "", history.times[i], {angles.begin(), angles.end()}, {rates.begin(), rates.end()}});
  }
  return moments;
}

/// Leaves out what comes at the end or after it.
Track up_to_its_end(Track track) {
  for (std::vector<Moment>* moments : {&track.events, &track.samples})
    std::erase_if(*moments, [&](const Moment& moment) { return moment.time >= track.end; });
  return track;
}

Track track_of_pivots(const Scene& scene, const History& history) {
  Track track;
  track.samples = moments_of_samples(history);
  for (const Event& event : history.events) {
    track.events.push_back(moment_of(event));
    track.events.back().speed = closing_speed(event);
    note_end(track, event.time, asked_of_impact(scene, event));
  }
  for (const Demand& demand : history.forces) {
    note_end(track, demand.first_pull_time, Parting::pull);
    note_end(track, demand.first_slip_time, Parting::friction);
  }
  for (const Event& event : history.events)
    track.opens = track.opens || (event.kind == EventKind::opening && event.time == track.end);
  return up_to_its_end(std::move(track));
}

Track track_of_joints(const History& history) {
  Track track;
  track.samples = moments_of_samples(history);
  for (const Event& event : history.events) {
    if (!all_stick(event.to)) {
      track.end = event.time;
      break;
    }
    track.events.push_back(moment_of(event));
  }
  return up_to_its_end(std::move(track));
}
/// By what deviations are measured.
class Sizes {
 public:
  explicit Sizes(const Scene& scene) : time_(unit_time(scene)), rate_(1 / time_) {}
  void note(const Moment& moment) {
    for (const double rate : moment.rates) rate_ = std::max(rate_, std::abs(rate));
  }
  double deviation(const Moment& one, const Moment& other) const {
    // Law `consistent`, which is `one`, tells a closure where its impacts accumulate, law `unilateral` at the
    // last one followed: never later.
    const bool closes = one.kind == name(EventKind::closure) || one.kind == name(EventKind::rest);
    double largest =
        (closes ? std::max(0.0, other.time - one.time) : std::abs(one.time - other.time)) / time_;
    for (std::size_t i = 0; i < one.angles.size(); ++i)
      largest = std::max(largest, std::abs(one.angles[i] - other.angles[i]));
    for (std::size_t i = 0; i < one.rates.size(); ++i)
      largest = std::max(largest, std::abs(one.rates[i] - other.rates[i]) / rate_);
    return largest;
  }

 private:
  double time_ = 0, rate_ = 0;
};

}  // namespace

std::optional<Track> consistent_track(Scene scene, const std::vector<double>& times) {
  scene.law = Law::consistent;
  try {
    return track_of_pivots(scene, solve(scene, {.sample_times = times, .validity = true}));
  } catch (const Unfinished&) {
    return std::nullopt;
  }
}

Track joint_track(const Scene& scene, const std::vector<double>& times) {
  try {
    return track_of_joints(solve_unilateral(scene, {.sample_times = times}));
  } catch (const Unfinished& unfinished) {
    return track_of_joints(unfinished.history);
  }
}
double unit_time(const Scene& scene) {
  double height = 0;
  for (const Block& block : scene.blocks) height += 2 * block.half_height;
  return std::sqrt(height / scene.gravity);
}

bool same(const Moment& one, const Moment& other) {
  return one.kind == other.kind && one.interface == other.interface && one.pattern == other.pattern;
}
Deviations compare(const Scene& scene, const Track& one, const Track& other) {
  Deviations found;
  Sizes sizes(scene);
  std::size_t sample = 0;
  double last = 0;  // time that both have come to
  const auto follow_samples = [&](double end) {
    for (; sample < std::min(one.samples.size(), other.samples.size()); ++sample) {
      if (one.samples[sample].time >= end) return;
      sizes.note(one.samples[sample]);
      if (one.samples[sample].time > last)
        found.samples.push_back(sizes.deviation(one.samples[sample], other.samples[sample]));
      else
        found.samples.push_back(0);
    }
  };
  const std::size_t count = std::min(one.events.size(), other.events.size());
  for (std::size_t i = 0; i < count && same(one.events[i], other.events[i]); ++i) {
    follow_samples(std::min(one.events[i].time, other.events[i].time));
    sizes.note(one.events[i]);
    found.events.push_back(sizes.deviation(one.events[i], other.events[i]));
    last = std::max(one.events[i].time, other.events[i].time);
  }
  const auto next = [&](const Track& track) {
    return found.events.size() < track.events.size() ? track.events[found.events.size()].time : track.end;
  };
  follow_samples(std::min({next(one), next(other), one.end, other.end}));
  return found;
}

}  // namespace rockstack::testing
