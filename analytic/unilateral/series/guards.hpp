#pragma once

#include "analytic/polynomials/crossing.hpp"
#include "analytic/unilateral/contact/contact_laws.hpp"
#include "analytic/unilateral/series/mode_series.hpp"

namespace rockstack {

/// What happens where a guard becomes negative.
enum class Change : std::uint8_t {
  force,    ///< a force leaves its range: opening, lift-off, or slip
  halt,     ///< sliding comes to a halt
  closing,  ///< a pivot's angle returns to zero
  landing,  ///< a corner meets a face
  corner,   ///< a corner comes to the end of a face
  topple,
  fall,    ///< of a block that touches: nothing is left of the face; of one that flies: beside it, and not
           ///< above
  strike,  ///< a corner meets a body that is not next to its own
};

/// The longest time by which an event decides later, in units of √(H/g).
inline constexpr double longest_look_ahead = 1e-4;

/// Something that stays positive for as long as a mode lasts.
template <class Real>
struct Guard {
  Polynomial<Real> series;
  Change change{};
  int interface = 0;   ///< from 0; of topple the block
  int side = 0;        ///< of landing: which corner, −1 or 1
  bool below = false;  ///< of landing: a corner of the block below
  /// Places of landing and strike: how far the corner is inside the face's end on its side, and on the other,
  /// m.
  Polynomial<Real> within = {}, within_other = {};
  Real rounding = 0;            ///< of these distances, m
  Real sunk = 0;                ///< of landing: how deep other blocks' joints may put a corner, m
  Polynomial<Real> other = {};  ///< of fall from flight: what is negative beside it
};

/// Gathers what a mode ends by, interface by interface.
template <class Real>
class GuardCollector {
 public:
  GuardCollector(const ContactModel<Real>& stack, const Joints<Real>& joints, const ModeSeries<Real>& series)
      : stack_(stack), joints_(joints), series_(series) {
    for (std::size_t k = 0; k < joints.size(); ++k)
      inertia_ += 2 * stack.blocks[k].mass * series.bodies[k].centre[2].template lpNorm<1>();
  }

  void add_interface(int k) {
    const Joint<Real>& joint = joints_[k];
    if (joint.touch == Contact::closed) {
      add_pressure(k);
    } else if (joint.pivots()) {
      push_if_needed(opening_angle(k), Change::closing, k);
    } else if (!stack_.soft(static_cast<std::size_t>(k))) {
      add_landings(k);
    }
    if (!joint.touches()) return;
    const Hull<Real> normal = hull(force(k).normal);
    if (joint.pivots() && !(normal.least > 0)) push_force(force(k).normal, 1, k);
    if (joint.slip == 0) {
      add_friction(k, normal);
    } else {
      push_if_needed(times(joint.slip, derivative(slip(k))), Change::halt, k);
      if (k > 0) joint.pivots() ? add_pivot_ends(k) : add_flat_ends(k);
    }
  }

  void add_toppling(int k, const Real& angle) {
    const Polynomial<Real>& lean = series_.bodies[k].angle;
    if (abs(lean[0]) + reach(lean) < angle) return;
    push_if_needed(line(angle, -1, lean), Change::topple, k);
    push_if_needed(line(angle, 1, lean), Change::topple, k);
  }

  /// What block k may strike: the ground, and blocks that are not next to it.
  void add_strikes(int k) {
    for (int other = -1; other < k - 1; ++other) {
      if (lowest(k) > highest(other)) continue;
      for (const int side : {-1, 1}) {
        push_meeting({other, k, side * stack_.half_width(k), -stack_.half_height(k), 1}, Change::strike, 1,
                     k);
        if (other >= 0)
          push_meeting({k, other, side * stack_.half_width(other), stack_.half_height(other), -1},
                       Change::strike, 1, k);
      }
    }
  }

  std::vector<Guard<Real>> take() && { return std::move(guards_); }

 private:
  const ForceSeries<Real>& force(int k) const { return series_.forces[k]; }
  Polynomial<Real> slip(int k) const {
    return times(stack_.held_point(k, joints_[k]).upward, series_.along[k]);
  }
  /// Opening angle of a pivot.
  Polynomial<Real> opening_angle(int k) const {
    const Polynomial<Real>& upper = series_.bodies[k].angle;
    const int side = joints_[k].side();
    return k == 0 ? times(side, upper) : combined(side, upper, -side, series_.bodies[k - 1].angle);
  }
  Guard<Real>& push(const Polynomial<Real>& series, Change change, int k) {
    guards_.push_back({series, change, k});
    return guards_.back();
  }
  /// Only where a bound does not tell that the guard stays positive.
  void push_if_needed(const Polynomial<Real>& series, Change change, int k) {
    if (!stays_positive(series)) push(series, change, k);
  }
  /// A force, or one times `factor`. Of blocks that fly side by side it is rounding: no event may come of it.
  void push_force(const Polynomial<Real>& force, const Real& factor, int k) {
    const Real rounding = tolerance<Real>(1e-14) * factor * inertia_;
    if (std::any_of(force.begin(), force.end(), [&](const Real& part) { return abs(part) > rounding; }))
      push_if_needed(force, Change::force, k);
  }

  /// What is left of friction, μN ± T, by forces on the face that a slip goes along.
  void push_cone_side(const ForceSeries<Real>& force, int sign, int k) {
    const Real friction = stack_.friction[k];
    push_force(combined(friction, force.normal, sign, force.tangential), 1 + friction, k);
  }

  /// Both sides of the cone, where bounds do not tell that friction is left by more than rounding. A pair of
  /// corners asks one of them of the upper face: with φ the angle between the faces, what is left there, μN'
  /// + side T', is N (μ cos φ − side sin φ) + T (μ sin φ + side cos φ).
  void add_friction(int k, const Hull<Real>& normal) {
    const Joint<Real>& joint = joints_[k];
    const Real friction = stack_.friction[k];
    const Hull<Real> tangential = hull(force(k).tangential);
    const bool pair = !joint.settled && is_corner_pair(stack_, k, joint);
    for (const int sign : {-1, 1}) {
      const Real left = friction * normal.least + (sign > 0 ? tangential.least : -tangential.greatest);
      if (!pair || sign != joint.side()) {
        if (!(left > tolerance<Real>(1e-12) * (friction * normal.size() + tangential.size())))
          push_cone_side(force(k), sign, k);
        continue;
      }
      const Polynomial<Real> angle = opening_angle(k);
      const Real turn = abs(angle[0]) + reach(angle);
      // |sin φ| ≤ |φ|, and cos φ ≥ 1 − φ²/2.
      const Real bent = (1 + friction) * (turn + turn * turn / 2);
      if (!(left > bent * (normal.size() + tangential.size())))
        push_cone_side(on_upper_face(series_, k, force(k)), sign, k);
    }
  }

  /// How far the right or left end of the lower face is beyond that of the upper one.
  Polynomial<Real> overhang(int k, int side) const {
    return line(stack_.half_width(k - 1) - stack_.half_width(k), -side, slip(k));
  }
  /// Rounding of places along a face, m.
  Real rounding_along(int k) const { return tolerance<Real>(1e-13) * stack_.half_width(k); }
  /// Whose corner ends the overlap of a flat contact.
  bool ends_below(int k, int side) const {
    const Joint<Real>& joint = joints_[k];
    return corner_is_below(stack_, k, joint.offset, side, joint.slip);
  }

  /// N (end − centre of pressure), towards either end of the overlap; the moment is −N times the centre.
  void add_pressure(int k) {
    for (const int side : {-1, 1}) {
      Polynomial<Real> arm{stack_.half_width(k)};
      if (k > 0 && ends_below(k, side)) arm = line(stack_.half_width(k - 1), -side, slip(k));
      push_force(combined(1, product(force(k).normal, arm), side, force(k).moment), stack_.half_width(k), k);
    }
  }

  void add_flat_ends(int k) {
    for (const int side : {-1, 1}) {
      Polynomial<Real> ahead = times(ends_below(k, side) ? -1 : 1, overhang(k, side));
      // Corners that have just passed each other are even.
      if (abs(ahead[0]) <= rounding_along(k)) ahead[0] = 0;
      push_if_needed(ahead, Change::corner, k);
    }
  }

  void add_pivot_ends(int k) {
    const Joint<Real>& joint = joints_[k];
    const Polynomial<Real>& along = series_.along[k];
    const Real end = stack_.half_width(stack_.held_point(k, joint).face);
    // A pair of corners that slides along its face comes to a halt before it can be back.
    if (!is_corner_pair(stack_, k, joint) || slides_off(joint))
      push_if_needed(line(end, -joint.side(), along), Change::corner, k);
    push_if_needed(line(end, joint.side(), along), Change::fall, k);
  }

  void add_landings(int k) {
    for (const bool below : {false, true}) {
      if (below && k == 0) continue;
      for (const int side : {-1, 1}) {
        const CornerOnFace<Real> point = stack_.corner(k, side, below);
        Guard<Real>& guard = push_meeting(point, Change::landing, side, k);
        guard.below = below;
        guard.sunk = Real(longest_look_ahead * longest_look_ahead) * stack_.height();
        if (below || point.face < 0) continue;
        // A block falls that is wholly beyond an end of the face below, and no longer above it.
        const Polynomial<Real> height = guard.series, inside = guard.within_other;
        push(inside, Change::fall, k).other = height;
        push(height, Change::fall, k).other = inside;
      }
    }
  }

  /// A corner meets a face, whose ends on one side and on the other it is inside.
  Guard<Real>& push_meeting(const CornerOnFace<Real>& point, Change change, int side, int k) {
    const FaceSeries<Real> place = corner_series(stack_, series_, point);
    Guard<Real>& guard = push(line(-stack_.half_height(point.face), point.upward, place.above), change, k);
    guard.side = side;
    guard.rounding = rounding_along(k);
    if (point.face < 0) return guard;
    const Real end = stack_.half_width(point.face);
    guard.within = line(end, -side, place.along);
    guard.within_other = line(end, side, place.along);
    return guard;
  }

  /// How much a corner's turn may move it up or down, m.
  Real swing(int k) const {
    const Polynomial<Real>& angle = series_.bodies[k].angle;
    return (stack_.half_width(k) + abs(stack_.centre(k).x())) * (abs(angle[0]) + reach(angle));
  }
  /// Bounds of how low or high a body's corners come within the step, from the ground, m.
  Real lowest(int k) const {
    const Polynomial<Real> y = height(k);
    return y[0] - reach(y) - stack_.half_height(k) - stack_.centre(k).y() - swing(k);
  }
  Real highest(int k) const {
    if (k < 0) return 0;
    const Polynomial<Real> y = height(k);
    return y[0] + reach(y) + stack_.half_height(k) - stack_.centre(k).y() + swing(k);
  }
  Polynomial<Real> height(int k) const {
    return component(series_.bodies[k].centre, 1, series_.bodies[k].centre.terms);
  }

  const ContactModel<Real>& stack_;
  const Joints<Real>& joints_;
  const ModeSeries<Real>& series_;
  Real inertia_ = 0;  ///< what all blocks' accelerations take, in the unit of forces
  std::vector<Guard<Real>> guards_;
};

/// All guards of a mode, along a step.
template <class Real>
std::vector<Guard<Real>> guards_of(const ContactModel<Real>& stack, const Joints<Real>& joints,
                                   const std::vector<Real>& toppling_angles, const ModeSeries<Real>& series) {
  GuardCollector<Real> collector(stack, joints, series);
  for (int k = 0; k < stack.size(); ++k) {
    collector.add_interface(k);
    collector.add_toppling(k, toppling_angles[k]);
    collector.add_strikes(k);
  }
  return std::move(collector).take();
}

}  // namespace rockstack
