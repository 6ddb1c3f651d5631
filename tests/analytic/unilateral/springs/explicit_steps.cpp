#include "tests/analytic/unilateral/springs/explicit_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rockstack::testing {
namespace {

using Plane = std::complex<double>;

/// A corner of an interface that is on a face, or may come to be; or the middle of a bed.
struct Corner {
  int interface = 0;  ///< from 0
  int side = 0;       ///< 0: a bed
  bool of_lower = false;
  bool on = false;
  double stretch = 0;  ///< of the spring along the face, m
};

/// A corner against its face.
struct Meeting {
  double depth, depth_rate, along, slip_rate;
  Plane normal, tangent;  ///< of the block above
  Plane point;
};

struct Push {
  double normal, tangential;
  double stretch_rate;
  double moment = 0;  ///< of a bed's pressure about its middle, to the right positive, N·m
};

/// What a bed of half-width b bears by a depth and a pressure that go linearly along it, as those of its
/// ends: ∫ p dx and ∫ p x dx where both are above zero. Simpson's rule is exact on each stretch.
Push bed_push(double half_width, const std::array<double, 2>& depth, const std::array<double, 2>& pressure) {
  const auto at = [](const std::array<double, 2>& ends, double u) {
    return (ends[0] * (1 - u) + ends[1] * (1 + u)) / 2;
  };
  std::vector<double> bounds{-1, 1};
  for (const auto& ends : {depth, pressure})
    if (ends[0] * ends[1] < 0) bounds.push_back((ends[0] + ends[1]) / (ends[0] - ends[1]));
  std::sort(bounds.begin(), bounds.end());
  Push sum{0, 0, 0};
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const double from = bounds[i - 1];
    const double to = bounds[i];
    const double middle = (from + to) / 2;
    if (at(depth, middle) <= 0 || at(pressure, middle) <= 0) continue;
    const double sixth = (to - from) / 6 * half_width;
    sum.normal += sixth * (at(pressure, from) + 4 * at(pressure, middle) + at(pressure, to));
    sum.moment += sixth * half_width *
                  (at(pressure, from) * from + 4 * at(pressure, middle) * middle + at(pressure, to) * to);
  }
  return sum;
}

class Springs {
 public:
  explicit Springs(const Scene& scene) : scene_(scene), friction_(friction_of(scene)) {
    for (int k = 0; k < size(); ++k) {
      if (!scene.springs.bed_stiffness.empty()) {
        const bool of_lower = k > 0 && half_width(k - 1) < half_width(k);
        corners_.push_back({k, 0, of_lower, true});
        continue;
      }
      for (const int side : {-1, 1}) corners_.push_back({k, side});
    }
  }

  int size() const { return static_cast<int>(scene_.blocks.size()); }
  std::vector<Corner>& corners() { return corners_; }

  Meeting meeting(const std::vector<PlaneBlock>& blocks, const Corner& corner) const {
    const int upper = corner.interface;
    const int lower = upper - 1;
    const PlaneBlock above = blocks[static_cast<std::size_t>(upper)];
    const PlaneBlock below = lower < 0 ? PlaneBlock{} : blocks[static_cast<std::size_t>(lower)];
    const Block& of_above = scene_.blocks[static_cast<std::size_t>(upper)];
    const Block of_below = lower < 0 ? Block{} : scene_.blocks[static_cast<std::size_t>(lower)];
    const PlaneBlock& face = corner.of_lower ? above : below;
    const Plane turn = std::polar(1.0, -face.angle);
    Meeting result{};
    const Plane arm =
        corner.of_lower
            ? std::polar(1.0, -below.angle) * Plane(corner.side * of_below.half_width, of_below.half_height)
            : std::polar(1.0, -above.angle) * Plane(corner.side * of_above.half_width, -of_above.half_height);
    const PlaneBlock& owner = corner.of_lower ? below : above;
    result.point = owner.place + arm;
    const Plane in_face = (result.point - face.place) * std::conj(turn);
    // Velocities turn clockwise.
    const auto velocity = [&](const PlaneBlock& block) {
      return block.velocity - Plane(0, block.rate) * (result.point - block.place);
    };
    const Plane speed = (velocity(above) - velocity(below)) * std::conj(turn);
    result.depth = corner.of_lower ? in_face.imag() + of_above.half_height
                                   : (lower < 0 ? 0 : of_below.half_height) - in_face.imag();
    result.depth_rate = -speed.imag();
    result.along = in_face.real();
    result.slip_rate = speed.real();
    result.normal = turn * Plane(0, 1);
    result.tangent = turn;
    return result;
  }

  Push push(const Corner& corner, const Meeting& meeting) const {
    if (!corner.on) return {0, 0, 0};
    const double k_n = stiffness(corner);
    const double c_n = damping(corner);
    const double normal = k_n * meeting.depth + c_n * meeting.depth_rate;
    if (normal <= 0) return {0, 0, 0};
    return rubbed(corner, meeting, {normal, 0, 0});
  }

  /// A bed, of which the ends are at these meetings.
  Push push(const Corner& bed, const Meeting& middle, const Meeting& left, const Meeting& right) const {
    const double width = 2 * bed_half_width(bed);
    const auto pressure = [&](const Meeting& end) {
      return (stiffness(bed) * end.depth + damping(bed) * end.depth_rate) / width;
    };
    Push pressed = bed_push(width / 2, {left.depth, right.depth}, {pressure(left), pressure(right)});
    pressed.moment *= (right.along - left.along) / width;  // forces are across the other face
    return pressed.normal > 0 ? rubbed(bed, middle, pressed) : Push{0, 0, 0};
  }

  /// With what a spring and a dashpot along the face do before a slider.
  Push rubbed(const Corner& corner, const Meeting& meeting, Push push) const {
    const double k_t = stiffness(corner) * scene_.springs.tangential;
    const double c_t = damping(corner) * scene_.springs.tangential;
    const double limit = friction_[static_cast<std::size_t>(corner.interface)] * push.normal;
    const double force = k_t * corner.stretch + c_t * meeting.slip_rate;
    if (std::abs(force) <= limit) {
      push.tangential = -force;
      push.stretch_rate = meeting.slip_rate;
    } else {
      const double held = std::copysign(limit, force);
      push.tangential = -held;
      push.stretch_rate = c_t > 0 ? (held - k_t * corner.stretch) / c_t : meeting.slip_rate;
    }
    return push;
  }

  double half_width(int block) const { return scene_.blocks[static_cast<std::size_t>(block)].half_width; }
  double bed_half_width(const Corner& bed) const {
    return half_width(bed.interface - (bed.of_lower ? 1 : 0));
  }
  /// Stiffness of a corner, or of all of a bed.
  double stiffness(const Corner& corner) const {
    const auto k = static_cast<std::size_t>(corner.interface);
    return corner.side != 0 ? scene_.springs.stiffness[k]
                            : 2 * bed_half_width(corner) * scene_.springs.bed_stiffness[k];
  }
  double damping(const Corner& corner) const {
    const auto k = static_cast<std::size_t>(corner.interface);
    return corner.side != 0 ? scene_.springs.damping[k]
                            : 2 * bed_half_width(corner) * scene_.springs.bed_damping[k];
  }

  Push push_at(const std::vector<PlaneBlock>& blocks, const Corner& corner, const Meeting& meeting) const {
    if (corner.side != 0) return push(corner, meeting);
    Corner left = corner;
    Corner right = corner;
    left.side = -1;
    right.side = 1;
    return push(corner, meeting, this->meeting(blocks, left), this->meeting(blocks, right));
  }

  /// What corners are after a step.
  void learn(const std::vector<PlaneBlock>& blocks) {
    for (Corner& corner : corners_) {
      if (!corner.on) find(blocks, corner);
      if (!corner.on) continue;
      const Meeting now = meeting(blocks, corner);
      const Push force = push_at(blocks, corner, now);
      pass(blocks, now, force, corner);
      if (now.depth <= 0 && corner.side != 0) corner.on = false;
      if (force.normal <= 0) corner.stretch = 0;
      if (damping(corner) > 0) continue;
      const double most = friction_[static_cast<std::size_t>(corner.interface)] * force.normal /
                          (stiffness(corner) * scene_.springs.tangential);
      corner.stretch = std::clamp(corner.stretch, -most, most);
    }
  }

  /// While it slides outward, the corner that is farther inside its face pushes; springs hold what they held.
  void pass(const std::vector<PlaneBlock>& blocks, const Meeting& now, const Push& force,
            Corner& corner) const {
    if (corner.side == 0 || corner.interface == 0 || force.normal <= 0) return;
    const int outward = corner.of_lower ? -corner.side : corner.side;
    const double limit = friction_[static_cast<std::size_t>(corner.interface)] * force.normal;
    const bool slides = std::abs(force.tangential) >= limit;
    if (!slides || -force.tangential * outward < 0) return;
    Corner other = corner;
    other.of_lower = !corner.of_lower;
    const Meeting there = meeting(blocks, other);
    const auto inside = [&](const Corner& which, const Meeting& where) {
      return half_width(corner.interface - (which.of_lower ? 0 : 1)) - corner.side * where.along;
    };
    if (inside(corner, now) >= inside(other, there)) return;
    const double freed = (now.depth * now.depth - there.depth * there.depth) / scene_.springs.tangential;
    other.stretch =
        std::copysign(std::sqrt(std::max(0.0, corner.stretch * corner.stretch + freed)), corner.stretch);
    corner = other;
  }

  /// Which of the two corners at an end of an interface is in a face.
  void find(const std::vector<PlaneBlock>& blocks, Corner& corner) const {
    for (const bool of_lower : {false, true}) {
      if (of_lower && corner.interface == 0) continue;
      Corner candidate = corner;
      candidate.of_lower = of_lower;
      const Meeting now = meeting(blocks, candidate);
      const int face = of_lower ? corner.interface : corner.interface - 1;
      const double end = face < 0 ? INFINITY : scene_.blocks[static_cast<std::size_t>(face)].half_width;
      if (now.depth <= 0 || std::abs(now.along) > end * (1 + 1e-12)) continue;
      corner.of_lower = of_lower;
      corner.on = true;
      corner.stretch = 0;
      return;
    }
  }

 private:
  const Scene& scene_;
  std::vector<double> friction_;
  std::vector<Corner> corners_;
};

/// All that a step changes.
struct Rates {
  std::vector<PlaneBlock> blocks;  ///< places' and velocities' rates
  std::vector<double> stretches;
};

Rates rates(const Scene& scene, Springs& springs, const std::vector<PlaneBlock>& blocks) {
  Rates result;
  for (const PlaneBlock& block : blocks)
    result.blocks.push_back({block.velocity, Plane(0, -scene.gravity), block.rate, 0});
  for (const Corner& corner : springs.corners()) {
    const Meeting meeting = springs.meeting(blocks, corner);
    const Push push = springs.push_at(blocks, corner, meeting);
    result.stretches.push_back(push.stretch_rate);
    const Plane force = push.normal * meeting.normal + push.tangential * meeting.tangent;
    for (const int sign : {1, -1}) {
      const int k = sign > 0 ? corner.interface : corner.interface - 1;
      if (k < 0) continue;
      const auto index = static_cast<std::size_t>(k);
      const Block& block = scene.blocks[index];
      result.blocks[index].velocity += double(sign) * force / block.mass;
      // Clockwise.
      const Plane arm = meeting.point - blocks[index].place;
      result.blocks[index].rate -= sign * ((std::conj(arm) * force).imag() + push.moment) / block.inertia;
    }
  }
  return result;
}

void add(const Rates& slope, double time, std::vector<PlaneBlock>& blocks, std::vector<Corner>& corners) {
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    blocks[k].place += time * slope.blocks[k].place;
    blocks[k].velocity += time * slope.blocks[k].velocity;
    blocks[k].angle += time * slope.blocks[k].angle;
    blocks[k].rate += time * slope.blocks[k].rate;
  }
  for (std::size_t c = 0; c < corners.size(); ++c) corners[c].stretch += time * slope.stretches[c];
}

}  // namespace

std::vector<PlaneBlock> explicit_motion(const Scene& scene, std::vector<PlaneBlock> blocks, double end,
                                        double step) {
  Springs springs(scene);
  springs.learn(blocks);
  const auto steps = static_cast<int>(std::ceil(end / step));
  const double length = end / steps;
  for (int i = 0; i < steps; ++i) {
    const std::vector<PlaneBlock> start = blocks;
    const std::vector<Corner> corners = springs.corners();
    std::vector<PlaneBlock> sum = start;
    std::vector<Corner> sum_corners = corners;
    // Each slope is taken from the start along the one before it, this share of the step.
    constexpr std::array next{0.5, 0.5, 1.0, 0.0};
    constexpr std::array weights{1.0, 2.0, 2.0, 1.0};
    for (std::size_t stage = 0; stage < next.size(); ++stage) {
      const Rates slope = rates(scene, springs, blocks);
      blocks = start;
      springs.corners() = corners;
      add(slope, next[stage] * length, blocks, springs.corners());
      add(slope, weights[stage] * length / 6, sum, sum_corners);
    }
    blocks = sum;
    springs.corners() = sum_corners;
    springs.learn(blocks);
  }
  return blocks;
}

}  // namespace rockstack::testing
