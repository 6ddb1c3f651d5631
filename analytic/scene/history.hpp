#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "analytic/scene/pattern.hpp"

namespace rockstack {

/// What happens between stretches of smooth motion.
enum class EventKind {
  opening,  ///< a closed interface starts to rock, without impact
  impact,   ///< an open interface meets its full width
  closure,  ///< the last of ever smaller impacts: the interface stays closed
  rest,     ///< a closure after which no interface is open
  topple,   ///< a block passes its toppling angle; the history ends
  // Events of laws that leave pivots (leaves_pivots()) alone:
  lift_off,  ///< blocks part, without impact
  slip,      ///< what stuck starts to slide
  stick,     ///< what slid sticks, or slides back
  corner,    ///< a corner passes the end of a face: the contact goes on at another corner, or parts
  fall,      ///< a block is beside the face that it was over, and no longer above it; the history ends
  // Law `compliant` alone:
  touch,  ///< a corner starts to push
  part,   ///< a corner stops pushing
  // Again of laws that leave pivots:
  strike,  ///< a block meets the ground or one that it is not stacked on; the history ends
  // Events of all laws:
  impulse,  ///< an impulse of a push, or a step of the ground's velocity; the lowest interface that it
            ///< changes
  // Events of restraints, by the block that they hold:
  slack,   ///< a tendon goes slack
  taut,    ///< and pulls again
  yield,   ///< it yields
  unload,  ///< it no longer does
};

std::string name(EventKind kind);
/// What a name() stands for, here and below. @throws std::invalid_argument where that is nothing.
EventKind named_event(std::string_view name);

/// Whether the history ends with it.
inline bool ends_motion(EventKind kind) {
  return kind == EventKind::topple || kind == EventKind::fall || kind == EventKind::strike;
}

/// Whether the pattern chosen after an event is one that the laws of contact allow, and the only one.
enum class Consistency {
  consistent,  ///< the chosen pattern is the consistent one (or no impact took place)
  other,       ///< another pattern would have been consistent
  none,        ///< no pattern is: the blocks would have to lift off; or, of laws that leave pivots, no forces
               ///< let the motion go on, and an impulse does (Painlevé)
  several,     ///< of laws that leave pivots: more than one motion obeys all laws, and one of them follows
  gains,       ///< of points that bounce: Newton's law of impact gains energy with this friction
};

std::string name(Consistency consistency);
Consistency named_consistency(std::string_view name);

/// One event with the state on both sides of it, unless that was not asked for: then its vectors are empty.
/// `interface` counts from 1; for `topple` it is the block.
template <class Real>
struct BasicEvent {
  Real time{};  ///< s
  EventKind kind{};
  int interface = 0;
  Pattern from, to;
  std::vector<Real> angles;  ///< rad, one a block
  std::vector<Real> before;  ///< angular velocities just before, rad/s
  std::vector<Real> after;   ///< angular velocities just after, rad/s
  Consistency consistency = Consistency::consistent;
  /// How many impacts in a row it stands for, each of which throws the interface to its other side, and
  /// changes no other; it tells the first pattern, and the last time (EventsKept::summed).
  std::size_t count = 1;
  /// How fast the gap closes where an impact strikes, m/s; of laws that leave pivots alone.
  std::optional<Real> approach = {};
  /// Three rows of x and y of each block's centre of mass: its place, as in BasicHistory, m, and its
  /// velocities just before and just after, m/s; of laws that leave pivots, else empty.
  std::vector<Real> centres = {};
};

/// An opening angle, or the margin of a closed interface, that touched zero to rounding: whether there was an
/// impact, or an opening, the numbers cannot tell, and what follows depends on it.
template <class Real>
struct BasicGraze {
  Real time{};        ///< s
  EventKind kind{};   ///< of the event in doubt
  int interface = 0;  ///< from 1
};

/// What an interface has to bear for the model to hold, over a whole history: it must push, and hold without
/// slipping. First times are infinite where it never comes to that.
template <class Real>
struct BasicDemand {
  Real least_normal = std::numeric_limits<Real>::infinity();  ///< N or N·s; negative: it would have to pull
  Real least_normal_time{};                                   ///< s
  Real friction{};                                            ///< largest |T|/N; infinite where N ≤ 0
  Real friction_time{};                                       ///< s
  Real first_pull_time = std::numeric_limits<Real>::infinity();  ///< first, at which it would have to pull, s
  /// First, at which it needs more friction than the scene's surfaces have, s.
  Real first_slip_time = std::numeric_limits<Real>::infinity();
};

/// What an interface carries, as the block above it feels it.
template <class Real>
struct BasicReaction {
  Real normal{}, tangential{};  ///< N, up and to the right
  Real centre{};                ///< of pressure, from the middle of the block above, m; no number where apart
};

/// What the springs of an interface hold, and what has been lost at it so far, J.
template <class Real>
struct BasicSpringEnergy {
  Real elastic{};
  Real damped{};  ///< lost in dashpots
  Real rubbed{};  ///< lost by friction
};

/// Sampled motion of a stack, and the events where they are known. Engines know no patterns and no events:
/// those two are empty then. Rows are samples; angles and velocities are stored row by row.
template <class Real>
struct BasicHistory {
  int blocks = 0;
  std::vector<Real> times;        ///< s, ascending
  std::vector<Real> angles;       ///< rad, times.size() × blocks
  std::vector<Real> velocities;   ///< rad/s, times.size() × blocks
  std::vector<Pattern> patterns;  ///< times.size(), or empty
  std::vector<BasicEvent<Real>> events;
  std::vector<BasicGraze<Real>> grazes;  ///< events in doubt
  /// Openings under tension: either side would do as well as the one that was taken.
  std::vector<BasicGraze<Real>> choices;
  // Samples of laws that leave pivots, where angles do not tell where blocks are; else empty. Row by row as
  // angles.
  std::vector<Real> slips;  ///< how far each block's middle is to the right of that of what is below,
                            ///< along the face, m: its offset at the start and what it has slipped since
  std::vector<Real> gaps;   ///< between each block and what is below it, m; infinite over nothing
  /// Centres of mass, x and y in turn, from the middle of the ground's interface, m, and their rates, m/s.
  std::vector<Real> centres, centre_velocities;
  std::vector<BasicReaction<Real>> reactions;            ///< times.size() × blocks
  std::vector<BasicSpringEnergy<Real>> spring_energies;  ///< likewise, of law `compliant`; else empty
  std::vector<Real> peaks;  ///< largest |θ| of each block at any time, rad; empty unless asked for
  /// Largest uplift of each block at any time, with peaks: how far a corner of its lower face comes off the
  /// face below, or off that one's plane, m.
  std::vector<Real> uplifts;
  /// Slips in the end, largest |slips| and largest gaps, m, of laws that leave pivots, with peaks.
  std::vector<Real> slips_left, largest_slips, lifts;
  std::vector<BasicDemand<Real>> forces;    ///< one an interface, of the motion; empty unless asked for
  std::vector<BasicDemand<Real>> impulses;  ///< likewise, of the impacts

  std::size_t size() const { return times.size(); }
  std::span<const Real> angles_at(std::size_t sample) const { return row(angles, sample); }
  std::span<const Real> velocities_at(std::size_t sample) const { return row(velocities, sample); }
  /// Row of values that are stored row by row.
  template <class Value>
  std::span<const Value> row(const std::vector<Value>& values, std::size_t sample) const {
    const auto width = static_cast<std::size_t>(blocks);
    return {values.data() + sample * width, width};
  }
};

using Demand = BasicDemand<double>;
using Event = BasicEvent<double>;
using Reaction = BasicReaction<double>;
using SpringEnergy = BasicSpringEnergy<double>;
using History = BasicHistory<double>;

}  // namespace rockstack
