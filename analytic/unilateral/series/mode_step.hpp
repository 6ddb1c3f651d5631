#pragma once

#include "analytic/steps/body_force.hpp"
#include "analytic/steps/landing.hpp"
#include "analytic/steps/restraint_series.hpp"
#include "analytic/unilateral/series/held_joint.hpp"

namespace rockstack {

/// Lets the series of a step, empty at first, grow, order by order. `known` are the forces of springs: each
/// order of theirs follows from the same order of places and velocities.
template <class Real, class Known>
class SeriesMaker {
 public:
  SeriesMaker(const ContactModel<Real>& stack, const Joints<Real>& joints, const Bodies<Real>& start,
              Known& known, ModeSeries<Real>& series)
      : stack_(stack), joints_(joints), start_(start), known_(known), series_(series) {
    series_.bodies.resize(joints.size());
    series_.forces.resize(joints.size());
    series_.along.resize(joints.size());
    for (std::size_t k = 0; k < joints.size(); ++k) {
      BodySeries<Real>& body = series_.bodies[k];
      const Pose<Real>& at = start.pose[k];
      body.centre[0] = {at.x, at.y};
      body.angle[0] = at.angle;
      body.up.terms = max_terms<Real>;
      set_axes<Real>(body, 0, {sin(at.angle), cos(at.angle)});
    }
    std::size_t count = 0;
    for (const Joint<Real>& joint : joints_) count += joint.touches();
    held_.resize(count);
    std::size_t at = 0;
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      if (!joints_[k].touches()) continue;
      held_[at].start(stack_, joints_[k], k, series_);
      held_[at++].each_row([&](const auto& row) { rows_[size_++] = &row; });
    }
    system_ =
        LinearSystem<Real>(size_, [&](std::size_t i, std::size_t j) { return rows_[i]->dot(*rows_[j]); });
  }

  /// What is known before accelerations are, for a step of that length.
  void begin(const Real& length) {
    series_.length = length;
    series_.force_unit = 1 / (length * length);
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      BodySeries<Real>& body = series_.bodies[k];
      const Pose<Real>& rate = start_.velocity[k];
      body.centre[1] = {rate.x * length, rate.y * length};
      body.up[1] = Point<Real>::Zero();
      turn<Real>(body, 1, rate.angle * length);
    }
    for (HeldJoint<Real>& joint : held_) joint.begin();
    known_.begin(series_);
    restraints_.clear();
    for (const RestraintLaw<Real>& law : stack_.restraints) restraints_.push_back({law, length});
  }

  /// The share of the step by whose end the first pivot has come back, from order 0. `rate`: see landing().
  Real first_landing(const Real& length, const Real& rate) const {
    Real first = 1;
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      if (!joints_[k].pivots()) continue;
      const auto open = [&](std::size_t m) -> Real {
        const Real below = k > 0 ? series_.bodies[k - 1].angle[m] : Real(0);
        return joints_[k].side() * (series_.bodies[k].angle[m] - below);
      };
      first = std::min(first, landing<Real>(open(0), open(1), 2 * open(2), length, rate));
    }
    return first;
  }

  void extend(std::size_t n, const ScaledBodyForce<Real>& body_force) {
    const std::size_t m = n + 2;
    const auto order = static_cast<int>(m);
    const Real factor = Real(order) * Real(order - 1);
    for (BodySeries<Real>& body : series_.bodies) begin_axes(body, m);
    for (std::size_t k = 0; held_.size() < joints_.size() && k < joints_.size(); ++k)
      if (!joints_[k].touches()) series_.forces[k].normal[n] = series_.forces[k].tangential[n] = 0;
    for (HeldJoint<Real>& joint : held_) joint.begin(series_.forces[joint.interface()], m);
    if (!known_.springs().empty()) known_.extend_forces(n, series_.forces);
    ChainVector<Real> motion;
    for (GrowingRestraint<Real>& restraint : restraints_) restraint.extend(n, apart_of(restraint));
    accelerate(n, body_force, motion);
    constrain(n, factor, motion);
    const Real* own = &motion[3];
    for (BodySeries<Real>& body : series_.bodies) {
      body.centre[m] = {own[0] / factor, own[1] / factor};
      turn<Real>(body, m, own[2] / factor);
      own += 3;
    }
    for (HeldJoint<Real>& joint : held_) joint.end(series_.forces[joint.interface()], m);
    known_.extend_places(m);
  }

  /// The largest coefficient of order m, positions over a length, angles and directions as they are.
  Real size_of(std::size_t m, const Real& unit) const {
    using std::max;
    Real place = known_.size_of(m), turn = 0;
    for (const BodySeries<Real>& body : series_.bodies) {
      place = max<Real>(place, max<Real>(abs(body.centre[m].x()), abs(body.centre[m].y())));
      turn =
          max<Real>(turn, max<Real>(abs(body.angle[m]), max<Real>(abs(body.up[m].y()), abs(body.up[m].x()))));
    }
    return max<Real>(place / unit, turn) * Real(m);
  }

  /// The largest coefficient of order n of forces.
  Real force_of(std::size_t n) const {
    Real size = 0;
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      size = std::max<Real>(size, abs(series_.forces[k].normal[n]));
      size = std::max<Real>(size, abs(series_.forces[k].tangential[n]));
    }
    return size;
  }

  /// Finishes so many orders of accelerations, over a step `ratio` times as long where that is less than one.
  void finish(std::size_t orders, const Real& ratio) {
    for (BodySeries<Real>& body : series_.bodies)
      body.centre.terms = body.angle.terms = body.along.terms = body.up.terms = orders + 2;
    for (ForceSeries<Real>& force : series_.forces) force.normal.terms = force.tangential.terms = orders;
    for (const HeldJoint<Real>& joint : held_) {
      if (joint.flat()) series_.forces[joint.interface()].moment.terms = orders;
      series_.along[joint.interface()] =
          joint.point().place_from_middle(joint.sticks() ? 1 : orders + 2).along;
    }
    for (GrowingRestraint<Real>& restraint : restraints_) {
      restraint.extend_length(orders + 1, apart_of(restraint));
      series_.lengths.push_back(restraint.length);
    }
    if (!(ratio < 1)) return;
    known_.rescale_by(ratio);
    for (Polynomial<Real>& length : series_.lengths) rescale(length, ratio);
    series_.length *= ratio;
    for (BodySeries<Real>& body : series_.bodies) {
      rescale(body.angle, ratio);
      for (PlaneSeries<Real>* part : {&body.centre, &body.along, &body.up}) rescale(*part, ratio);
    }
    for (ForceSeries<Real>& force : series_.forces)
      for (Polynomial<Real>* part : {&force.normal, &force.tangential, &force.moment}) rescale(*part, ratio);
    for (Polynomial<Real>& along : series_.along) rescale(along, ratio);
  }

 private:
  /// Coefficient n of accelerations by all forces, of contact forces by those that are known.
  void accelerate(std::size_t n, const ScaledBodyForce<Real>& body_force, ChainVector<Real>& motion) const {
    const Real x = coefficient(body_force.x, n), y = coefficient(body_force.y, n);
    std::fill_n(motion.begin(), 3, Real(0));
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const Real mass = stack_.blocks[k].mass;
      Real* own = &motion[3 * (k + 1)];
      own[0] = mass * x;
      own[1] = mass * y;
      own[2] = 0;
    }
    for (const HeldJoint<Real>& joint : held_) joint.add_force(series_.forces[joint.interface()], n, motion);
    known_.add_forces(n, motion);
    for (std::size_t i = 0; i < body_force.pushes.size(); ++i)
      add_push(stack_.pushes[i], body_force.pushes[i], n, motion);
    for (const GrowingRestraint<Real>& restraint : restraints_) {
      add_pull(restraint, restraint.law.from, restraint.law.from_arm, 1, n, motion);
      add_pull(restraint, restraint.law.to, restraint.law.to_arm, -1, n, motion);
    }
    const Real* lightness = stack_.inverse_mass.data();
    for (std::size_t k = 0; k < joints_.size(); ++k, lightness += 3) {
      Real* own = &motion[3 * (k + 1)];
      own[0] *= lightness[0];
      own[1] *= lightness[1];
      own[2] *= lightness[2];
    }
  }

  /// Coefficient m of the way from one end of a restraint to the other.
  auto apart_of(const GrowingRestraint<Real>& restraint) const {
    return [this, &restraint](std::size_t m) {
      const auto place = [&](int body, const Point<Real>& arm) -> Point<Real> {
        const BodySeries<Real>& series = *series_.body(body);
        return series.centre[m] + turned(series, arm, m);
      };
      const Point<Real> apart =
          place(restraint.law.to, restraint.law.to_arm) - place(restraint.law.from, restraint.law.from_arm);
      return PlaneVector<Real>{apart.x(), apart.y()};
    };
  }

  /// Adds coefficient n of the force of a restraint at one end, and of its moment.
  void add_pull(const GrowingRestraint<Real>& restraint, int body, const Point<Real>& arm, int way,
                std::size_t n, ChainVector<Real>& motion) const {
    if (body < 0) return;
    const auto force = [&](std::size_t m) -> Point<Real> {
      return Real(way) * Point<Real>(restraint.force_x[m], restraint.force_y[m]);
    };
    Real* own = &motion[3 * (static_cast<std::size_t>(body) + 1)];
    own[0] += force(n).x();
    own[1] += force(n).y();
    for (std::size_t m = 0; m <= n; ++m)
      own[2] += quarter_turned<Real>(turned(*series_.body(body), arm, n - m)).dot(force(m));
  }

  /// Adds coefficient n of a push, and of its moment.
  void add_push(const PushPoint<Real>& push, const Polynomial<Real>& size, std::size_t n,
                ChainVector<Real>& motion) const {
    const auto k = static_cast<std::size_t>(push.block);
    const Point<Real> force = coefficient(size, n) * push.direction;
    Real moment = 0;
    for (std::size_t m = 0; m < std::min(size.terms, n + 1); ++m)
      moment +=
          size[m] * quarter_turned<Real>(turned(series_.bodies[k], push.arm, n - m)).dot(push.direction);
    Real* own = &motion[3 * (k + 1)];
    own[0] += force.x();
    own[1] += force.y();
    own[2] += moment;
  }

  /// Changes coefficient n of accelerations so that what is held stays so at order n + 2; notes its forces.
  void constrain(std::size_t n, const Real& factor, ChainVector<Real>& motion) {
    if (held_.empty()) return;
    std::array<Real, std::size_t{3} * max_blocks> conditions, unknowns;
    for (std::size_t i = 0; i < size_; ++i)
      conditions[i] = -(rows_[i]->dot(motion) + factor * rows_[i]->left);
    system_.solve(conditions.data(), unknowns.data());
    for (std::size_t i = 0; i < size_; ++i) rows_[i]->act(unknowns[i], motion);
    const Real* unknown = unknowns.data();
    for (const HeldJoint<Real>& joint : held_)
      unknown = joint.note_force(unknown, n, series_.forces[joint.interface()]);
  }

  const ContactModel<Real>& stack_;
  const Joints<Real>& joints_;
  const Bodies<Real>& start_;
  Known& known_;
  ModeSeries<Real>& series_;
  ShortVector<HeldJoint<Real>> held_;
  std::size_t size_ = 0;
  std::array<const typename HeldJoint<Real>::Row*, std::size_t{3} * max_blocks> rows_;  ///< of what is held
  LinearSystem<Real> system_;
  std::vector<GrowingRestraint<Real>> restraints_;
};

/// A step's series, of the length planned or of less. `lengthens`: they reached the length early.
template <class Real>
struct ModeStep {
  Real planned = 0;  ///< s
  ModeSeries<Real> series;
  bool lengthens = false;
};

/// The series over `length`, or over less of it: no longer than until a pivot has come back, but for
/// `shortest`, and not where they would leave out more than rounding of positions, or of forces, their second
/// derivatives, more than what events need. `unit_time` is √(H/g), s.
template <class Real, class Known>
ModeStep<Real> mode_step(const ContactModel<Real>& stack, const Joints<Real>& joints,
                         const Bodies<Real>& bodies, ScaledBodyForce<Real> body_force, const Real& length,
                         const Real& shortest, const Real& unit_time, Known& known) {
  const Real unit = stack.height();
  ModeStep<Real> step;
  step.planned = length;
  SeriesMaker<Real, Known> maker(stack, joints, bodies, known, step.series);
  maker.begin(length);
  maker.extend(0, body_force);
  const Real share = std::max<Real>(maker.first_landing(length, 1 / unit_time), shortest / length);
  if (share < 1) {
    step.planned *= share;
    shorten(body_force, share);
    maker.begin(step.planned);
    maker.extend(0, body_force);
  }
  const std::size_t body_force_terms = body_force.terms();
  constexpr std::size_t most = max_orders<Real>;
  std::size_t orders = 0;
  // What the last two coefficients leave out, in shares of what is negligible.
  const auto of_position = [&](std::size_t m) {
    return maker.size_of(m, unit) / (std::numeric_limits<Real>::epsilon() / 16);
  };
  Real force = std::numeric_limits<Real>::min();
  Real last = 0, of_forces = 0;
  bool reached = false;
  while (orders < most && !(reached && orders >= body_force_terms)) {
    if (orders > 0) maker.extend(orders, body_force);
    const Real own = maker.force_of(orders);
    force = std::max(force, own);
    const Real before = std::exchange(last, own / force);
    of_forces = std::max(last, before) / tolerance<Real>(1e-8);
    ++orders;
    reached = of_forces <= 1 && of_position(orders + 1) <= 1 && of_position(orders) <= 1 &&
              orders > 2 + known.silent_orders();
  }
  const auto excess = [&] { return std::max({of_position(orders + 1), of_position(orders), of_forces}); };
  const Real ratio = reached ? Real(1) : Real(0.9) * pow(1 / excess(), 1 / Real(most));
  maker.finish(orders, std::min(ratio, Real(1)));
  step.lengthens = orders + 2 < most;
  return step;
}

}  // namespace rockstack
