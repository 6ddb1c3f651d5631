#include "engines/body_record.hpp"

#include "analytic/scene/kinematics.hpp"
#include "analytic/scene/lists.hpp"
#include "engines/applied_loads.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {
namespace {

/// A face in its own axes: x along it from its middle, y out of the body.
struct Face {
  BlockPose middle;        ///< where the face's middle is
  double half_length = 0;  ///< m
  double outward = 1;      ///< +1: the top of its body, −1: the bottom
};

Point<double> along(const BlockPose& pose, double across, double up) {
  return Point<double>(pose.x, pose.y) + turned(across, up, std::cos(pose.angle), std::sin(pose.angle));
}

Face face_of(const Block& block, const BlockPose& pose, double outward) {
  const Point<double> middle = along(pose, -block.offset_x, outward * block.half_height - block.offset_y);
  return {{middle.x(), middle.y(), pose.angle}, block.half_width, outward};
}

/// The face's end on one side.
Point<double> corner(const Face& face, double side) {
  return along(face.middle, side * face.half_length, 0);
}

/// A point in the face's axes.
Point<double> seen_from(const Face& face, const Point<double>& point) {
  const double x = point.x() - face.middle.x, y = point.y() - face.middle.y;
  const double cosine = std::cos(face.middle.angle), sine = std::sin(face.middle.angle);
  return {x * cosine - y * sine, face.outward * (x * sine + y * cosine)};
}

double deepest_corner(const Face& face, const Face& other) {
  double depth = -std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const Point<double> place = seen_from(face, corner(other, side));
    if (std::abs(place.x()) <= face.half_length) depth = std::max(depth, -place.y());
  }
  return depth;
}

/// Slip of `upper`, a bottom, on `lower`, a top. `leaning`: −1 or 1.
double slip_of(const Face& lower, const Face& upper, double leaning) {
  const double on_lower = seen_from(lower, corner(upper, leaning)).x();
  if (leaning * on_lower <= lower.half_length) return on_lower - leaning * upper.half_length;
  return leaning * lower.half_length - seen_from(upper, corner(lower, leaning)).x();
}

/// Whether a block lies on the ground, to so much, m.
bool lies_on_ground(const Block& block, const BlockPose& pose, double tolerance) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const int face : {-1, 1})
    for (const double side : {-1.0, 1.0})
      lowest = std::min(lowest, corner(face_of(block, pose, face), side).y());
  return lowest < tolerance;
}

/// Share of the height below a block by which it has sunk in rather than fallen off.
constexpr double sunk_share = 0.5;

/// Time of a sample, s.
double time_of(const Setup& setup, const Trajectory& trajectory, std::size_t sample) {
  return trajectory.times.empty() ? static_cast<double>(sample) * setup.dt : trajectory.times[sample];
}

/// Goes through the samples of a trajectory that tells its bodies.
class BodyAccount {
 public:
  BodyAccount(const Scene& scene, const Setup& setup, const Trajectory& trajectory)
      : scene_(scene), setup_(setup), trajectory_(trajectory), loads_(setup) {
    record_.unsupported_since.assign(setup.blocks.size(), std::numeric_limits<double>::infinity());
    for (const Block& block : scene.blocks) least_height_ = std::min(least_height_, 2 * block.half_height);
  }

  void next() {
    if (samples_ > 0 && !setup_.ground.empty()) {
      ground_ = setup_.ground[samples_ - 1];
      ground_.x += setup_.dt * ground_.velocity_x;
      ground_.y += setup_.dt * ground_.velocity_y;
    }
    const std::size_t blocks = setup_.blocks.size();
    const auto bodies = std::span(trajectory_.bodies).subspan(samples_ * blocks, blocks);
    last_poses_ = std::move(poses_);
    poses_.clear();
    for (std::size_t k = 0; k < blocks; ++k) {
      const BodyState& body = bodies[k];
      poses_.push_back({body.x - ground_.x, body.y - ground_.y, trajectory_.angles[samples_ * blocks + k]});
      record_.out_of_plane = std::max(record_.out_of_plane, std::abs(body.z));
      record_.out_of_plane_tilt = std::max(record_.out_of_plane_tilt, body.tilt);
    }
    for (const BlockPose& pose : poses_) record_.centres.insert(record_.centres.end(), {pose.x, pose.y});
    const auto velocities = std::span(trajectory_.velocities).subspan(samples_ * blocks, blocks);
    add_energy(bodies, velocities);
    if (loads_.any()) add_work_of_loads(bodies, velocities);
    add_interfaces();
    ++samples_;
  }

  const BodyRecord& record() const { return record_; }
  const std::vector<InterfaceState>& interfaces() const { return interfaces_; }

 private:
  void add_energy(std::span<const BodyState> bodies, std::span<const double> velocities) {
    double energy = 0, work = 0, rest_height = 0;
    BodyAcceleration pull;
    const Gravity gravity = gravity_of(scene_);
    if (samples_ > 0 && is_shaken(scene_))
      pull = body_acceleration(scene_, time_of(setup_, trajectory_, samples_ - 1),
                               time_of(setup_, trajectory_, samples_));
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Block& block = scene_.blocks[k];
      const double along = bodies[k].velocity_x - ground_.velocity_x;
      const double up = bodies[k].velocity_y - ground_.velocity_y;
      rest_height += block.half_height;
      energy += 0.5 * block.mass * (along * along + up * up) +
                0.5 * block.inertia * velocities[k] * velocities[k] +
                block.mass * gravity.across * (poses_[k].y - rest_height - block.offset_y) -
                block.mass * gravity.along * (poses_[k].x - block.offset_x);
      rest_height += block.half_height;
      if (samples_ == 0 || !is_shaken(scene_)) continue;
      work += block.mass * ((pull.x - gravity.along) * (poses_[k].x - last_poses_[k].x) +
                            (pull.y + gravity.across) * (poses_[k].y - last_poses_[k].y));
    }
    record_.energy.push_back(energy);
    record_.input.push_back(work + (record_.input.empty() ? 0 : record_.input.back()));
  }

  /// Adds the work of pushes and restraints over the step before this sample, as the engine was told of them.
  void add_work_of_loads(std::span<const BodyState> bodies, std::span<const double> velocities) {
    double work = 0;
    for (std::size_t k = 0; k < last_loads_.size(); ++k)
      work += last_loads_[k].x * (poses_[k].x - last_poses_[k].x) +
              last_loads_[k].y * (poses_[k].y - last_poses_[k].y) +
              last_loads_[k].moment * (poses_[k].angle - last_poses_[k].angle);
    record_.input.back() += work;
    std::vector<BodyState> blocks(bodies.begin(), bodies.end());
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      blocks[k].angle = poses_[k].angle;
      blocks[k].angular_velocity = velocities[k];
    }
    const auto& path = setup_.ground;
    const GroundStep next = path.empty() ? GroundStep{} : path[std::min(samples_, path.size() - 1)];
    last_loads_ = loads_.over_step(samples_, blocks, next);
  }

  void add_interfaces() {
    const double time = time_of(setup_, trajectory_, samples_);
    double penetration = 0, gap = 0;
    double sunk = 0, below = 0;  // depths and heights of all below a block, m
    double skin = 0.01 * least_height_;
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const Block& block = scene_.blocks[k];
      const InterfaceState& state =
          interfaces_.emplace_back(k == 0 ? on_ground(block, poses_[0])
                                          : on_block(scene_.blocks[k - 1], poses_[k - 1], block, poses_[k]));
      const double start = scene_.initial.offsets.empty() ? 0 : scene_.initial.offsets[k];
      record_.slip = std::max(record_.slip, std::abs(state.slip - start));
      if (std::isfinite(state.depth)) sunk += std::max(0.0, state.depth);
      // What is at the ground because all has sunk in has not fallen off.
      const bool supported = std::isfinite(state.depth) &&
                             (k == 0 || sunk > sunk_share * below || !lies_on_ground(block, poses_[k], skin));
      // Engines that keep a skin hold the lowest block above the ground, and so what lies beside it.
      if (k == 0) skin += std::clamp(-1.5 * state.depth, 0.0, 0.1 * least_height_);
      below += 2 * block.half_height;
      record_.unsupported_since[k] =
          supported ? std::numeric_limits<double>::infinity() : std::min(record_.unsupported_since[k], time);
      if (!supported) continue;
      penetration = std::max(penetration, state.depth);
      gap = std::max(gap, -state.depth);
    }
    record_.penetration.push_back(penetration);
    record_.gaps.push_back(gap);
  }

  const Scene& scene_;
  const Setup& setup_;
  const Trajectory& trajectory_;
  double least_height_ = std::numeric_limits<double>::infinity();  ///< of a block, m
  GroundStep ground_;  ///< where the ground is, and how fast it has moved over the last step
  AppliedLoads loads_;
  std::vector<BodyLoad> last_loads_;  ///< over the step before the sample
  std::size_t samples_ = 0;
  std::vector<BlockPose> poses_, last_poses_;  ///< in the ground's frame, one a block
  std::vector<InterfaceState> interfaces_;     ///< of all samples
  BodyRecord record_;
};

}  // namespace

InterfaceState on_ground(const Block& block, const BlockPose& pose) {
  const Face ground{{}, std::numeric_limits<double>::infinity(), 1};
  const Face bottom = face_of(block, pose, -1);
  return {deepest_corner(ground, bottom), slip_of(ground, bottom, pose.angle < 0 ? -1 : 1)};
}

InterfaceState on_block(const Block& lower, const BlockPose& lower_pose, const Block& upper,
                        const BlockPose& upper_pose) {
  const Face top = face_of(lower, lower_pose, 1), bottom = face_of(upper, upper_pose, -1);
  const double leaning = upper_pose.angle < lower_pose.angle ? -1 : 1;
  return {std::max(deepest_corner(top, bottom), deepest_corner(bottom, top)), slip_of(top, bottom, leaning)};
}

std::vector<double> elastic_energy(const BodyRecord& record) {
  return record.contacts ? record.contacts->elastic : std::vector<double>(record.energy.size(), 0.0);
}

EngineRun engine_run_of(const Scene& scene, const Setup& setup, Trajectory trajectory, bool bodies) {
  EngineRun run;
  run.warnings = trajectory.warnings;
  run.history.blocks = static_cast<int>(scene.blocks.size());
  const std::size_t samples = trajectory.angles.size() / scene.blocks.size();
  for (std::size_t i = 0; i < samples; ++i) run.history.times.push_back(time_of(setup, trajectory, i));
  if (needs_bodies(scene, bodies)) {
    BodyAccount account(scene, setup, trajectory);
    for (std::size_t i = 0; i < samples; ++i) account.next();
    if (leaves_pivots(scene.law)) {
      run.history.slips = mapped(account.interfaces(), &InterfaceState::slip);
      run.history.gaps = mapped(account.interfaces(), [](const InterfaceState& at) { return -at.depth; });
      run.history.centres = account.record().centres;
    }
    if (bodies) run.bodies = account.record();
  }
  if (!trajectory.reactions.empty()) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    run.history.reactions.assign(scene.blocks.size(), {none, none, none});
    run.history.reactions.insert(run.history.reactions.end(), trajectory.reactions.begin(),
                                 trajectory.reactions.end());
  }
  if (run.bodies) run.bodies->contacts = std::move(trajectory.contacts);
  run.history.angles = std::move(trajectory.angles);
  run.history.velocities = std::move(trajectory.velocities);
  return run;
}

}  // namespace rockstack
