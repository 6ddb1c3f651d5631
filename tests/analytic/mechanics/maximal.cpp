#include "tests/analytic/mechanics/maximal.hpp"

namespace rockstack::testing {
namespace {

Point<Number> rotated(Number across, Number up, Number angle) {
  const Number c = std::cos(angle);
  const Number s = std::sin(angle);
  return {c * across + s * up, c * up - s * across};
}

Point<Number> swept(const Point<Number>& arm) {
  return {arm.y(), -arm.x()};
}

/// Rows of the constraints at one interface: two for the pivot, a third where it is closed.
struct Constraints {
  Dense jacobian;
  Column centripetal;
};

Constraints constrain(const Placement& placement, const Pattern& pattern, const Column& motion) {
  const int size = pattern.size;
  Constraints result{Dense::Zero(row(size), row(size)), Column::Zero(row(size))};
  for (int k = 0; k < size; ++k) {
    const auto index = static_cast<std::size_t>(k);
    const auto add = [&](int block, Number side, const Point<Number>& arm) {
      result.jacobian.block<2, 2>(row(k), row(block)) = side * Eigen::Matrix<Number, 2, 2>::Identity();
      result.jacobian.block<2, 1>(row(k), row(block) + 2) = side * swept(arm);
      const Number rate = motion[row(block) + 2];
      result.centripetal.segment<2>(row(k)) += side * rate * rate * arm;
    };
    add(k, 1, placement.above[index]);
    if (k > 0) add(k - 1, -1, placement.below[index]);
    if (pattern[k] != Contact::closed) continue;
    result.jacobian(row(k) + 2, row(k) + 2) = 1;
    if (k > 0) result.jacobian(row(k) + 2, row(k) - 1) = -1;
  }
  return result;
}

Column masses(const Model<Number>& model) {
  Column result(3 * model.stack.size());
  for (int k = 0; k < model.stack.size(); ++k) {
    result.segment<3>(row(k)) << model.stack.mass[k], model.stack.mass[k], model.stack.inertia[k];
  }
  return result;
}

Solution solve(const Model<Number>& model, const Pattern& pattern, const Constraints& constraints,
               const Column& free, const Column& target) {
  const int size = pattern.size;
  const Column mass = masses(model);
  Dense matrix = Dense::Zero(2 * row(size), 2 * row(size));
  matrix.topLeftCorner(row(size), row(size)) = mass.asDiagonal();
  matrix.topRightCorner(row(size), row(size)) = -constraints.jacobian.transpose();
  matrix.bottomLeftCorner(row(size), row(size)) = constraints.jacobian;
  for (int k = 0; k < size; ++k) {
    if (pattern[k] != Contact::closed) matrix(row(size) + row(k) + 2, row(size) + row(k) + 2) = 1;
  }
  Column right(2 * row(size));
  right << mass.cwiseProduct(free), target;
  const Column answer = matrix.fullPivLu().solve(right);
  Solution solution{answer.head(row(size)), Vector<Number>(size), Points<Number>(2, size),
                    Vector<Number>(size)};
  for (int k = 0; k < size; ++k) {
    solution.relative[k] = answer[row(k) + 2] - (k > 0 ? answer[row(k) - 1] : 0);
    solution.force.col(k) = answer.segment<2>(row(size) + row(k));
    solution.moment[k] = answer[row(size) + row(k) + 2];
  }
  return solution;
}

}  // namespace

Placement place(const Model<Number>& model, const Pattern& pattern, const Vector<Number>& relative_angles) {
  const Stack<Number>& stack = model.stack;
  Placement result;
  Point<Number> below_centre{0, 0};
  Number angle = 0;
  for (int k = 0; k < stack.size(); ++k) {
    const Number across = sign(pattern[k]) * stack.half_width[k];
    const Point<Number> below =
        k > 0 ? rotated(across, stack.half_height[k - 1], angle) : Point<Number>(across, 0);
    angle += relative_angles[k];
    const Point<Number> above = rotated(across, -stack.half_height[k], angle);
    below_centre += below - above;
    result.centres.push_back(below_centre);
    result.below.push_back(below);
    result.above.push_back(above);
    result.angles.push_back(angle);
  }
  return result;
}

Column velocities(const Placement& placement, const Vector<Number>& relative_velocities) {
  Column result(3 * relative_velocities.size());
  Point<Number> centre{0, 0};
  Number rate = 0;
  for (Eigen::Index k = 0; k < relative_velocities.size(); ++k) {
    const auto index = static_cast<std::size_t>(k);
    if (k > 0) centre += rate * swept(placement.below[index]);
    rate += relative_velocities[k];
    centre -= rate * swept(placement.above[index]);
    result.segment<3>(row(k)) << centre.x(), centre.y(), rate;
  }
  return result;
}

Solution accelerate(const Model<Number>& model, const State<Number>& state, const Point<Number>& ground,
                    const Column& pushed) {
  const bool linear = model.equations == Equations::linear;
  const Vector<Number> still = Vector<Number>::Zero(state.angles.size());
  const Placement placement = place(model, state.pattern, linear ? still : state.angles);
  const Column motion = velocities(placement, linear ? still : state.velocities);
  const Constraints constraints = constrain(placement, state.pattern, motion);
  Column free = Column::Zero(motion.size());
  for (int k = 0; k < model.stack.size(); ++k) {
    free.segment<2>(row(k)) << -ground.x(), -model.gravity - ground.y();
  }
  if (pushed.size() > 0) free += pushed;
  return solve(model, state.pattern, constraints, free, constraints.centripetal);
}

Solution strike(const Model<Number>& model, const State<Number>& before, const Pattern& pattern,
                const Column& pushed) {
  Column free = velocities(place(model, before.pattern, before.angles), before.velocities);
  if (pushed.size() > 0) free += pushed;
  const Constraints constraints = constrain(place(model, pattern, before.angles), pattern, free);
  return solve(model, pattern, constraints, free, Column::Zero(free.size()));
}

Number angular_momentum(const Model<Number>& model, const Placement& placement, const Column& motion,
                        int interface) {
  const auto first = static_cast<std::size_t>(interface);
  const Point<Number> pivot = placement.centres[first] + placement.above[first];
  Number sum = 0;
  for (int k = interface; k < model.stack.size(); ++k) {
    const Point<Number> arm = placement.centres[static_cast<std::size_t>(k)] - pivot;
    sum += model.stack.inertia[k] * motion[row(k) + 2];
    sum += model.stack.mass[k] * (arm.y() * motion[row(k)] - arm.x() * motion[row(k) + 1]);
  }
  return sum;
}

Number kinetic_energy(const Model<Number>& model, const Column& motion) {
  return motion.dot(masses(model).cwiseProduct(motion)) / 2;
}

}  // namespace rockstack::testing
