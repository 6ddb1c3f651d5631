#include "analytic/unilateral/contact_course.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack {
namespace {

Series times(double factor, Series series) {
  for (double& coefficient : series) coefficient *= factor;
  return series;
}

/// constant + factor · series.
Series line(double constant, double factor, const Series& series) {
  Series result = times(factor, series);
  if (result.terms == 0) return {constant};
  result[0] += constant;
  return result;
}

Series sum(Series first, const Series& second) {
  add(second, 1.0, first);
  return first;
}

class Collector {
 public:
  Collector(const FrictionStack& stack, const std::vector<Joint>& joints, const ModeSeries& series)
      : stack_(stack), joints_(joints), series_(series) {
    for (std::size_t k = 0; k < joints.size(); ++k)
      inertia_ +=
          2 * stack.blocks[k].mass * (std::abs(series.bodies[k].x[2]) + std::abs(series.bodies[k].y[2]));
  }

  void add_interface(int k) {
    const Joint& joint = joints_[static_cast<std::size_t>(k)];
    if (joint.touch == Touch::flat) {
      add_pressure(k);
    } else if (joint.pivots()) {
      push_force(force(k).normal, 1, k);
      push(times(joint.side(), relative_angle(k)), Change::closing, k);
    } else {
      add_landings(k);
    }
    if (!joint.touches()) return;
    if (joint.slip == 0) {
      const double friction = stack_.friction[static_cast<std::size_t>(k)];
      const Series limit = times(friction, force(k).normal);
      push_force(sum(limit, times(-1, force(k).tangential)), 1 + friction, k);
      push_force(sum(limit, force(k).tangential), 1 + friction, k);
    } else {
      push(times(joint.slip, derivative(slip(k))), Change::halt, k);
      if (k > 0) joint.pivots() ? add_pivot_ends(k) : add_flat_ends(k);
    }
  }

  void add_toppling(int k, double angle) {
    const Series& lean = series_.bodies[static_cast<std::size_t>(k)].angle;
    push(line(angle, -1, lean), Change::topple, k);
    push(line(angle, 1, lean), Change::topple, k);
  }

  std::vector<Course> take() && { return std::move(courses_); }

 private:
  const ForceSeries& force(int k) const { return series_.forces[static_cast<std::size_t>(k)]; }
  Series slip(int k) const {
    const CornerOnFace point = held_point(stack_.blocks, k, joints_[static_cast<std::size_t>(k)]);
    return times(point.upward, series_.held[static_cast<std::size_t>(k)].along);
  }
  Series relative_angle(int k) const {
    const Series& upper = series_.bodies[static_cast<std::size_t>(k)].angle;
    return k == 0 ? upper : sum(upper, times(-1, series_.bodies[static_cast<std::size_t>(k - 1)].angle));
  }
  Course& push(const Series& series, Change change, int k) {
    courses_.push_back({series, change, k, 0, false, {}, {}, 0});
    return courses_.back();
  }
  /// A force, or one times `factor`. Of blocks that fly side by side it is rounding: no event may come of it.
  void push_force(const Series& force, double factor, int k) {
    const double rounding = 1e-14 * factor * inertia_;
    if (std::any_of(force.begin(), force.end(), [&](double part) { return std::abs(part) > rounding; }))
      push(force, Change::force, k);
  }

  /// How far the right or left end of the lower face is beyond that of the upper one.
  Series overhang(int k, int side) const {
    return line(half_width_of(stack_.blocks, k - 1) - half_width_of(stack_.blocks, k), -side, slip(k));
  }
  /// Which of a flat contact's corners ends the overlap; even ones: that which the sliding makes end it.
  bool ends_below(int k, int side) const {
    const Joint& joint = joints_[static_cast<std::size_t>(k)];
    const double beyond =
        half_width_of(stack_.blocks, k - 1) - half_width_of(stack_.blocks, k) - side * joint.offset;
    return beyond < 0 || (beyond == 0 && joint.slip * side > 0);
  }

  /// N (end − centre of pressure), towards either end of the overlap; the moment is −N times the centre.
  void add_pressure(int k) {
    for (const int side : {-1, 1}) {
      Series arm{half_width_of(stack_.blocks, k)};
      if (k > 0 && ends_below(k, side)) arm = line(half_width_of(stack_.blocks, k - 1), -side, slip(k));
      push_force(sum(product(force(k).normal, arm), times(side, force(k).moment)),
                 half_width_of(stack_.blocks, k), k);
    }
  }

  void add_flat_ends(int k) {
    for (const int side : {-1, 1})
      push(times(ends_below(k, side) ? -1 : 1, overhang(k, side)), Change::corner, k);
  }

  void add_pivot_ends(int k) {
    const Joint& joint = joints_[static_cast<std::size_t>(k)];
    const CornerOnFace point = held_point(stack_.blocks, k, joint);
    const Series& along = series_.held[static_cast<std::size_t>(k)].along;
    const double end = half_width_of(stack_.blocks, point.face);
    push(line(end, -joint.side(), along), Change::corner, k);
    push(line(end, joint.side(), along), Change::fall, k);
  }

  void add_landings(int k) {
    for (const bool below : {false, true}) {
      if (below && k == 0) continue;
      for (const int side : {-1, 1}) {
        const CornerOnFace point =
            below ? lower_corner(stack_.blocks, k, side) : upper_corner(stack_.blocks, k, side);
        const FaceSeries place = corner_series(stack_.blocks, series_, point);
        Course& course = push(line(-half_height_of(stack_.blocks, point.face), point.upward, place.above),
                              Change::landing, k);
        course.side = side;
        course.below = below;
        course.rounding = 1e-13 * half_width_of(stack_.blocks, k);
        if (point.face < 0) continue;
        const double end = half_width_of(stack_.blocks, point.face);
        course.within = line(end, -side, place.along);
        course.within_other = line(end, side, place.along);
        // A block that is wholly beyond an end of the face below falls.
        if (!below) push(course.within_other, Change::fall, k);
      }
    }
  }

  const FrictionStack& stack_;
  const std::vector<Joint>& joints_;
  const ModeSeries& series_;
  double inertia_ = 0;  ///< what all blocks' accelerations take, in the unit of forces
  std::vector<Course> courses_;
};

}  // namespace

std::vector<Course> courses_of(const FrictionStack& stack, const std::vector<Joint>& joints,
                               const std::vector<double>& toppling_angles, const ModeSeries& series) {
  Collector collector(stack, joints, series);
  for (int k = 0; k < stack.size(); ++k) {
    collector.add_interface(k);
    collector.add_toppling(k, toppling_angles[static_cast<std::size_t>(k)]);
  }
  return std::move(collector).take();
}

}  // namespace rockstack
