#pragma once

#include <functional>

#include "analytic/scene/scene.hpp"
#include "engines/engine.hpp"

namespace rockstack {

/// Bottom to top: pivots touch where they have no gap, centres move as the initial state has them.
std::vector<Placement> place(const Scene& scene);

/// How the ground moves under a scene's accelerations, from rest at t = 0: displacements are their double
/// integral, exact for straight lines between samples and by Gauss's rule with five points for pulses: to
/// rounding for steps of up to a fifth of their period. Precondition: dt > 0, in s. @throws as set_up().
std::vector<GroundStep> ground_path(const Scene& scene, double dt, std::size_t steps,
                                    const std::function<bool()>* cancelled = nullptr);

/// Gravity alone, in the axes of the ground.
BodyAcceleration body_acceleration(const Scene& scene);

/// Gravity less the mean ground acceleration over [from, to], from < to.
BodyAcceleration body_acceleration(const Scene& scene, double from, double to);

/// True where a ground motion makes body_acceleration() change with time.
inline bool is_shaken(const Scene& scene) {
  return !scene.horizontal.empty() || !scene.vertical.empty();
}

/// The parameters of a run: those given, with the scene's coefficient of restitution in the place of the
/// engine's own where points bounce, and the least threshold below which they do not.
Parameters with_restitution(const EngineDescription& engine, const Scene& scene, Parameters parameters);

/// @throws std::runtime_error where points bounce and the engine has no coefficient for it, where a centre of
/// mass is off the middle and its bodies have theirs there, or where forces act on blocks and it applies
/// none.
void require_able(const EngineDescription& engine, const Scene& scene);

/// The wall at a side of a block as it stands, −1 left, 1 right: flush with it, twice as high and as thick.
FixedBox place_wall(const Placement& block, int side);

/// @throws std::runtime_error where a scene has a wall and the engine is told of none.
void require_wall(const EngineDescription& engine, const Scene& scene);

/// Steps of dt in a duration, both in s; one that is whole up to rounding counts.
double step_count(double duration, double dt);

/// True where the setting `shaking` asks for a ground that really moves.
bool moves_ground(const Parameters& parameters);

/// A scene, shaken in the way that the setting `shaking` asks for, as an engine is told it; dt in s.
/// `cancelled` is asked now and then where steps are many.
/// @throws std::invalid_argument as check_step(); Stopped where cancelled.
Setup set_up(const Scene& scene, double dt, const Parameters& parameters,
             const std::function<bool()>* cancelled = nullptr);

/// @throws std::invalid_argument for a step that a duration holds less than once, or over 10⁹ times. In s.
void check_step(double dt, double duration);

}  // namespace rockstack
