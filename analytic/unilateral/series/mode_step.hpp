#pragma once

#include "analytic/steps/body_force.hpp"
#include "analytic/unilateral/contact/contact_model.hpp"
#include "analytic/unilateral/contact/contact_problem.hpp"
#include "analytic/unilateral/series/mode_series.hpp"

namespace rockstack {

/// What the joints of a mode hold: the equations of respond(), which each order of a step's series solves.
template <class Real>
class HeldRows {
 public:
  explicit HeldRows(const ContactModel<Real>& stack) : stack_(stack) {}

  /// The joint of an interface, whose held point is `point` of the series and has these rows at the start.
  void add(const Joint<Real>& joint, std::size_t point, const ContactKinematics<Real>& rows,
           std::size_t interface) {
    const Row row{Kind::gap, joint.slip, interface, point};
    const auto k = static_cast<int>(interface);
    if (joint.touch == Touch::flat) {
      // Turned by its half-width, all rows are of one unit.
      const FreeRow<Real> turn = angle_row(stack_, k, stack_.half_width(k));
      push({Kind::turn, row.sliding, interface, point}, turn, turn);
    }
    push(row, rows.gap_row, rows.gap_row - joint.slip * stack_.friction[interface] * rows.slip_row);
    if (joint.slip == 0) push({Kind::slip, 0, interface, point}, rows.slip_row, rows.slip_row);
  }

  void prepare() {
    const auto size = static_cast<Eigen::Index>(rows_.size());
    if (size == 0) return;
    SquareMatrix<Real> matrix(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j) matrix(i, j) = jacobian_[i].dot(effects_[j]);
    lu_.compute(matrix);
  }

  /// Changes coefficient n of accelerations so that what is held stays zero at order n + 2, and notes the
  /// forces that do it.
  void constrain(const std::vector<GrowingPoint<Real>>& points, std::size_t n, FreeVector<Real>& motion,
                 std::vector<ForceSeries<Real>>& forces) const {
    if (rows_.empty()) return;
    const Real factor = Real(n + 2) * Real(n + 1);
    const auto size = static_cast<Eigen::Index>(rows_.size());
    FreeVector<Real> violation(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      violation[i] = jacobian_[i].dot(motion) + factor * known(rows_[i], points, n + 2);
    }
    const FreeVector<Real> unknowns = lu_.solve(-violation);
    for (Eigen::Index i = 0; i < size; ++i) motion += unknowns[i] * effects_[i];
    for (std::size_t i = 0; i < rows_.size(); ++i)
      note_force(rows_[i], unknowns[static_cast<Eigen::Index>(i)], n, forces);
  }

 private:
  enum class Kind { turn, gap, slip };
  struct Row {
    Kind kind;
    int sliding;
    std::size_t interface;
    std::size_t point;
  };

  void push(const Row& row, const FreeRow<Real>& gradient, const FreeRow<Real>& action) {
    rows_.push_back(row);
    jacobian_.push_back(gradient);
    effects_.emplace_back(stack_.inverse_mass.cwiseProduct(action.transpose()));
  }

  /// What is known of coefficient m of what a row holds.
  static Real known(const Row& row, const std::vector<GrowingPoint<Real>>& points, std::size_t m) {
    const GrowingPoint<Real>& point = points[row.point];
    if (row.kind == Kind::turn) return 0;
    return point.corner.upward * (row.kind == Kind::gap ? point.place.above[m] : point.place.along[m]);
  }

  void note_force(const Row& row, const Real& value, std::size_t n,
                  std::vector<ForceSeries<Real>>& forces) const {
    const std::size_t k = row.interface;
    ForceSeries<Real>& force = forces[k];
    switch (row.kind) {
      case Kind::turn:
        force.moment[n] = value * Real(stack_.blocks[k].half_width);
        break;
      case Kind::gap:
        force.normal[n] = value;
        if (row.sliding != 0) force.tangential[n] = -row.sliding * stack_.friction[k] * value;
        break;
      case Kind::slip:
        force.tangential[n] = value;
        break;
    }
  }

  const ContactModel<Real>& stack_;
  std::vector<Row> rows_;
  std::vector<FreeRow<Real>> jacobian_;
  std::vector<FreeVector<Real>> effects_;
  Eigen::PartialPivLU<SquareMatrix<Real>> lu_;
};

/// Lets the series of a step grow, order by order. `known` are the forces of springs: each order of
/// theirs follows from the same order of places and velocities.
template <class Real, class Known>
class SeriesMaker {
 public:
  SeriesMaker(const ContactModel<Real>& stack, const Joints<Real>& joints, const Bodies<Real>& start,
              const ScaledBodyForce<Real>& body_force, const Real& length, Known& known)
      : stack_(stack),
        joints_(joints),
        body_force_(body_force),
        known_(known),
        ground_(ground_series<Real>()),
        held_(stack) {
    series_.length = length;
    series_.force_unit = 1 / (length * length);
    series_.bodies.resize(joints.size());
    series_.forces.resize(joints.size());
    series_.held.resize(joints.size());
    for (std::size_t k = 0; k < joints.size(); ++k) begin(series_.bodies[k], start.at[k], start.rate[k]);
    start_points(start);
    known_.begin([this](int body) { return body_of(body); }, length);
  }

  void extend(std::size_t n) {
    const std::size_t m = n + 2;
    const Real factor = Real(m) * Real(m - 1);
    for (BodySeries<Real>& body : series_.bodies) {
      for (Polynomial<Real>* part : {&body.x, &body.y, &body.angle}) put(*part, m, 0);
      extend_direction(body, m);
    }
    for (ForceSeries<Real>& force : series_.forces)
      for (Polynomial<Real>* part : {&force.normal, &force.tangential, &force.moment}) put(*part, n, 0);
    extend_points(n);
    known_.extend_forces(n, series_.forces);
    FreeVector<Real> motion = stack_.inverse_mass.cwiseProduct(forces(n));
    held_.constrain(points_, n, motion, series_.forces);
    for (std::size_t k = 0; k < series_.bodies.size(); ++k) {
      BodySeries<Real>& body = series_.bodies[k];
      const auto first = 3 * static_cast<Eigen::Index>(k);
      body.x[m] = motion[first] / factor;
      body.y[m] = motion[first + 1] / factor;
      body.angle[m] = motion[first + 2] / factor;
      extend_direction(body, m);
    }
    extend_points(n);
  }

  /// The largest coefficient of order m, positions over a length, angles and directions as they are.
  Real size_of(std::size_t m, const Real& unit) const {
    using std::abs;
    Real size = 0;
    for (const BodySeries<Real>& body : series_.bodies) {
      size = std::max<Real>({size, abs(body.x[m]) / unit, abs(body.y[m]) / unit, abs(body.angle[m]),
                             abs(body.cosine[m]), abs(body.sine[m])});
    }
    return std::max<Real>(size, Real(known_.size_of(m)) / unit) * Real(m);
  }

  /// The largest coefficient of order n of forces.
  Real force_of(std::size_t n) const {
    using std::abs;
    Real size = 0;
    for (const ForceSeries<Real>& force : series_.forces)
      size = std::max<Real>({size, abs(force.normal[n]), abs(force.tangential[n])});
    return size;
  }

  ModeSeries<Real> finish(const Real& ratio) && {
    for (const GrowingPoint<Real>& point : points_)
      series_.held[point.interface()] = point.place_from_middle();
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
    return std::move(series_);
  }

 private:
  void begin(BodySeries<Real>& body, const Pose<Real>& at, const Pose<Real>& rate) const {
    using std::cos;
    using std::sin;
    const Real length = series_.length;
    body.x = {at.x, rate.x * length};
    body.y = {at.y, rate.y * length};
    body.angle = {at.angle, rate.angle * length};
    body.cosine = {cos(at.angle)};
    body.sine = {sin(at.angle)};
    extend_direction(body, 1);
  }

  /// Contacts and springs to order n of forces.
  void extend_points(std::size_t n) {
    for (GrowingPoint<Real>& point : points_) {
      point.extend(n + 2);
      point.extend_force(series_.forces[point.interface()], n);
    }
    known_.extend_places(n + 2);
  }

  const BodySeries<Real>* body_of(int body) const { return body < 0 ? &ground_ : &series_.bodies[body]; }

  void start_points(const Bodies<Real>& start) {
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const Joint<Real>& joint = joints_[k];
      if (!joint.touches()) continue;
      const CornerOnFace<Real> corner = stack_.held_point(k, joint);
      points_.emplace_back(stack_, corner, body_of(corner.face), body_of(corner.body));
      points_.back().extend(0);
      points_.back().extend(1);
      held_.add(joint, points_.size() - 1, kinematics_of(stack_, start, corner), k);
    }
    held_.prepare();
  }

  /// Coefficient n of all forces and moments, of those contact forces that are known.
  FreeVector<Real> forces(std::size_t n) const {
    FreeVector<Real> result = FreeVector<Real>::Zero(Eigen::Index{3} * stack_.size());
    for (int k = 0; k < stack_.size(); ++k) {
      const Real mass = stack_.blocks[k].mass;
      result[Eigen::Index{3} * k] = mass * coefficient(body_force_.x, n);
      result[Eigen::Index{3} * k + 1] = mass * coefficient(body_force_.y, n);
    }
    for (const GrowingPoint<Real>& point : points_)
      point.add_force(series_.forces[point.interface()], n, result);
    known_.add_forces(n, result);
    return result;
  }

  const ContactModel<Real>& stack_;
  const Joints<Real>& joints_;
  const ScaledBodyForce<Real>& body_force_;
  Known& known_;
  BodySeries<Real> ground_;
  ModeSeries<Real> series_;
  std::vector<GrowingPoint<Real>> points_;
  HeldRows<Real> held_;
};

/// A step's series. `lengthens` tells whether they reached a length early.
template <class Real>
struct ModeStep {
  ModeSeries<Real> series;
  bool lengthens;
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

/// The series over `length`, or less of it where they would leave out more than rounding of positions, or of
/// forces, their second derivatives, more than what events need.
template <class Real, class Known>
ModeStep<Real> mode_step(const ContactModel<Real>& stack, const Joints<Real>& joints,
                         const Bodies<Real>& bodies, const ScaledBodyForce<Real>& body_force,
                         const Real& length, Known& known) {
  const Real unit = stack.height();
  SeriesMaker<Real, Known> maker(stack, joints, bodies, body_force, length, known);
  const std::size_t body_force_terms = std::max(body_force.x.terms, body_force.y.terms);
  constexpr std::size_t most = max_orders<Real>;
  std::size_t orders = 0;
  LeftOut<Real> positions(std::numeric_limits<Real>::epsilon() / 16);
  LeftOut<Real> forces(tolerance<Real>(1e-8));
  Real force = std::numeric_limits<Real>::min();
  Real left = 0;
  bool reached = false;
  while (orders < most && !(reached && orders >= body_force_terms)) {
    maker.extend(orders);
    positions.note(maker.size_of(orders + 2, unit));
    force = std::max(force, maker.force_of(orders));
    forces.note(maker.force_of(orders) / force);
    ++orders;
    left = std::max(positions.share(), forces.share());
    reached = orders > 2 + known.silent_orders() && left <= 1;
  }
  using std::pow;
  const Real ratio = reached ? Real(1) : Real(0.9) * pow(1 / left, 1 / Real(most));
  return {std::move(maker).finish(std::min(ratio, Real(1))), orders + 2 < most};
}

}  // namespace rockstack
