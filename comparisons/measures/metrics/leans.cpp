#include "comparisons/measures/metrics/leans.hpp"

#include "comparisons/measures/metrics/bodies.hpp"

namespace rockstack {
namespace {

/// Lean of a block, in samples, by the angle of balance on the side that it leans to.
Lean lean_to_either_side(const Scene& scene, const History& history, std::size_t block) {
  Lean most{block, 0, 0};
  for (const int side : {1, -1}) {
    const double balance = balance_angle(scene, static_cast<int>(block), side);
    for (std::size_t i = 0; i < history.size(); ++i) {
      const double angle = side * history.angles_at(i)[block];
      if (angle > 0 && angle / balance > most.ratio) most = {block, angle / balance, history.times[i]};
    }
  }
  return most;
}

/// Along a block's lower face from its middle, the end of its contact with what is below on one side, m.
double contact_end(const Scene& scene, const History& history, std::size_t sample, std::size_t block,
                   int side) {
  const double own = scene.blocks[block].half_width;
  if (block == 0) return side * own;
  const double slip = history.slips.empty() ? 0 : history.row(history.slips, sample)[block];
  return side * std::min(own, scene.blocks[block - 1].half_width - side * slip);
}

/// The centre of mass of a block and all that stands on it, of centres from the lowest block up.
Point<double> common_centre(const Scene& scene, const Points<double>& centres, std::size_t block) {
  Point<double> moment = Point<double>::Zero();
  double mass = 0;
  for (std::size_t k = block; k < scene.blocks.size(); ++k) {
    moment += scene.blocks[k].mass * centres.col(static_cast<Eigen::Index>(k));
    mass += scene.blocks[k].mass;
  }
  return moment / mass;
}

/// The side that a block leans to over what is below it: 1 right, -1 left, 0 neither.
int leaning_side(const History& history, std::size_t sample, std::size_t block) {
  const auto angles = history.angles_at(sample);
  const double open = angles[block] - (block > 0 ? angles[block - 1] : 0.0);
  return (open > 0) - (open < 0);
}

/// From the corner that a block leans on, on that side, to a point.
Point<double> from_corner(const Scene& scene, const History& history, std::size_t sample,
                          const Points<double>& centres, std::size_t block, int side,
                          const Point<double>& point) {
  const Block& own = scene.blocks[block];
  const PlaneDirection<double> turn = direction_of(history.angles_at(sample)[block]);
  return point - centres.col(static_cast<Eigen::Index>(block)) -
         turned<double>(contact_end(scene, history, sample, block, side) - own.offset_x,
                        -own.half_height - own.offset_y, turn.cosine, turn.sine);
}

/// How far the line from_corner() to the common centre of mass is from gravity's direction, rad, were all
/// blocks upright where they have slipped to; not positive where they could not stand so.
double common_slenderness(const Scene& scene, const History& history, std::size_t sample, std::size_t block,
                          int side) {
  double x = 0, y = 0, mass = 0, middle = 0, floor = 0;
  for (std::size_t k = block; k < scene.blocks.size(); ++k) {
    const Block& own = scene.blocks[k];
    if (k > block && !history.slips.empty()) middle += history.row(history.slips, sample)[k];
    x += own.mass * (middle + own.offset_x);
    y += own.mass * (floor + own.half_height + own.offset_y);
    mass += own.mass;
    floor += 2 * own.half_height;
  }
  const double end = contact_end(scene, history, sample, block, side);
  return std::atan2(side * (end - x / mass), y / mass) - side * scene.inclination;
}

}  // namespace

std::vector<Swing> swings(const History& history, std::size_t block) {
  std::vector<Swing> list(1);
  double side = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double angle = history.angles_at(i)[block];
    if (i == 0) side = angle;
    if (angle * side < 0) {
      list.back().end = history.times[i];
      list.emplace_back();
      side = angle;
    }
    if (std::abs(angle) > list.back().peak) {
      list.back().peak = std::abs(angle);
      list.back().peak_time = history.times[i];
    }
  }
  return list;
}

Swing largest_swing(const History& history, std::size_t block) {
  const auto list = swings(history, block);
  return *std::ranges::max_element(list, {}, &Swing::peak);
}

std::vector<double> peak_angles(const History& history) {
  if (!history.peaks.empty()) return history.peaks;
  std::vector<double> result(static_cast<std::size_t>(history.blocks));
  for (std::size_t i = 0; i < history.angles.size(); ++i) {
    double& peak = result[i % result.size()];
    peak = std::max(peak, std::abs(history.angles[i]));
  }
  return result;
}

std::vector<double> uplifts_of(const Scene& scene, const History& history) {
  if (!history.uplifts.empty()) return history.uplifts;
  std::vector<double> openings(scene.blocks.size(), 0);
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Vector<double> angles = relative(vector_of(history.angles_at(i)));
    for (std::size_t k = 0; k < openings.size(); ++k)
      openings[k] = std::max(openings[k], std::abs(angles[static_cast<Eigen::Index>(k)]));
  }
  for (std::size_t k = 0; k < openings.size(); ++k)
    openings[k] = corner_rise(scene, static_cast<int>(k), openings[k]);
  return openings;
}

Lean largest_lean(const Scene& scene, const History& history) {
  const std::vector<double> peaks = peak_angles(history);
  Lean largest;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const Lean lean =
        scene.blocks[k].offset_x == 0 || history.angles.empty()
            ? Lean{k, peaks[k] / slenderness(scene, static_cast<int>(k)), largest_swing(history, k).peak_time}
            : lean_to_either_side(scene, history, k);
    if (lean.ratio > largest.ratio) largest = lean;
  }
  return largest;
}

Lean largest_common_lean(const Scene& scene, const History& history) {
  const Stack<double> stack = make_stack<double>(scene);
  // On level ground the top block is one by itself.
  const std::size_t most = scene.blocks.size() - (scene.inclination == 0 ? 1 : 0);
  Lean largest;
  for (std::size_t i = 0; i < history.size(); ++i) {
    std::optional<Points<double>> centres;  // where a block leans
    for (std::size_t k = 0; k < most; ++k) {
      const int side = leaning_side(history, i, k);
      if (side == 0) continue;
      if (!centres) centres = centre_places(stack, history, i);
      const Point<double> arm =
          from_corner(scene, history, i, *centres, k, side, common_centre(scene, *centres, k));
      const double lean = side * (std::atan2(arm.x(), arm.y()) + scene.inclination);
      const double upright = common_slenderness(scene, history, i, k, side);
      if (!(upright > 0)) continue;
      const double ratio = 1 + lean / upright;
      if (ratio > largest.ratio) largest = {k, ratio, history.times[i]};
    }
  }
  return largest;
}

std::optional<FallingBlock> falling_block(const Scene& scene, const History& history, std::size_t sample) {
  const Gravity gravity = gravity_of(scene);
  const Points<double> centres = centre_places(make_stack<double>(scene), history, sample);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const int side = leaning_side(history, sample, k);
    const Point<double> arm =
        from_corner(scene, history, sample, centres, k, side, common_centre(scene, centres, k));
    if (side * (arm.x() * gravity.across + arm.y() * gravity.along) > 0 &&
        side * history.velocities_at(sample)[k] > 0)
      return FallingBlock{
          k, !(common_slenderness(scene, history, sample, k, side) + side * scene.inclination > 0)};
  }
  return {};
}

}  // namespace rockstack
