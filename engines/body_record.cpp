#include "engines/body_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engines/interface_state.hpp"
#include "engines/placement.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {
namespace {

/// Goes through the samples of a trajectory that tells its bodies.
class BodyAccount {
 public:
  BodyAccount(const Scene& scene, const Setup& setup, const Trajectory& trajectory)
      : scene_(scene), setup_(setup), trajectory_(trajectory) {
    record_.unsupported_since.assign(setup.blocks.size(), std::numeric_limits<double>::infinity());
  }

  void next() {
    ground_ = ground_at(samples_);
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
    add_energy(bodies, std::span(trajectory_.velocities).subspan(samples_ * blocks, blocks));
    add_interfaces();
    ++samples_;
  }

  const BodyRecord& record() const { return record_; }
  /// Of the last sample, in the ground's frame, one a block.
  const std::vector<BlockPose>& poses() const { return poses_; }
  const std::vector<InterfaceState>& interfaces() const { return interfaces_; }

 private:
  /// Where the ground is and how fast it has moved over the last step.
  GroundStep ground_at(std::size_t sample) const {
    if (sample == 0 || setup_.ground.empty()) return {};
    GroundStep ground = setup_.ground[sample - 1];
    ground.x += setup_.dt * ground.velocity_x;
    ground.y += setup_.dt * ground.velocity_y;
    return ground;
  }

  void add_energy(std::span<const BodyState> bodies, std::span<const double> velocities) {
    double energy = 0, work = 0, rest_height = 0;
    BodyAcceleration pull;
    const Gravity gravity = gravity_of(scene_);
    if (samples_ > 0 && is_shaken(scene_))
      pull = body_acceleration(scene_, static_cast<double>(samples_ - 1) * setup_.dt,
                               static_cast<double>(samples_) * setup_.dt);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const Block& block = scene_.blocks[k];
      const double along = bodies[k].velocity_x - ground_.velocity_x;
      const double up = bodies[k].velocity_y - ground_.velocity_y;
      rest_height += block.half_height;
      energy += 0.5 * block.mass * (along * along + up * up) +
                0.5 * block.inertia * velocities[k] * velocities[k] +
                block.mass * gravity.across * (poses_[k].y - rest_height) -
                block.mass * gravity.along * poses_[k].x;
      rest_height += block.half_height;
      if (samples_ == 0 || !is_shaken(scene_)) continue;
      work += block.mass * ((pull.x - gravity.along) * (poses_[k].x - last_poses_[k].x) +
                            (pull.y + gravity.across) * (poses_[k].y - last_poses_[k].y));
    }
    record_.energy.push_back(energy);
    record_.input.push_back(work + (record_.input.empty() ? 0 : record_.input.back()));
  }

  void add_interfaces() {
    const double time = static_cast<double>(samples_) * setup_.dt;
    double penetration = 0;
    interfaces_.clear();
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const Block& block = scene_.blocks[k];
      const InterfaceState& state =
          interfaces_.emplace_back(k == 0 ? on_ground(block, poses_[0])
                                          : on_block(scene_.blocks[k - 1], poses_[k - 1], block, poses_[k]));
      record_.slip = std::max(record_.slip, std::abs(state.slip));
      const bool supported = std::isfinite(state.depth);
      record_.unsupported_since[k] =
          supported ? std::numeric_limits<double>::infinity() : std::min(record_.unsupported_since[k], time);
      if (!supported) continue;
      penetration = std::max(penetration, state.depth);
      record_.gap = std::max(record_.gap, -state.depth);
    }
    record_.penetration.push_back(penetration);
  }

  const Scene& scene_;
  const Setup& setup_;
  const Trajectory& trajectory_;
  GroundStep ground_;
  std::size_t samples_ = 0;
  std::vector<BlockPose> poses_, last_poses_;
  std::vector<InterfaceState> interfaces_;
  BodyRecord record_;
};

void append_places(History& history, const BodyAccount& account) {
  for (const InterfaceState& state : account.interfaces()) {
    history.slips.push_back(state.slip);
    history.gaps.push_back(-state.depth);
  }
  for (const BlockPose& pose : account.poses())
    history.centres.insert(history.centres.end(), {pose.x, pose.y});
}

}  // namespace

std::vector<double> elastic_energy(const BodyRecord& record) {
  return record.contacts ? record.contacts->elastic : std::vector<double>(record.energy.size(), 0.0);
}

EngineRun account_of(const Scene& scene, const Setup& setup, Trajectory trajectory, bool bodies) {
  EngineRun run;
  run.warnings = trajectory.warnings;
  run.history.blocks = static_cast<int>(scene.blocks.size());
  const std::size_t samples = trajectory.angles.size() / scene.blocks.size();
  for (std::size_t i = 0; i < samples; ++i) run.history.times.push_back(static_cast<double>(i) * setup.dt);
  if (needs_bodies(scene, bodies)) {
    BodyAccount account(scene, setup, trajectory);
    for (std::size_t i = 0; i < samples; ++i) {
      account.next();
      if (leaves_pivots(scene.law)) append_places(run.history, account);
    }
    if (bodies) run.bodies = account.record();
  }
  if (run.bodies) run.bodies->contacts = std::move(trajectory.contacts);
  run.history.angles = std::move(trajectory.angles);
  run.history.velocities = std::move(trajectory.velocities);
  return run;
}

EngineRun simulate(const Engine& engine, const Scene& scene, double dt, const Parameters& parameters,
                   bool bodies) {
  const Setup setup = set_up(scene, dt, parameters);
  return account_of(scene, setup, run(engine, setup, parameters, needs_bodies(scene, bodies)), bodies);
}

}  // namespace rockstack
