#include "analytic/unilateral/mode_series.hpp"

#include <Eigen/LU>
#include <utility>

namespace rockstack {
namespace {

/// Coefficient n of a product, of coefficients that exist.
double convolution(const Series& first, const Series& second, std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    if (i < first.terms && n - i < second.terms) sum += first[i] * second[n - i];
  }
  return sum;
}

void put(Series& series, std::size_t n, double value) {
  while (series.terms <= n) series[series.terms++] = 0;
  series[n] = value;
}

/// Coefficient m of cosine and sine from those of the angle: c' = −s θ', s' = c θ'.
void extend_direction(BodySeries& body, std::size_t m) {
  double cosine = 0;
  double sine = 0;
  for (std::size_t j = 1; j <= m; ++j) {
    cosine -= double(j) * body.angle[j] * body.sine[m - j];
    sine += double(j) * body.angle[j] * body.cosine[m - j];
  }
  put(body.cosine, m, cosine / double(m));
  put(body.sine, m, sine / double(m));
}

BodySeries ground_series() {
  BodySeries ground;
  ground.x = ground.y = ground.angle = ground.sine = {0.0};
  ground.cosine = {1.0};
  return ground;
}

double coefficient(const Series& series, std::size_t n) {
  return n < series.terms ? series[n] : 0.0;
}

struct PlaneCoefficient {
  double x, y;
};

/// Coefficient n of a body vector in the frame of the ground.
PlaneCoefficient turned(const BodySeries& body, const Eigen::Vector2d& vector, std::size_t n) {
  const double cosine = coefficient(body.cosine, n);
  const double sine = coefficient(body.sine, n);
  return {vector.x() * cosine + vector.y() * sine, vector.y() * cosine - vector.x() * sine};
}

/// A point against a face while its series grow.
struct GrowingPoint {
  CornerOnFace corner;
  Eigen::Vector2d body_arm;     ///< from the centre of mass of the point's body, in its frame, m
  Eigen::Vector2d face_centre;  ///< of mass of the face's body, from its middle, m
  const BodySeries* face;
  const BodySeries* body;
  Series apart_x, apart_y;  ///< from the centre of mass of the face's body
  Series arm_x, arm_y;
  FaceSeries place;         ///< from there too
  Series force_x, force_y;  ///< on the point's body

  GrowingPoint(const std::vector<Block>& blocks, const CornerOnFace& point, const BodySeries* face_body,
               const BodySeries* point_body)
      : corner(point),
        body_arm(Eigen::Vector2d(point.x, point.y) - centre_of(blocks, point.body)),
        face_centre(centre_of(blocks, point.face)),
        face(face_body),
        body(point_body) {}

  void extend(std::size_t n) {
    const PlaneCoefficient arm = turned(*body, body_arm, n);
    put(arm_x, n, arm.x);
    put(arm_y, n, arm.y);
    put(apart_x, n, coefficient(body->x, n) - coefficient(face->x, n) + arm.x);
    put(apart_y, n, coefficient(body->y, n) - coefficient(face->y, n) + arm.y);
    put(place.along, n, convolution(apart_x, face->cosine, n) - convolution(apart_y, face->sine, n));
    put(place.above, n, convolution(apart_x, face->sine, n) + convolution(apart_y, face->cosine, n));
  }

  FaceSeries place_from_middle() const {
    FaceSeries result = place;
    result.along[0] += face_centre.x();
    result.above[0] += face_centre.y();
    return result;
  }

  void extend_force(const ForceSeries& force, std::size_t n) {
    const double sign = corner.upward;
    put(force_x, n,
        sign * (convolution(force.normal, face->sine, n) + convolution(force.tangential, face->cosine, n)));
    put(force_y, n,
        sign * (convolution(force.normal, face->cosine, n) - convolution(force.tangential, face->sine, n)));
  }
};

class SeriesMaker {
 public:
  SeriesMaker(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& start,
              const ScaledBodyForce<double>& body_force, double length)
      : stack_(stack), joints_(joints), body_force_(body_force), ground_(ground_series()) {
    series_.length = length;
    series_.force_unit = 1 / (length * length);
    series_.bodies.resize(joints.size());
    series_.forces.resize(joints.size());
    series_.held.resize(joints.size());
    for (std::size_t k = 0; k < joints.size(); ++k) begin(series_.bodies[k], start.at[k], start.rate[k]);
    prepare_constraints(start);
  }

  void extend(std::size_t n) {
    const std::size_t m = n + 2;
    const double factor = double(m) * double(m - 1);
    for (BodySeries& body : series_.bodies) {
      for (Series* part : {&body.x, &body.y, &body.angle}) put(*part, m, 0);
      extend_direction(body, m);
    }
    for (ForceSeries& force : series_.forces)
      for (Series* part : {&force.normal, &force.tangential, &force.moment}) put(*part, n, 0);
    for (GrowingPoint& point : points_) {
      point.extend(m);
      point.extend_force(series_.forces[interface_of(point)], n);
    }
    FreeVector motion = stack_.inverse_mass.cwiseProduct(forces(n));
    if (!gradients_.empty()) {
      const auto size = static_cast<Eigen::Index>(gradients_.size());
      Eigen::VectorXd violation(size);
      for (Eigen::Index i = 0; i < size; ++i)
        violation[i] = gradients_[static_cast<std::size_t>(i)].dot(motion) +
                       factor * known(static_cast<std::size_t>(i), m);
      const Eigen::VectorXd unknowns = lu_.solve(-violation);
      for (Eigen::Index i = 0; i < size; ++i) motion += unknowns[i] * effects_[static_cast<std::size_t>(i)];
      note_forces(unknowns, n);
    }
    for (std::size_t k = 0; k < series_.bodies.size(); ++k) {
      BodySeries& body = series_.bodies[k];
      const auto first = 3 * static_cast<Eigen::Index>(k);
      body.x[m] = motion[first] / factor;
      body.y[m] = motion[first + 1] / factor;
      body.angle[m] = motion[first + 2] / factor;
      extend_direction(body, m);
    }
    for (GrowingPoint& point : points_) {
      point.extend(m);
      point.extend_force(series_.forces[interface_of(point)], n);
    }
  }

  /// The largest coefficient of order m, positions over a length, angles and directions as they are.
  double size_of(std::size_t m, double unit) const {
    double size = 0;
    for (const BodySeries& body : series_.bodies) {
      size = std::max({size, std::abs(body.x[m]) / unit, std::abs(body.y[m]) / unit, std::abs(body.angle[m]),
                       std::abs(body.cosine[m]), std::abs(body.sine[m])});
    }
    return size * double(m);
  }

  ModeSeries finish(double ratio) && {
    for (const GrowingPoint& point : points_) series_.held[interface_of(point)] = point.place_from_middle();
    if (ratio < 1) {
      series_.length *= ratio;
      for (BodySeries& body : series_.bodies)
        for (Series* part : {&body.x, &body.y, &body.angle, &body.cosine, &body.sine}) rescale(*part, ratio);
      for (ForceSeries& force : series_.forces)
        for (Series* part : {&force.normal, &force.tangential, &force.moment}) rescale(*part, ratio);
      for (FaceSeries& point : series_.held)
        for (Series* part : {&point.along, &point.above}) rescale(*part, ratio);
    }
    return std::move(series_);
  }

 private:
  enum class Row { turn, gap, slip };
  struct Held {
    Row kind;
    std::size_t interface;
    std::size_t point;
  };

  void begin(BodySeries& body, const BodyPlacement& at, const BodyPlacement& rate) const {
    const double length = series_.length;
    body.x = {at.x, rate.x * length};
    body.y = {at.y, rate.y * length};
    body.angle = {at.angle, rate.angle * length};
    body.cosine = {std::cos(at.angle)};
    body.sine = {std::sin(at.angle)};
    extend_direction(body, 1);
  }

  const BodySeries* body_of(int body) const {
    return body < 0 ? &ground_ : &series_.bodies[static_cast<std::size_t>(body)];
  }
  static std::size_t interface_of(const GrowingPoint& point) {
    return static_cast<std::size_t>(std::max(point.corner.body, point.corner.face));
  }

  void hold(Row kind, std::size_t interface, const Eigen::RowVectorXd& gradient,
            const Eigen::RowVectorXd& action) {
    held_.push_back({kind, interface, points_.size() - 1});
    gradients_.push_back(gradient);
    effects_.emplace_back(stack_.inverse_mass.cwiseProduct(action.transpose()));
  }

  void prepare_constraints(const Bodies& start) {
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const Joint& joint = joints_[k];
      if (!joint.touches()) continue;
      const auto interface = static_cast<int>(k);
      const CornerOnFace corner = held_point(stack_.blocks, interface, joint);
      points_.emplace_back(stack_.blocks, corner, body_of(corner.face), body_of(corner.body));
      points_.back().extend(0);
      points_.back().extend(1);
      const PointRows rows = rows_of(stack_.blocks, start, corner);
      if (joint.touch == Touch::flat) {
        Eigen::RowVectorXd turn = Eigen::RowVectorXd::Zero(Eigen::Index{3} * stack_.size());
        // Turned by its half-width, all rows are of one unit.
        turn[Eigen::Index{3} * interface + 2] = half_width_of(stack_.blocks, interface);
        if (interface > 0) turn[Eigen::Index{3} * interface - 1] = -turn[Eigen::Index{3} * interface + 2];
        hold(Row::turn, k, turn, turn);
      }
      hold(Row::gap, k, rows.gap_row, rows.gap_row - joint.slip * stack_.friction[k] * rows.slip_row);
      if (joint.slip == 0) hold(Row::slip, k, rows.slip_row, rows.slip_row);
    }
    const auto size = static_cast<Eigen::Index>(gradients_.size());
    if (size == 0) return;
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j < size; ++j)
        matrix(i, j) = gradients_[static_cast<std::size_t>(i)].dot(effects_[static_cast<std::size_t>(j)]);
    lu_.compute(matrix);
  }

  /// What is known of coefficient m of what a constraint holds.
  double known(std::size_t constraint, std::size_t m) const {
    const Held& held = held_[constraint];
    const GrowingPoint& point = points_[held.point];
    if (held.kind == Row::turn) return 0;
    return point.corner.upward * (held.kind == Row::gap ? point.place.above[m] : point.place.along[m]);
  }

  void note_forces(const Eigen::VectorXd& unknowns, std::size_t n) {
    for (std::size_t i = 0; i < held_.size(); ++i) {
      ForceSeries& force = series_.forces[held_[i].interface];
      const double value = unknowns[static_cast<Eigen::Index>(i)];
      switch (held_[i].kind) {
        case Row::turn:
          force.moment[n] = value * stack_.blocks[held_[i].interface].half_width;
          break;
        case Row::gap: {
          const std::size_t k = held_[i].interface;
          force.normal[n] = value;
          if (joints_[k].slip != 0) force.tangential[n] = -joints_[k].slip * stack_.friction[k] * value;
          break;
        }
        case Row::slip:
          force.tangential[n] = value;
          break;
      }
    }
  }

  /// Coefficient n of all forces and moments, of those contact forces that are known.
  FreeVector forces(std::size_t n) const {
    FreeVector result = FreeVector::Zero(Eigen::Index{3} * stack_.size());
    for (int k = 0; k < stack_.size(); ++k) {
      const double mass = stack_.blocks[static_cast<std::size_t>(k)].mass;
      result[Eigen::Index{3} * k] = mass * coefficient(body_force_.x, n);
      result[Eigen::Index{3} * k + 1] = mass * coefficient(body_force_.y, n);
    }
    for (const GrowingPoint& point : points_) {
      const ForceSeries& force = series_.forces[interface_of(point)];
      if (point.corner.body >= 0) {
        result[Eigen::Index{3} * point.corner.body] += point.force_x[n];
        result[Eigen::Index{3} * point.corner.body + 1] += point.force_y[n];
        result[Eigen::Index{3} * point.corner.body + 2] +=
            convolution(point.force_x, point.arm_y, n) - convolution(point.force_y, point.arm_x, n);
      }
      if (point.corner.face >= 0) {
        result[Eigen::Index{3} * point.corner.face] -= point.force_x[n];
        result[Eigen::Index{3} * point.corner.face + 1] -= point.force_y[n];
        result[Eigen::Index{3} * point.corner.face + 2] +=
            point.corner.upward * (convolution(force.normal, point.place.along, n) -
                                   convolution(force.tangential, point.place.above, n));
      }
    }
    return result;
  }

  const FrictionStack& stack_;
  const std::vector<Joint>& joints_;
  const ScaledBodyForce<double>& body_force_;
  BodySeries ground_;
  ModeSeries series_;
  std::vector<GrowingPoint> points_;
  std::vector<Held> held_;
  std::vector<Eigen::RowVectorXd> gradients_;
  std::vector<Eigen::VectorXd> effects_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace

Bodies ModeSeries::at(double s) const {
  Bodies result;
  for (const BodySeries& body : bodies) {
    const auto x = tangent(body.x, s);
    const auto y = tangent(body.y, s);
    const auto angle = tangent(body.angle, s);
    result.at.push_back({x.height, y.height, angle.height});
    result.rate.push_back({x.slope / length, y.slope / length, angle.slope / length});
  }
  return result;
}

ModeStep mode_step(const FrictionStack& stack, const std::vector<Joint>& joints, const Bodies& bodies,
                   const ScaledBodyForce<double>& body_force, double length) {
  constexpr double tolerance = std::numeric_limits<double>::epsilon() / 16;
  double unit = 0;
  for (const Block& block : stack.blocks) unit += 2 * block.half_height;
  SeriesMaker maker(stack, joints, bodies, body_force, length);
  const std::size_t body_force_terms = std::max(body_force.x.terms, body_force.y.terms);
  constexpr std::size_t most = max_orders<double>;
  std::size_t orders = 0;
  double last = 0;
  double before = 0;
  bool reached = false;
  while (orders < most && !(reached && orders >= body_force_terms)) {
    maker.extend(orders++);
    before = std::exchange(last, maker.size_of(orders + 1, unit));
    reached = orders > 2 && std::max(last, before) <= tolerance;
  }
  const double left = std::max(last, before);
  const double ratio = reached ? 1 : 0.9 * std::pow(tolerance / left, 1 / double(most));
  return {std::move(maker).finish(std::min(ratio, 1.0)), orders + 2 < most};
}

FaceSeries corner_series(const std::vector<Block>& blocks, const ModeSeries& series,
                         const CornerOnFace& corner) {
  const BodySeries ground = ground_series();
  const auto of = [&](int body) {
    return body < 0 ? &ground : &series.bodies[static_cast<std::size_t>(body)];
  };
  GrowingPoint point(blocks, corner, of(corner.face), of(corner.body));
  for (std::size_t n = 0; n < series.bodies.front().x.terms; ++n) point.extend(n);
  return point.place_from_middle();
}

Series product(const Series& first, const Series& second) {
  Series result;
  const std::size_t terms =
      first.terms == 0 || second.terms == 0 ? 0 : std::min(first.terms + second.terms - 1, max_terms<double>);
  for (std::size_t n = 0; n < terms; ++n) result[result.terms++] = convolution(first, second, n);
  return result;
}

}  // namespace rockstack
