#pragma once

#include "analytic/round/rolling.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Which of two derivations is solved.
enum class RollingEquations {
  angles,  ///< of rolling.hpp
  axis,    ///< of the vector of the axis, axis.hpp
};

/// Where a column moves.
enum class RoundRoom {
  space,
  plane,  ///< held in that of x and z: a block with the section and the inertia of the cylinder
};

/// A uniform cylinder on level ground that rolls on its rim without slip, how it starts, and how the ground
/// moves. SI units.
struct RoundScene {
  std::string title;
  double duration = 0;            ///< s, > 0
  double gravity = 9.81;          ///< m/s², > 0
  double radius = 0, height = 0;  ///< r and 2h, m, > 0
  RollingEquations equations = RollingEquations::angles;
  RoundRoom room = RoundRoom::space;
  // At t = 0. A column without tilt stands until the ground lifts it; it has no rates.
  double tilt = 0;       ///< of the axis from the vertical, towards x, rad, from 0 to the toppling angle
  double tilt_rate = 0;  ///< θ̇, rad/s
  double precession = 0, spin = 0;  ///< ψ̇, and ω₃ along the axis, rad/s
  bool steady = false;     ///< ψ̇ and ω₃ are those of steady precession about a centre of mass at rest
  double scale = 1;        ///< that x, y and z have been multiplied by
  GroundMotion x, y, z{};  ///< accelerations of the ground, z up, without steps of the velocity

  Cylinder body() const { return {radius, height / 2, gravity}; }
};

/// What happens on the way.
enum class RoundEvent {
  lift,     ///< a column that stands starts to roll
  peak,     ///< the tilt is largest
  passage,  ///< the tilt is least, above zero: the contact point runs around the rim
  impact,   ///< in a plane: the base lands flat
  rest,     ///< in a plane: the column stands again
  topple,   ///< the tilt passes the toppling angle; the motion ends
};
inline constexpr std::array round_events{"lift", "peak", "passage", "impact", "rest", "topple"};

/// The state at a time.
struct RoundState {
  double time = 0;            ///< s
  Rolling<double> rolling{};  ///< ψ from x
  Support support{1, 0};
  double energy = 0;  ///< kinetic and potential, over the mass, J/kg
};

struct RoundMotion {
  std::vector<RoundState> samples;  ///< at the times that were asked for, up to the end
  std::vector<std::pair<RoundEvent, RoundState>> events;
  double largest_tilt = 0;        ///< rad
  Support demand{1, 0};           ///< least normal force and most friction, at steps, samples and events
  std::optional<double> toppled;  ///< when, s
};

/// What is felt at a time.
inline Felt<double> felt_at(const RoundScene& scene, double time) {
  return {acceleration(scene.x, time), acceleration(scene.y, time),
          acceleration(scene.z, time) + scene.gravity};
}

/// Whether the column topples, or at the end is past its balance and turns on.
inline bool topples(const RoundScene& scene, const RoundMotion& motion) {
  if (motion.toppled) return true;
  const Rolling<double>& last = motion.samples.back().rolling;
  return last.tilt > scene.body().slenderness() && last.tilt_rate > 0;
}

}  // namespace rockstack
