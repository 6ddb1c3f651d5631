#pragma once

#include "analytic/steps/body_force.hpp"
#include "analytic/steps/landing.hpp"
#include "analytic/unilateral/series/held_points.hpp"

namespace rockstack {

/// Lets the series of a step, empty at first, grow, order by order. `known` are the forces of springs: each
/// order of theirs follows from the same order of places and velocities.
template <class Real, class Known>
class SeriesMaker {
 public:
  SeriesMaker(const ContactModel<Real>& stack, const Joints<Real>& joints, const Bodies<Real>& start,
              Known& known, ModeSeries<Real>& series)
      : stack_(stack),
        joints_(joints),
        start_(start),
        known_(known),
        ground_(ground_series<Real>()),
        series_(series),
        held_(stack) {
    series_.bodies.resize(joints.size());
    series_.forces.resize(joints.size());
    series_.held.resize(joints.size());
    points_.reserve(joints.size());
    hold();
  }

  /// What is known before accelerations are, for a step of that length.
  void begin(const Real& length) {
    series_.length = length;
    series_.force_unit = 1 / (length * length);
    for (std::size_t k = 0; k < joints_.size(); ++k) begin(series_.bodies[k], start_.at[k], start_.rate[k]);
    for (ForceSeries<Real>& force : series_.forces)
      force.normal.terms = force.tangential.terms = force.moment.terms = 0;
    begin_points();
    known_.begin([this](int body) { return body_of(body); }, length);
  }

  /// The share of the step by whose end the first pivot has come back. `rate`: see landing(). The series has
  /// its order 0.
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
    const Real factor = Real(m) * Real(m - 1);
    for (BodySeries<Real>& body : series_.bodies) begin_direction(body, m);
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      ForceSeries<Real>& force = series_.forces[k];
      if (!joints_[k].touches())
        for (Polynomial<Real>* part : {&force.normal, &force.tangential}) put(*part, n, 0);
    }
    for (HeldPoint<Real>& point : points_) point.begin(series_.forces[point.interface()], m);
    known_.extend_forces(n, series_.forces);
    FreeVector<Real> motion = stack_.inverse_mass.cwiseProduct(forces(n, body_force));
    held_.constrain(points_, n, motion, series_.forces);
    for (std::size_t k = 0; k < series_.bodies.size(); ++k) {
      BodySeries<Real>& body = series_.bodies[k];
      const auto first = 3 * static_cast<Eigen::Index>(k);
      put(body.x, m, motion[first] / factor);
      put(body.y, m, motion[first + 1] / factor);
      turn<Real>(body, m, motion[first + 2] / factor);
    }
    for (HeldPoint<Real>& point : points_) point.end(series_.forces[point.interface()], m);
    known_.extend_places(m);
  }

  /// The largest coefficient of order m, positions over a length, angles and directions as they are.
  Real size_of(std::size_t m, const Real& unit) const {
    using std::abs;
    using std::max;
    Real place = known_.size_of(m);
    Real turn = 0;
    for (const BodySeries<Real>& body : series_.bodies) {
      place = max<Real>(place, max<Real>(abs(body.x[m]), abs(body.y[m])));
      turn =
          max<Real>(turn, max<Real>(abs(body.angle[m]), max<Real>(abs(body.cosine[m]), abs(body.sine[m]))));
    }
    return max<Real>(place / unit, turn) * Real(m);
  }

  /// The largest coefficient of order n of forces.
  Real force_of(std::size_t n) const {
    using std::abs;
    Real size = 0;
    for (const ForceSeries<Real>& force : series_.forces)
      size = std::max<Real>({size, abs(force.normal[n]), abs(force.tangential[n])});
    return size;
  }

  void finish(const Real& ratio) {
    for (const HeldPoint<Real>& point : points_)
      series_.held[point.interface()] = point.point().place_from_middle();
    if (ratio < 1) {
      known_.rescale_by(ratio);
      series_.length *= ratio;
      for (BodySeries<Real>& body : series_.bodies)
        for (Polynomial<Real>* part : {&body.x, &body.y, &body.angle, &body.cosine, &body.sine})
          rescale(*part, ratio);
      for (ForceSeries<Real>& force : series_.forces)
        for (Polynomial<Real>* part : {&force.normal, &force.tangential, &force.moment})
          rescale(*part, ratio);
      for (FaceSeries<Real>& point : series_.held)
        for (Polynomial<Real>* part : {&point.along, &point.above}) rescale(*part, ratio);
    }
  }

 private:
  void begin(BodySeries<Real>& body, const Pose<Real>& at, const Pose<Real>& rate) const {
    using std::cos;
    using std::sin;
    const Real length = series_.length;
    body.x = {at.x, rate.x * length};
    body.y = {at.y, rate.y * length};
    body.angle = {at.angle};
    body.turning = {Real(0)};
    body.cosine = {cos(at.angle)};
    body.sine = {sin(at.angle)};
    begin_direction(body, 1);
    turn<Real>(body, 1, rate.angle * length);
  }

  const BodySeries<Real>* body_of(int body) const { return body < 0 ? &ground_ : &series_.bodies[body]; }

  void hold() {
    std::size_t point = 0;
    for (std::size_t k = 0; k < joints_.size(); ++k)
      if (joints_[k].touches())
        held_.add(joints_[k], point++, kinematics_of(stack_, start_, k, joints_[k]), k);
    held_.prepare();
  }

  void begin_points() {
    points_.clear();
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const Joint<Real>& joint = joints_[k];
      if (!joint.touches()) continue;
      const CornerOnFace<Real> corner = stack_.held_point(k, joint);
      points_.emplace_back(stack_, corner, body_of(corner.face), body_of(corner.body), joint.slip == 0);
    }
  }

  /// Coefficient n of all forces and moments, of those contact forces that are known.
  FreeVector<Real> forces(std::size_t n, const ScaledBodyForce<Real>& body_force) const {
    FreeVector<Real> result = FreeVector<Real>::Zero(Eigen::Index{3} * stack_.size());
    for (int k = 0; k < stack_.size(); ++k) {
      const Real mass = stack_.blocks[k].mass;
      result[Eigen::Index{3} * k] = mass * coefficient(body_force.x, n);
      result[Eigen::Index{3} * k + 1] = mass * coefficient(body_force.y, n);
    }
    for (const HeldPoint<Real>& point : points_)
      point.point().add_force(series_.forces[point.interface()], n, result);
    known_.add_forces(n, result);
    return result;
  }

  const ContactModel<Real>& stack_;
  const Joints<Real>& joints_;
  const Bodies<Real>& start_;
  Known& known_;
  BodySeries<Real> ground_;
  ModeSeries<Real>& series_;
  std::vector<HeldPoint<Real>> points_;
  HeldRows<Real> held_;
};

/// A step's series, of the length that was planned or of less. `lengthens` tells whether they reached that
/// early.
template <class Real>
struct ModeStep {
  Real planned = 0;  ///< s
  ModeSeries<Real> series = {};
  bool lengthens = false;
};

/// What the last two coefficients of a series leave out, in shares of what is negligible.
template <class Real>
class LeftOut {
 public:
  explicit LeftOut(const Real& negligible) : negligible_(negligible) {}

  void note(const Real& coefficient) { before_ = std::exchange(last_, coefficient); }
  Real share() const { return std::max(last_, before_) / negligible_; }

 private:
  Real negligible_;
  Real last_ = 0, before_ = 0;
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
  const std::size_t body_force_terms = std::max(body_force.x.terms, body_force.y.terms);
  constexpr std::size_t most = max_orders<Real>;
  std::size_t orders = 0;
  LeftOut<Real> positions(std::numeric_limits<Real>::epsilon() / 16);
  LeftOut<Real> forces(tolerance<Real>(1e-8));
  Real force = std::numeric_limits<Real>::min();
  Real left = 0;
  bool reached = false;
  while (orders < most && !(reached && orders >= body_force_terms)) {
    if (orders > 0) maker.extend(orders, body_force);
    positions.note(maker.size_of(orders + 2, unit));
    const Real own = maker.force_of(orders);
    force = std::max(force, own);
    forces.note(own / force);
    ++orders;
    left = std::max(positions.share(), forces.share());
    reached = orders > 2 + known.silent_orders() && left <= 1;
  }
  using std::pow;
  const Real ratio = reached ? Real(1) : Real(0.9) * pow(1 / left, 1 / Real(most));
  maker.finish(std::min(ratio, Real(1)));
  step.lengthens = orders + 2 < most;
  return step;
}

}  // namespace rockstack
