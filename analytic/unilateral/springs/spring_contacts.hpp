#pragma once

#include "analytic/scene/spring_checks.hpp"
#include "analytic/unilateral/springs/spring_guards.hpp"
#include "analytic/unilateral/springs/static_equilibrium.hpp"

namespace rockstack {

/// The springs of a stack along its motion: which corners push, where their sliders stand, what is lost.
template <class Real>
class SpringContacts {
 public:
  /// Keeps a reference to `stack`. Puts blocks onto springs, which soft interfaces have in place of joints.
  SpringContacts(const Scene& scene, const ContactModel<Real>& stack, ContactState<Real>& state)
      : stack_(stack), lost_(stack.blocks.size()), shown_(state.joints) {
    if (stack.springs.empty()) return;
    points_ = initial_points(stack, state);
    if (scene.initial.preloaded) preload(scene, stack, state, points_);
    for (std::size_t k = 0; k < state.joints.size(); ++k)
      if (stack.soft(k)) state.joints[k] = {.touch = Contact::apart};
    show();
  }

  bool empty() const { return points_.empty(); }
  const SpringPoints<Real>& points() const { return points_; }

  /// Joints with those of soft interfaces as their points touch: what histories tell.
  Joints<Real> shown(Joints<Real> joints) const {
    for (std::size_t k = 0; k < joints.size(); ++k)
      if (stack_.soft(k)) joints[k] = shown_[k];
    return joints;
  }

  /// The longest step over which series tell the fastest motion there may be, to rounding.
  Real longest_step(const Bodies<Real>& bodies) const {
    const Real rate = fastest_rate(stack_, points_, bodies);
    return rate > 0 ? Real(steps_per_rate) / rate : std::numeric_limits<Real>::infinity();
  }

  /// What springs make of bodies' acceleration.
  FreeVector<Real> accelerations(const Bodies<Real>& bodies) const {
    return stack_.inverse_mass.cwiseProduct(forces_of(stack_, points_, bodies));
  }

  /// Goes up to s of a step, over which bodies go from `before` to `after`.
  void go(const SpringSeries<Real>& series, const Real& s, const Bodies<Real>& before,
          const Bodies<Real>& after) {
    for (SpringPoint<Real>& point : points_) {
      if (s > 0) point.move_on();
      if (point.is_bed())
        losses(point).damped +=
            elastic_energy_of_bed(stack_, point, before) - elastic_energy_of_bed(stack_, point, after);
      if (point.press == Press::left_behind)
        losses(point).damped += elastic_energy(stack_, point, before) - elastic_energy(stack_, point, after);
    }
    for (const GrowingSpring<Real>& spring : series.springs()) {
      SpringPoint<Real>& point = points_[spring.index];
      add_losses(spring, series, s, losses(point));
      if (point.slide == 0 && spring.law.friction > 0) continue;
      const Real slip = kinematics_of(stack_, after, point).slip;
      point.slider = spring.law.friction == 0 ? slip : slip - value(spring.stretch, s);
    }
    show();
  }

  /// Changes a point as its guard says; not where another guard at the same time has changed it.
  void apply(const SpringGuard<Real>& guard, const Bodies<Real>& bodies) {
    SpringPoint<Real>& point = points_[guard.point];
    const SpringLaw<Real>& law = stack_.springs[point.interface];
    if (guard.change >= SpringChange::bed_depth) return apply_to_bed(guard, bodies);
    if (point.press != pressed_before(guard.change)) return;
    const bool moves = point.slide != 0 || law.friction == 0;
    if (guard.change == SpringChange::slide ? moves : guard.change >= SpringChange::grip && !moves) return;
    const Real held = elastic_energy(stack_, point, bodies);
    const auto is = [&](SpringChange change) { return guard.change == change; };
    if (is(SpringChange::touch)) point.corner_below = guard.below;
    if (is(SpringChange::touch) || is(SpringChange::push_again)) start_pushing(point, bodies);
    if (is(SpringChange::touch))
      point.at_face =
          abs(kinematics_of(stack_, bodies, point).gap) <= SpringRounding<Real>(stack_, bodies).place;
    if (is(SpringChange::part) || is(SpringChange::leave)) {
      // However shallow a depth is, its spring is left behind: taken for zero, it would touch at once.
      const bool stays = is(SpringChange::part) && law.damping > 0 && !point.at_face;
      point.press = stays ? Press::left_behind : Press::off;
      point.at_face = !stays;
    }
    if (is(SpringChange::part) || is(SpringChange::grip)) point.slide = 0;
    if (is(SpringChange::slide)) point.slide = guard.way;
    if (is(SpringChange::pass)) pass_to_other_corner(stack_, bodies, point);
    losses(point).damped += held - elastic_energy(stack_, point, bodies);
    if (guard.change == SpringChange::pass) losses(point).rubbed += slip_at_once(stack_, bodies, point);
  }

  /// Tells how soft interfaces touch now.
  void show() {
    std::vector<int> ends(shown_.size(), 0);
    for (const SpringPoint<Real>& point : points_) {
      if (!point.pushes()) continue;
      const int k = point.interface;
      Joint<Real>& joint = shown_[k];
      if (point.is_bed()) {
        ends[k] = 2;
        joint = {touch_of(point.bed), point.slide, point.corner_below, false, point.slider};
        continue;
      }
      const bool first = ends[k]++ == 0;
      joint.touch = static_cast<Contact>(point.side);
      joint.corner_below = point.corner_below;
      joint.slip = first || joint.slip == point.slide ? point.slide : 0;
      const Real offset = point.slider - slip_from_offset(stack_, point.interface, joint);
      joint.offset = first ? offset : Real((joint.offset + offset) / 2);
      if (!first) joint.touch = Contact::closed;
    }
    for (std::size_t k = 0; k < shown_.size(); ++k)
      if (stack_.soft(k) && ends[k] == 0) shown_[k] = {.touch = Contact::apart, .offset = shown_[k].offset};
  }

  /// What the springs of each interface do.
  std::vector<SpringState<Real>> states(const Bodies<Real>& bodies) const {
    if (points_.empty()) return {};
    std::vector<SpringState<Real>> result(stack_.blocks.size());
    for (std::size_t k = 0; k < result.size(); ++k) result[k].energy = lost_[k];
    for (const SpringPoint<Real>& point : points_) {
      SpringState<Real>& state = result[point.interface];
      const CornerOnFace<Real> corner = corner_of(stack_, point);
      const ContactKinematics<Real> rows = kinematics_of(stack_, bodies, corner);
      const PointForce<Real> force = force_of(stack_, point, bodies, rows);
      state.reaction.normal += force.normal;
      state.reaction.tangential += force.tangential;
      // From the middle of the block above: its own corner, or where that of the block below is under it.
      state.reaction.centre += force.normal * (point.corner_below ? Real(-rows.slip) : corner.x);
      if (point.is_bed()) state.reaction.centre += force.couple * (2 * stack_.half_width(corner.body));
      state.energy.elastic += elastic_energy(stack_, point, bodies);
    }
    for (std::size_t k = 0; k < result.size(); ++k) {
      BasicReaction<Real>& reaction = result[k].reaction;
      reaction.centre = reaction.normal > 0 ? Real(reaction.centre / reaction.normal)
                                            : std::numeric_limits<Real>::quiet_NaN();
    }
    return result;
  }

 private:
  /// What histories tell of a bed: which of its ends press.
  static Contact touch_of(const BedState& bed) {
    const auto bound = [&](std::size_t end) { return bound_of(bed, end) == BedBound::end; };
    if (bound(0) == bound(1)) return Contact::closed;
    return bound(0) ? Contact::left : Contact::right;
  }

  /// A sign of a bed changes, if no other guard has changed it; at the other end too where that is rounding.
  void apply_to_bed(const SpringGuard<Real>& guard, const Bodies<Real>& bodies) {
    SpringPoint<Real>& point = points_[guard.point];
    BedState& bed = point.bed;
    const SpringLaw<Real>& law = stack_.springs[point.interface];
    const GrowingBed<Real> now = bed_at(stack_, point, bodies);
    const Real held = elastic_energy(stack_, point, bodies);
    const bool above = guard.way > 0;
    const SpringRounding<Real> rounding(stack_, bodies);
    if (guard.change == SpringChange::bed_crossing) {
      if (bed.crossed != above) return;
      bed.crossed = !above;
      bed.at_crossing = true;
    } else {
      const bool depth = guard.change == SpringChange::bed_depth;
      for (std::size_t end = 0; end < 2; ++end) {
        BedEnd& here = bed.ends[end];
        if ((depth ? here.deep : here.presses) != above) continue;
        const Real left = depth ? now.depth[end][0] : now.pressure[end][0];
        if (end != guard.end && abs(left) > 2 * (depth ? rounding.place : rounding.normal(law))) continue;
        // Without dashpots both quantities are one.
        if (depth || law.damping == 0) {
          here.deep = !above;
          here.at_face = true;
        }
        if (!depth || law.damping == 0) here.presses = !above;
      }
      if (law.damping > 0 && !bed.at_crossing) bed.crossed = now.crosses();
    }
    const bool presses = stretch_of(bed).presses;
    if (presses && !point.pushes()) start_pushing(point, bodies);
    if (!presses) {
      point.slide = 0;
      point.press = Press::off;
    }
    losses(point).damped += held - elastic_energy(stack_, point, bodies);
  }

  static Press pressed_before(SpringChange change) {
    if (change == SpringChange::touch) return Press::off;
    const bool behind = change == SpringChange::push_again || change == SpringChange::leave;
    return behind ? Press::left_behind : Press::pushing;
  }

  BasicSpringEnergy<Real>& losses(const SpringPoint<Real>& point) { return lost_[point.interface]; }

  void start_pushing(SpringPoint<Real>& point, const Bodies<Real>& bodies) {
    point.press = Press::pushing;
    point.slide = 0;
    point.slider = kinematics_of(stack_, bodies, point).slip;
  }

  const ContactModel<Real>& stack_;
  SpringPoints<Real> points_;
  std::vector<BasicSpringEnergy<Real>> lost_;
  Joints<Real> shown_;
};

}  // namespace rockstack
