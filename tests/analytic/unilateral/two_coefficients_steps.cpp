#include <Eigen/Dense>
#include <array>

#include "tests/analytic/unilateral/two_coefficients.hpp"

namespace rockstack::testing {
namespace {

using Vector3 = Eigen::Vector3d;
constexpr double close = 1e-10;  // m: what touches

/// Which corners push, left and right, and which way the face slides.
struct BlockMode {
  bool left, right;
  int slip;
  bool operator==(const BlockMode&) const = default;
};

/// One block over a level ground: rates of its centre and, clockwise, of its angle.
struct SteppedBlock {
  const Scene& scene;
  Vector3 at, rate;
  int slid = 0;                   ///< which way, in the last step
  std::array<bool, 2> touched{};  ///< likewise

  const Block& block() const { return scene.blocks.front(); }
  /// From the centre to a corner of the bottom face, −1 or 1.
  Eigen::Vector2d arm(int side) const {
    const double c = std::cos(at[2]), s = std::sin(at[2]), x = side * block().half_width;
    return {x * c - block().half_height * s, -x * s - block().half_height * c};
  }
  double gap(int side) const { return at[1] + arm(side).y(); }
  Vector3 normal(int side) const { return {0, 1, -arm(side).x()}; }
  Vector3 tangent(int side) const { return {1, 0, arm(side).y()}; }
  Vector3 lightness() const { return {1 / block().mass, 1 / block().mass, 1 / block().inertia}; }

  /// The rates after a step in a mode, or nothing where it does not obey; `stick` is the cone's coefficient.
  std::optional<Vector3> after(const BlockMode& mode, const Vector3& free,
                               const std::array<bool, 2>& touching, double stick, double slide) const {
    std::vector<Vector3> rows;
    if (mode.left) rows.push_back(normal(-1));
    if (mode.right) rows.push_back(normal(1));
    if (rows.empty()) return obeys_gaps(mode, free, touching) ? std::optional(free) : std::nullopt;
    const std::size_t normals = rows.size();
    const int end = mode.left && mode.right ? 0 : mode.left ? -1 : 1;
    const Vector3 along = end == 0 ? Vector3((tangent(-1) + tangent(1)) / 2) : tangent(end);
    if (mode.slip == 0) rows.push_back(along);
    const auto size = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd matrix(size, size);
    Eigen::VectorXd right(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      right[i] = -rows[i].dot(free);
      for (Eigen::Index j = 0; j < size; ++j) {
        const bool across = static_cast<std::size_t>(j) < normals;
        const Vector3 push = across ? Vector3(rows[j] - mode.slip * slide * along) : rows[j];
        matrix(i, j) = rows[i].dot(lightness().cwiseProduct(push));
      }
    }
    const Eigen::VectorXd force = matrix.partialPivLu().solve(right);
    Vector3 rates = free;
    double pressing = 0;
    for (Eigen::Index j = 0; j < size; ++j) {
      const bool across = static_cast<std::size_t>(j) < normals;
      if (across && force[j] < 0) return std::nullopt;
      if (across) pressing += force[j];
      rates += lightness().cwiseProduct(across ? Vector3(rows[j] - mode.slip * slide * along) : rows[j]) *
               force[j];
    }
    if (mode.slip == 0 && std::abs(force[size - 1]) > stick * pressing) return std::nullopt;
    if (mode.slip * along.dot(rates) < 0) return std::nullopt;
    return obeys_gaps(mode, rates, touching) ? std::optional(rates) : std::nullopt;
  }
  bool obeys_gaps(const BlockMode& mode, const Vector3& rates, const std::array<bool, 2>& touching) const {
    const auto meets = [&](int side, bool pushes, bool touches) {
      return touches && !pushes && normal(side).dot(rates) < -1e-13;
    };
    return !meets(-1, mode.left, touching[0]) && !meets(1, mode.right, touching[1]);
  }

  void step(double time, double length) {
    const double push = acceleration(scene.horizontal, time + length / 2);
    const Vector3 free = rate + length * Vector3(-push, -scene.gravity, 0);
    at += length / 2 * rate;
    const std::array<bool, 2> touching{gap(-1) <= close, gap(1) <= close};
    const auto comes_in = [&](int side, std::size_t i) {
      return touching[i] && !touched[i] && normal(side).dot(rate) < -3 * scene.gravity * length;
    };
    const bool meets = comes_in(-1, 0) || comes_in(1, 1);
    const double kinetic = scene.kinetic_friction.front();
    const double holds = meets ? kinetic : scene.friction.front();
    // What slides goes on to, or sticks, or slides back.
    for (const int way : {slid, 0, slid == 0 ? -1 : -slid, slid == 0 ? 1 : 0})
      for (const bool left : {true, false})
        for (const bool right : {true, false}) {
          if ((left && !touching[0]) || (right && !touching[1])) continue;
          const auto next = after({left, right, way}, free, touching, holds, kinetic);
          if (!next) continue;
          rate = *next;
          at += length / 2 * rate;
          slid = left || right ? way : 0;
          touched = touching;
          return;
        }
    throw std::runtime_error("no mode obeys");
  }
};

}  // namespace

Scene shaken_block(std::uint64_t seed) {
  Draw draw(seed + 91000);
  const double width = draw.between(0.4, 1.2), height = draw.between(0.5, 3);
  const double slenderness = std::atan(width / height);
  Scene scene =
      released({block(width, height)}, {draw.below(2) == 0 ? 0 : draw.between(-0.4, 0.4) * slenderness},
               draw.between(0.4, 1.2));
  const double friction = draw.between(0.15, 0.9);
  scene = with_coefficients(std::move(scene), friction, friction * draw.between(0.3, 0.95));
  scene.horizontal = pulse_of(draw.below(2) == 0 ? PulseShape::sine : PulseShape::half_sine,
                              scene.gravity * draw.between(-1, 1), draw.between(0.2, 0.8));
  return scene;
}

Pose<> block_stepped(const Scene& scene, std::size_t steps) {
  SteppedBlock stepped{scene, Vector3::Zero(), Vector3::Zero()};
  stepped.at[2] = scene.initial.angles.front();
  stepped.at[1] = -std::min(stepped.gap(-1), stepped.gap(1));
  // The solver puts the corner that touches where it was as the block stood.
  const int side = stepped.at[2] > 0 ? 1 : stepped.at[2] < 0 ? -1 : 0;
  if (side != 0) stepped.at[0] = side * scene.blocks.front().half_width - stepped.arm(side).x();
  stepped.touched = {stepped.gap(-1) <= close, stepped.gap(1) <= close};
  const double length = scene.duration / static_cast<double>(steps);
  for (std::size_t k = 0; k < steps; ++k) stepped.step(static_cast<double>(k) * length, length);
  return {stepped.at[0], stepped.at[1], stepped.at[2]};
}

Scene sliding_stack(std::uint64_t seed) {
  Draw draw(seed + 92000);
  const int count = 1 + draw.below(4);
  std::vector<Block> blocks;
  for (int k = 0; k < count; ++k) blocks.push_back(block(20, draw.between(0.1, 0.3)));
  Scene scene = released(blocks, std::vector<double>(count, 0), draw.between(0.5, 2));
  scene = with_coefficients(std::move(scene), 0, 0);
  for (int k = 0; k < count; ++k) {
    scene.friction[k] = draw.between(0.1, 0.8);
    scene.kinetic_friction[k] = scene.friction[k] * draw.between(0.2, 1);
    scene.initial.slip_velocities.push_back(draw.below(3) == 0 ? draw.between(-1, 1) : 0);
  }
  scene.horizontal = pulse_of(PulseShape::sine, scene.gravity * draw.between(0.1, 1.5), draw.between(0.2, 1));
  scene.horizontal.pulse->cycles = 4;
  return scene;
}

std::vector<double> slides_stepped(const Scene& scene, std::size_t steps) {
  const auto count = static_cast<Eigen::Index>(scene.blocks.size());
  const double length = scene.duration / static_cast<double>(steps);
  Eigen::VectorXd pressing = Eigen::VectorXd::Zero(count);  // impulse of weight in a step
  for (Eigen::Index k = count - 1; k >= 0; --k)
    pressing[k] = scene.blocks[k].mass * scene.gravity * length + (k + 1 < count ? pressing[k + 1] : 0);
  Eigen::VectorXd slips = Eigen::VectorXd::Zero(count), slip_rates(count);
  for (Eigen::Index k = 0; k < count; ++k) slip_rates[k] = scene.initial.slip_velocities[k];
  std::vector<bool> stuck(count);
  for (Eigen::Index k = 0; k < count; ++k) stuck[k] = slip_rates[k] == 0;
  // What impulses at interfaces do to slip rates.
  Eigen::MatrixXd effect = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    effect(k, k) = 1 / scene.blocks[k].mass + (k > 0 ? 1 / scene.blocks[k - 1].mass : 0);
    if (k > 0) effect(k, k - 1) = effect(k - 1, k) = -1 / scene.blocks[k - 1].mass;
  }
  for (std::size_t step = 0; step < steps; ++step) {
    const double push = acceleration(scene.horizontal, (static_cast<double>(step) + 0.5) * length);
    Eigen::VectorXd free = slip_rates;
    free[0] -= push * length;
    const Eigen::VectorXd before = slip_rates;
    std::vector<bool> holds = stuck, left(count, false);
    const auto solve_cones = [&] {
      Eigen::VectorXd cone(count);
      for (Eigen::Index k = 0; k < count; ++k)
        cone[k] = (holds[k] ? scene.friction[k] : scene.kinetic_friction[k]) * pressing[k];
      // A convex problem with bounds: sweeps go on until they change nothing.
      Eigen::VectorXd impulse = Eigen::VectorXd::Zero(count);
      for (int sweep = 0; sweep < 10000; ++sweep) {
        double change = 0;
        for (Eigen::Index k = 0; k < count; ++k) {
          const double rate = free[k] + effect.row(k).dot(impulse);
          const double next = std::clamp(impulse[k] - rate / effect(k, k), -cone[k], cone[k]);
          change = std::max(change, std::abs(next - impulse[k]));
          impulse[k] = next;
        }
        if (change <= 1e-14 * pressing[0]) break;
      }
      return impulse;
    };
    for (bool again = true; again;) {
      again = false;
      const Eigen::VectorXd impulse = solve_cones();
      slip_rates = free + effect * impulse;
      for (Eigen::Index k = 0; k < count; ++k) {
        const double rate = std::abs(slip_rates[k]) < 1e-12 ? 0 : slip_rates[k];
        // What slides back has stuck between.
        const bool turns = !holds[k] && !left[k] && rate * before[k] <= 0;
        if (turns || (holds[k] && rate != 0)) {
          left[k] = holds[k];
          holds[k] = !holds[k];
          again = true;
        }
        stuck[k] = rate == 0;
      }
    }
    slips += length * slip_rates;
  }
  return {slips.begin(), slips.end()};
}

}  // namespace rockstack::testing
