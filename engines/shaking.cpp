#include "engines/shaking.hpp"

namespace rockstack {

Shaking::Shaking(const Scene& scene, double dt, const Parameters& parameters) : scene_(scene), dt_(dt) {
  if (is_shaken(scene) && parameters.at("shaking") != 0) path_.emplace(scene, dt);
}

ShakingStep Shaking::next() {
  if (path_) return {path_->next(), {}};
  if (!is_shaken(scene_)) return {};
  const double start = static_cast<double>(steps_) * dt_;
  ++steps_;
  return {{}, body_acceleration(scene_, start, static_cast<double>(steps_) * dt_)};
}

}  // namespace rockstack
