#include "tests/analytic/unilateral/two_laws.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "analytic/polynomials/polynomial.hpp"
#include "tests/analytic/unilateral/scenes.hpp"

namespace rockstack::testing {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double agreed = 1e-12;
constexpr double several = 16;  // operations in a row
// Forces are second derivatives of series, whose last terms count by the square of their order.
constexpr double agreed_force = agreed + several * epsilon * max_orders<double> * max_orders<double>;
constexpr int draws = 4;
/// A scene with all its numbers changed at random by a share of them of up to `change`. Interfaces that are
/// closed stay so.
Scene changed(Scene scene, Draw& draw, double change) {
  const auto shift = [&](double& value) { value *= 1 + change * draw.between(-1, 1); };
  shift(scene.gravity);
  for (Block& block : scene.blocks)
    for (double* value : {&block.half_width, &block.half_height, &block.mass, &block.inertia}) shift(*value);
  for (std::vector<double>* values : {&scene.initial.angles, &scene.initial.velocities}) {
    const std::vector<double> given = *values;
    for (std::size_t k = 0; k < given.size(); ++k) {
      if (k > 0 && given[k] == given[k - 1]) {
        (*values)[k] = (*values)[k - 1];
      } else {
        shift((*values)[k]);
      }
    }
  }
  for (GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    for (double& sample : motion->samples) shift(sample);
    if (!motion->pulse) continue;
    for (double* value :
         {&motion->pulse->amplitude, &motion->pulse->period, &motion->pulse->start, &motion->pulse->phase})
      shift(*value);
  }
  return scene;
}

/// By how much more than its scene's numbers a motion changes: at events and samples, each the largest so
/// far, and where it ends; and the first event that a change of some roundings takes elsewhere. Infinite
/// where any change does.
struct Sensitivity {
  std::vector<double> events, samples;
  double end = 1;
  std::size_t first_other = std::numeric_limits<std::size_t>::max();

  Sensitivity(const Track& track, double value)
      : events(track.events.size(), value), samples(track.samples.size(), value), end(value) {}
};

void raise(const std::vector<double>& deviations, double change, std::vector<double>& largest) {
  double so_far = 1;
  for (std::size_t i = 0; i < largest.size(); ++i) {
    so_far = i < deviations.size() ? std::max(so_far, deviations[i] / change) : never;
    largest[i] = std::max(largest[i], so_far);
  }
}

/// By some draws of a change.
Sensitivity sensitivity(const Scene& scene, const Track& track, const std::vector<double>& times,
                        double change) {
  Sensitivity found(track, 1);
  Draw draw(scene.blocks.size());
  for (int i = 0; i < draws; ++i) {
    const auto other = consistent_track(changed(scene, draw, change), times);
    if (!other) continue;
    const Deviations deviations = compare(scene, track, *other);
    if (deviations.events.size() < std::max(track.events.size(), other->events.size()))
      found.first_other = std::min(found.first_other, deviations.events.size());
    raise(deviations.events, change, found.events);
    raise(deviations.samples, change, found.samples);
    if (track.end < never)
      found.end = std::max(found.end, std::abs(other->end - track.end) / unit_time(scene) / change);
  }
  return found;
}

/// By draws of a change; and where that takes the motion elsewhere, by those of smaller ones.
Sensitivity sensitivity(const Scene& scene, const Track& track, const std::vector<double>& times) {
  Sensitivity found(track, never);
  const auto take_less = [](const std::vector<double>& from, std::vector<double>& to) {
    for (std::size_t i = 0; i < to.size(); ++i)
      if (to[i] == never) to[i] = from[i];
  };
  for (const double change : {1e-9, 1e-11, 1e-13, several * epsilon}) {
    const Sensitivity own = sensitivity(scene, track, times, change);
    take_less(own.events, found.events);
    take_less(own.samples, found.samples);
    if (found.end == never) found.end = own.end;
    found.first_other = own.first_other;
    if (found.first_other > track.events.size() && found.end < never) break;
  }
  return found;
}

/// True where the chatter of an interface ends for one motion at an impact after which it flies on for the
/// other.
bool chatter_ends(const Moment& one, const Moment& other) {
  const auto closes = [](const Moment& moment) { return moment.kind == "closure" || moment.kind == "rest"; };
  return one.interface == other.interface && closes(one) != closes(other) &&
         (one.kind == "impact" || other.kind == "impact");
}

/// Why the motions part, if they do. `end` is how far off the end of one may be from that of the other, s.
Parting reason(const Track& pivots, const Track& joints, std::size_t same, std::size_t first_other,
               double end) {
  const bool all = same == pivots.events.size() && same == joints.events.size();
  const bool more = same < pivots.events.size() && same < joints.events.size();
  if (more && chatter_ends(pivots.events[same], joints.events[same])) return Parting::chatter;
  // The ground, or a block further down, ends the motion that knows it.
  if (same + 1 == joints.events.size() && joints.events.back().kind == name(EventKind::strike))
    return Parting::none;
  if (all && pivots.end == joints.end) return pivots.reason;
  if (all && std::abs(pivots.end - joints.end) <= end) return pivots.reason;
  if (same == pivots.events.size() && pivots.opens && joints.end > pivots.end) return Parting::jump;
  return first_other <= same ? Parting::rounding : Parting::unexplained;
}

}  // namespace

const char* name(Parting parting) {
  constexpr const char* names[] = {"none",
                                   "friction",
                                   "friction of an impact",
                                   "pull",
                                   "no consistent pattern",
                                   "a jump of the ground",
                                   "the end of chatter",
                                   "roundings",
                                   "no end",
                                   "UNEXPLAINED"};
  return names[static_cast<std::size_t>(parting)];
}

Scene gripping_scene(std::uint64_t seed) {
  Scene scene = with_friction(seeded_scene(seed), 0);
  Draw draw(seed + 90000);
  for (double& friction : scene.friction) friction = std::pow(10, draw.between(-1, 3));
  return scene;
}

std::string LawTally::add(std::uint64_t seed, const Scene& scene) {
  const std::vector<double> times = regular_times(scene.duration / 20, scene.duration);
  const auto pivots = consistent_track(scene, times);
  if (!pivots) {
    ++scenes[static_cast<std::size_t>(Parting::unfinished)];
    return {};
  }
  const Track joints = joint_track(scene, times);
  const Deviations deviations = compare(scene, *pivots, joints);
  const Sensitivity own = sensitivity(scene, *pivots, times);
  const double unit = unit_time(scene);
  double rounding = agreed;
  double largest = 0;
  const auto check = [&](double deviation, double amplified) {
    if (amplified == never) return ++beyond;
    largest = std::max(largest, deviation / (amplified * rounding));
    return ++compared;
  };
  for (std::size_t i = 0; i < deviations.events.size(); ++i) {
    const Moment& event = pivots->events[i];
    rounding = std::max(
        rounding, event.kind == "opening" ? agreed_force : agreed + several * epsilon / (event.speed * unit));
    check(deviations.events[i], own.events[i]);
  }
  for (std::size_t i = 0; i < deviations.samples.size(); ++i) check(deviations.samples[i], own.samples[i]);
  worst = std::max(worst, largest);
  const Parting parting = reason(*pivots, joints, deviations.events.size(), own.first_other,
                                 own.end * std::max(rounding, agreed_force) * unit);
  ++scenes[static_cast<std::size_t>(parting)];
  if (parting != Parting::unexplained && largest <= 1) return {};
  std::ostringstream text;
  text.precision(15);
  text << "seed " << seed << ", " << scene.blocks.size() << " blocks: " << name(parting) << ", "
       << deviations.events.size() << " events alike of " << pivots->events.size() << " and "
       << joints.events.size() << "; law consistent holds until " << pivots->end << " s ("
       << name(pivots->reason) << "), the other is like it until " << joints.end << " s; deviation "
       << largest << " of its bound";
  return text.str();
}

std::string LawTally::summary() const {
  std::ostringstream text;
  for (std::size_t i = 0; i < partings; ++i)
    text << name(static_cast<Parting>(i)) << ": " << scenes[i] << '\n';
  text << compared << " events and samples compared, off by at most " << worst << " of their bounds; "
       << beyond << " are too sensitive to be";
  return text.str();
}

}  // namespace rockstack::testing
