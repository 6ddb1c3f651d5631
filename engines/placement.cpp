#include "engines/scene_setup.hpp"

#include "analytic/scene/kinematics.hpp"

namespace rockstack {
namespace {

/// Value of a block or the ground, −1.
double value(const std::vector<double>& values, int block) {
  return block < 0 || values.empty() ? 0 : values[static_cast<std::size_t>(block)];
}

Point<double> turned_by(double along, double across, double angle) {
  return turned(along, across, std::cos(angle), std::sin(angle));
}

/// What a block touches at the start, or would without its gap.
Pattern initial_pattern(const InitialState& initial) {
  const Vector<double> angles = relative(vector_of<double>(initial.angles));
  Pattern pattern = pattern_of(angles, relative(vector_of<double>(initial.velocities)));
  for (int k = 0; k < pattern.size; ++k)
    if (has_gap(initial, static_cast<std::size_t>(k)) && angles[k] == 0) pattern[k] = Contact::closed;
  return pattern;
}

/// Moves blocks as `initial` says, each with all above it.
struct Mover {
  const Scene& scene;
  const Pattern& pattern;
  Points<double> at, rate;  ///< centres as chains of pivots have them; offsets, gaps and slips come to them
  const InitialState& initial = scene.initial;

  void apply() {
    for (int k = 0; k < pattern.size; ++k) {
      if (const double offset = value(initial.offsets, k); offset != 0) move_off_centre(k, offset);
      if (has_gap(initial, static_cast<std::size_t>(k))) {
        lift(k);
      } else if (const double slip = value(initial.slip_velocities, k); slip != 0) {
        add(k, Point<double>::Zero(), turned_by(slip, 0, angle(holding(k))));
      }
    }
  }

  double angle(int body) const { return value(initial.angles, body); }
  double turning(int body) const { return value(initial.velocities, body); }
  double half_width(int body) const {
    return body < 0 ? std::numeric_limits<double>::infinity()
                    : scene.blocks[static_cast<std::size_t>(body)].half_width;
  }

  /// The body whose face an interface touches along: that below, or the block that leans over its corner.
  int holding(int k) const {
    const int side = sign(pattern[k]);
    return side != 0 && half_width(k - 1) - side * value(initial.offsets, k) < half_width(k) ? k : k - 1;
  }

  void add(int first, const Point<double>& way, const Point<double>& speed) {
    at.rightCols(pattern.size - first).colwise() += way;
    rate.rightCols(pattern.size - first).colwise() += speed;
  }

  /// The pivot goes from the end of centred faces to that of the faces as they overlap.
  void move_off_centre(int k, double offset) {
    const int side = sign(pattern[k]);
    const double centred = side * std::min(half_width(k), half_width(k - 1));
    const double pivot = side == 0 ? 0 : side * std::min(half_width(k), half_width(k - 1) - side * offset);
    const auto move = [&](double along, int body) {
      const Point<double> way = turned_by(along, 0, angle(body));
      add(k, way, turning(body) * quarter_turned<double>(way));
    };
    move(pivot + offset - centred, k - 1);
    move(centred - pivot, k);
  }

  void lift(int k) {
    add(k, turned_by(0, initial.gaps[static_cast<std::size_t>(k)], angle(holding(k))), Point<double>::Zero());
    const auto column = [&](const Points<double>& points, int body) -> Point<double> {
      return body < 0 ? Point<double>(Point<double>::Zero()) : Point<double>(points.col(body));
    };
    const Point<double> arm = column(at, k) - column(at, k - 1);
    const Point<double> speed =
        column(rate, k - 1) + turning(k - 1) * quarter_turned<double>(arm) +
        turned_by(value(initial.slip_velocities, k), value(initial.gap_velocities, k), angle(k - 1));
    add(k, Point<double>::Zero(), speed - column(rate, k));
  }
};

}  // namespace

std::vector<Placement> place(const Scene& scene) {
  const Vector<double> angles = vector_of<double>(scene.initial.angles);
  const Vector<double> velocities = vector_of<double>(scene.initial.velocities);
  const Pattern pattern = initial_pattern(scene.initial);
  const Chain<double> chain = make_chain(make_stack<double>(scene), pattern, angles);
  Mover mover{scene, pattern, centres(chain), centre_velocities(chain, velocities)};
  mover.apply();

  std::vector<Placement> placements;
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    const Block& block = scene.blocks[static_cast<std::size_t>(k)];
    const double depth = scene.depth;
    placements.push_back({.x = mover.at(0, k),
                          .y = mover.at(1, k),
                          .velocity_x = mover.rate(0, k),
                          .velocity_y = mover.rate(1, k),
                          .angle = angles[k],
                          .angular_velocity = velocities[k],
                          .width = 2 * block.half_width,
                          .height = 2 * block.half_height,
                          .depth = depth,
                          .offset_x = block.offset_x,
                          .offset_y = block.offset_y,
                          .mass = block.mass,
                          .inertia_about_x = rectangle_inertia(block.mass, 0.5 * depth, block.half_height),
                          .inertia_about_y = rectangle_inertia(block.mass, block.half_width, 0.5 * depth),
                          .inertia = block.inertia});
  }
  return placements;
}

}  // namespace rockstack
