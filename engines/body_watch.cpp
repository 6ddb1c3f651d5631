#include "engines/body_watch.hpp"

#include <algorithm>
#include <cmath>

#include "engines/placement.hpp"

namespace rockstack {

BodyWatch::BodyWatch(const Scene& scene, double dt, bool ground_moves, const std::vector<double>& friction,
                     Simulation& simulation)
    : scene_(scene), simulation_(simulation), dt_(dt) {
  if (ground_moves && is_shaken(scene)) path_.emplace(scene, dt);
  if (simulation.watch_contacts()) contacts_.emplace(scene, dt, friction);
}

void BodyWatch::observe(std::span<const double> angles, std::span<const double> velocities) {
  if (samples_ > 0) follow_ground();
  std::vector<BodyState> bodies;
  last_poses_ = std::move(poses_);
  poses_.clear();
  for (std::size_t k = 0; k < scene_.blocks.size(); ++k) {
    const BodyState& body = bodies.emplace_back(simulation_.body(k));
    poses_.push_back({body.x - ground_.x, body.y - ground_.y, angles[k]});
    record_.out_of_plane = std::max(record_.out_of_plane, std::abs(body.z));
    record_.out_of_plane_tilt = std::max(record_.out_of_plane_tilt, body.tilt);
  }
  add_energy(bodies, velocities);
  add_interfaces();
  if (contacts_) {
    contacts_->observe(simulation_.contacts(), angles, velocities, record_);
  } else {
    record_.elastic.push_back(0);
  }
  ++samples_;
}

void BodyWatch::follow_ground() {
  if (!path_) return;
  ground_ = path_->next();
  ground_.x += dt_ * ground_.velocity_x;
  ground_.y += dt_ * ground_.velocity_y;
}

void BodyWatch::add_energy(const std::vector<BodyState>& bodies, std::span<const double> velocities) {
  double energy = 0, work = 0, rest_height = 0;
  BodyAcceleration pull;
  const Gravity gravity = gravity_of(scene_);
  if (samples_ > 0 && is_shaken(scene_))
    pull = body_acceleration(scene_, static_cast<double>(samples_ - 1) * dt_,
                             static_cast<double>(samples_) * dt_);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Block& block = scene_.blocks[k];
    const double along = bodies[k].velocity_x - ground_.velocity_x;
    const double up = bodies[k].velocity_y - ground_.velocity_y;
    rest_height += block.half_height;
    energy +=
        0.5 * block.mass * (along * along + up * up) + 0.5 * block.inertia * velocities[k] * velocities[k] +
        block.mass * gravity.across * (poses_[k].y - rest_height) - block.mass * gravity.along * poses_[k].x;
    rest_height += block.half_height;
    if (samples_ == 0 || !is_shaken(scene_)) continue;
    work += block.mass * ((pull.x - gravity.along) * (poses_[k].x - last_poses_[k].x) +
                          (pull.y + gravity.across) * (poses_[k].y - last_poses_[k].y));
  }
  record_.energy.push_back(energy);
  record_.input.push_back(work + (record_.input.empty() ? 0 : record_.input.back()));
}

void BodyWatch::add_interfaces() {
  double penetration = 0;
  interfaces_.clear();
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    const Block& block = scene_.blocks[k];
    const InterfaceState& state =
        interfaces_.emplace_back(k == 0 ? on_ground(block, poses_[0])
                                        : on_block(scene_.blocks[k - 1], poses_[k - 1], block, poses_[k]));
    record_.slip = std::max(record_.slip, std::abs(state.slip));
    if (!std::isfinite(state.depth)) continue;
    penetration = std::max(penetration, state.depth);
    record_.gap = std::max(record_.gap, -state.depth);
  }
  record_.penetration.push_back(penetration);
}

}  // namespace rockstack
