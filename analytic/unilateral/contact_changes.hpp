#pragma once

#include <functional>

#include "analytic/scene/history.hpp"
#include "analytic/unilateral/contact/contact_modes.hpp"
#include "analytic/unilateral/first_change.hpp"

namespace rockstack {

/// A joint as it is at one end, where it touches along all of it.
template <class Real>
Joint<Real> end_of(const ContactModel<Real>& stack, int interface, Joint<Real> joint, int side) {
  if (joint.touch == Contact::closed)
    joint.corner_below = corner_is_below(stack, interface, joint.offset, side, joint.slip);
  joint.touch = static_cast<Contact>(side);
  return joint;
}

/// Whether the point of a joint parts at more than `speed`, m/s.
template <class Real>
bool parts(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface,
           const Joint<Real>& joint, const Real& speed) {
  return kinematics_of(stack, bodies, interface, joint).gap_row.dot(vector_of(bodies.velocity)) > speed;
}

/// How fast the gap of a joint that comes to touch closes, m/s: at the end of it where that is fastest.
template <class Real>
Real closing_speed(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface,
                   const Joint<Real>& joint) {
  Real fastest = 0;
  for (const int side : {-1, 1}) {
    if (joint.pivots() && side != joint.side()) continue;
    const Joint<Real> end = end_of(stack, interface, joint, side);
    const Real opening = kinematics_of(stack, bodies, interface, end).gap_row.dot(vector_of(bodies.velocity));
    fastest = std::max<Real>(fastest, -opening);
  }
  return fastest;
}

/// The end of the motion that a change is, if it is one.
inline std::optional<EventKind> ending(Change change) {
  static constexpr std::array kinds{EventKind::topple, EventKind::fall, EventKind::strike};
  if (change < Change::topple) return {};
  return kinds[static_cast<std::size_t>(change) - static_cast<std::size_t>(Change::topple)];
}

/// Chatter ends as in analytic/events/chatter.hpp: where what an impact parts would part no further than the
/// resolution ρ before it comes back, u²/(2a) ≤ ρ, or at 500 ε √(g/H), it stays together. Gaps count as what
/// they would turn a block by across its width. A joint that bounces alone, without a turn, does so to the
/// latter: what is left of its series, 2u/(a (1 − e)) s, is rounding then.
///
/// Where several points bounce, what is held at one gives another back the speed that it has lost, and
/// chatter may go on at some speeds that end it. So where points bounce, ρ grows by four with each 2000
/// events of a burst, as EventLimit counts them, up to 10⁻¹⁰.
template <class Real>
class ContactChatter {
 public:
  /// Keeps a reference to `stack`. Resolution 0 is the rounding of 1.
  ContactChatter(const ContactModel<Real>& stack, const Real& gravity, const Real& resolution)
      : stack_(stack),
        least_(resolution > 0 ? resolution : std::numeric_limits<Real>::epsilon()),
        resolution_(least_) {
    rate_ = gravity / stack.height();
    const Real rounding = std::min<Real>(resolution_, std::numeric_limits<double>::epsilon());
    slow_speed_ = 500 * rounding * sqrt(rate_);
    negligible_gap_ = std::max<Real>(tolerance<Real>(1e-13),
                                     Real(1e-13) * (rounding / Real(std::numeric_limits<double>::epsilon())));
  }

  /// Events that have followed each other.
  void note_burst(int events) {
    if (stack_.restitution == 0) return;
    constexpr int patience = 2000;
    resolution_ = least_;
    for (int past = events; past >= patience && 4 * resolution_ <= Real(1e-10); past -= patience)
      resolution_ *= 4;
  }

  /// What is apart by less has not parted, in shares of a block's half-width: some roundings of it.
  const Real& negligible_gap() const { return negligible_gap_; }
  /// What parts no faster has not parted, m/s.
  Real slow_speed(int interface) const { return slow_speed_ * stack_.half_width(interface); }

  /// What touches and parts faster than this, m/s, has bounced and takes no part in an impact. Without
  /// restitution all that touches takes part, as Moreau's law has it.
  Real bounced_speed(int interface) const {
    return stack_.restitution > 0 ? slow_speed(interface) : std::numeric_limits<Real>::infinity();
  }

  /// Open by what rounding makes of angles and speeds.
  bool negligibly_open(const Joint<Real>& joint, const Real& angle, const Real& angle_rate) const {
    return joint.pivots() && abs(angle_rate) <= slow_speed_ &&
           abs(angle) * rate_ <= slow_speed_ * slow_speed_;
  }

  /// A mode that follows an impact of `touching`, with the joints held that part too slowly to be followed.
  /// `free` is the acceleration without contact.
  Joints<Real> without_slow(const Joints<Real>& touching, const Joints<Real>& mode, const Bodies<Real>& after,
                            const FreeVector<Real>& free) const {
    if (surely_fast(touching, mode, after, free)) return mode;
    const FreeVector<Real> acceleration =
        respond<Real>({stack_, after, free, ContactLevel::accelerations}, mode).motion;
    const FreeVector<Real> rates = vector_of(after.velocity);
    Joints<Real> result = mode;
    const bool one_flies =
        std::count_if(mode.begin(), mode.end(), std::mem_fn(&Joint<Real>::touches)) == stack_.size() - 1;
    for (int k = 0; k < stack_.size(); ++k) {
      const auto hold = [&](Joint<Real> held) {
        if (!held.touches()) return false;
        held.slip = mode[k].slip;
        if (!mode[k].touches()) {
          const Real speed = kinematics_of(stack_, after, k, held).slip_row.dot(rates);
          held.slip = (speed > slow_speed(k)) - (speed < -slow_speed(k));
          // Corners part by the face that they would slide along: the other one is beside the corner from now
          // on.
          meet_face(stack_, k, held);
        }
        if (!parts_slowly(k, held, mode[k], after, acceleration, one_flies)) return false;
        result[k] = held;
        return true;
      };
      if (hold(touching[k]) || stack_.restitution == 0 || mode[k].touches()) continue;
      if (touching[k].touch == Contact::closed && !hold(end_of(stack_, k, touching[k], -1)))
        hold(end_of(stack_, k, touching[k], 1));
    }
    return result;
  }

 private:
  /// Whether all sticks, and interfaces that part turn so fast that no force brings them back.
  bool surely_fast(const Joints<Real>& touching, const Joints<Real>& mode, const Bodies<Real>& after,
                   const FreeVector<Real>& free) const {
    if (!std::ranges::all_of(mode, std::mem_fn(&Joint<Real>::sticks))) return false;
    const Real most = most_turning(stack_, after.velocity, free);
    for (std::size_t k = 0; k < mode.size(); ++k) {
      if (touching[k].touch == mode[k].touch) continue;
      const Real speed = abs(relative_angle(after.velocity, k));
      if (!(speed > slow_speed_ && speed * speed > 2 * resolution_ * most)) return false;
    }
    return true;
  }

  bool parts_slowly(int interface, const Joint<Real>& touching, const Joint<Real>& mode,
                    const Bodies<Real>& after, const FreeVector<Real>& acceleration, bool alone) const {
    const bool bounces = alone && !mode.touches() && stack_.restitution > 0 &&
                         (touching.pivots() || abs(relative_angle(after.velocity, interface)) <= slow_speed_);
    const auto slow = [&](const Real& speed, const Real& back, const Real& unit) {
      return speed <= slow_speed_ * unit || (!bounces && speed * speed <= -2 * resolution_ * unit * back);
    };
    const FreeVector<Real> rates = vector_of(after.velocity);
    if (mode.pivots() && touching.touch == Contact::closed) {
      const FreeRow<Real> turn = angle_row<Real>(stack_, interface);
      return slow(abs(turn.dot(rates)), mode.side() * turn.dot(acceleration), 1);
    }
    if (mode.touches() || !touching.touches()) return false;
    const Real width = 2 * stack_.half_width(interface);
    for (const int side : {-1, 1}) {
      if (touching.pivots() && side != touching.side()) continue;
      const Joint<Real> end = end_of(stack_, interface, touching, side);
      const ContactKinematics<Real> rows = kinematics_of(stack_, after, interface, end);
      if (!slow(rows.gap_row.dot(rates), rows.gap_row.dot(acceleration) + rows.gap_bias, width)) return false;
    }
    return true;
  }

  const ContactModel<Real>& stack_;
  Real least_, resolution_;  ///< rad
  Real rate_{};              ///< g/H, 1/s²
  Real slow_speed_{};        ///< rad/s
  Real negligible_gap_{};
};

/// A joint that a corner of an interface has come to by landing. An end that parts at more than `speed`, m/s,
/// has bounced, and takes no part: in a series of bounces gaps are below rounding while speeds are not.
template <class Real>
void land(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface, bool below,
          const Real& speed, Joints<Real>& joints) {
  Joint<Real>& joint = joints[interface];
  const Real angle = relative_angle(bodies.pose, interface);
  joint.slip = 0;
  if (abs(angle) <= flat_angle<Real>) {
    joint.touch = Contact::closed;
  } else {
    joint.touch = angle > 0 ? Contact::right : Contact::left;
    joint.corner_below = below;
  }
  joint.offset = offset_of(stack, bodies, interface, joint);
  if (joint.touch != Contact::closed) return;
  const Joint<Real> flat = joint;
  for (const int side : {-1, 1})
    if (parts(stack, bodies, interface, end_of(stack, interface, flat, side), speed))
      joint = end_of(stack, interface, flat, -side);
}

/// The other corner takes over where one has come to the end of its face; true where it meets the face.
template <class Real>
bool pass_corner(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface,
                 Joints<Real>& joints) {
  Joint<Real>& joint = joints[interface];
  if (!joint.pivots()) return false;
  joint.corner_below = !joint.corner_below;
  joint.offset = offset_of(stack, bodies, interface, joint);
  const ContactKinematics<Real> rows = kinematics_of(stack, bodies, interface, joint);
  const FreeVector<Real> rates = vector_of(bodies.velocity);
  const Real speed = rows.gap_row.dot(rates);
  const Real rounding = tolerance<Real>(1e-13) * (rows.gap_row.cwiseAbs().dot(rates.cwiseAbs()));
  if (speed > rounding) {
    joint.touch = Contact::apart;
    joint.slip = 0;
  }
  return speed < -rounding;
}

/// Lands what is above its face by no more than `gap`, m, and does not part at more than `speed`, m/s.
template <class Real>
void land_negligible(const ContactModel<Real>& stack, const Bodies<Real>& bodies, int interface,
                     const Real& gap, const Real& speed, Joints<Real>& joints) {
  const FreeVector<Real> rates = vector_of(bodies.velocity);
  for (const bool below : {true, false}) {
    if (below && interface == 0) continue;
    for (const int side : {-1, 1}) {
      if (side * relative_angle(bodies.pose, interface) < -flat_angle<Real>) continue;
      const CornerOnFace<Real> corner = stack.corner(interface, side, below);
      const ContactKinematics<Real> rows = kinematics_of(stack, bodies, corner);
      if (abs(rows.gap) <= gap && rows.gap_row.dot(rates) <= speed &&
          abs(rows.slip) <= stack.half_width(corner.face) + gap)
        land(stack, bodies, interface, below, speed, joints);
    }
  }
}

/// Closes what is open by rounding, so that all that meets at one instant is one impact.
template <class Real>
void close_negligible(const ContactModel<Real>& stack, const ContactChatter<Real>& chatter,
                      const Bodies<Real>& bodies, Joints<Real>& joints) {
  for (int k = 0; k < stack.size(); ++k) {
    const Real gap = chatter.negligible_gap() * stack.half_width(k);
    if (!joints[k].touches() && !stack.soft(k))
      land_negligible(stack, bodies, k, gap, chatter.bounced_speed(k), joints);
    if (chatter.negligibly_open(joints[k], relative_angle(bodies.pose, k),
                                relative_angle(bodies.velocity, k)))
      joints[k].touch = Contact::closed;
  }
}

/// Changes joints as the guards that end say; true where blocks meet.
template <class Real>
bool apply(const FirstChange<Real>& found, const ContactModel<Real>& stack,
           const ContactChatter<Real>& chatter, const Bodies<Real>& bodies, Joints<Real>& joints) {
  bool meets = false;
  for (const Guard<Real>& guard : found.guards) {
    Joint<Real>& joint = joints[guard.interface];
    if (guard.change == Change::closing) joint.touch = Contact::closed;
    if (guard.change == Change::halt) joint.slip = 0;
    const bool lands = guard.change == Change::landing;
    if (lands && !joint.touches())
      land(stack, bodies, guard.interface, guard.below, chatter.bounced_speed(guard.interface), joints);
    if (lands || guard.change == Change::closing ||
        (guard.change == Change::corner && pass_corner(stack, bodies, guard.interface, joints)))
      meets = true;
  }
  return meets;
}

}  // namespace rockstack
