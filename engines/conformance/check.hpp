#pragma once

#include "analytic/scene/lists.hpp"
#include "engines/body_record.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {

/// An engine, wherever it runs, with the parameters that it is to be judged by.
struct Adapter {
  bool single_precision = false;
  bool center_of_mass = false;  ///< as Capabilities have it
  bool applied_forces = false;  ///< likewise
  double lead = 0.5;            ///< as Capabilities have it, of these parameters
  Parameters parameters;
  /// Runs a scene and tells its bodies, and what interfaces bear where it can. @throws the engine's own
  /// error.
  std::function<Trajectory(const Setup&, const Parameters&)> run;
};

/// What a check found: a measured number and what it may be at most.
struct Judgement {
  double value = 0, limit = 0;
  std::string what;  ///< of the value, with its unit
  bool holds() const { return value <= limit; }
};

/// A law that every engine must follow; a function, so that adapters broken on purpose can be held to it too.
using Judge = Judgement(const Adapter& adapter);

struct Check {
  const char* name;
  Judge* judge;
};

inline constexpr double usual_step = 1e-3;  ///< of most checks, s

/// Said of an engine that there is nothing to judge by.
inline constexpr const char* tells_no_forces = "the engine tells no forces";

Scene at_rest(std::vector<Block> blocks, double duration);

/// Samples `value` from t = 0 on, m/s².
inline GroundMotion constant(double value) {
  return {.interval = 10, .samples = {value, value}};
}

/// A block of slenderness atan(0.2), released at half its slenderness.
Scene slender_block(double duration);

/// Spanos et al. 2001, free rocking.
Scene paper_scene(double duration);

/// What an engine made of a scene, with its bodies.
struct ObservedMotion {
  History history;
  std::vector<BodyState> bodies;  ///< sample by sample, in each from the lowest block up

  const BodyState& body(std::size_t sample, std::size_t block) const {
    return bodies[sample * static_cast<std::size_t>(history.blocks) + block];
  }
};

ObservedMotion run(const Adapter& adapter, const Scene& scene, double dt = usual_step);

/// Adapter that is shaken by a body force.
inline Adapter by_force(Adapter adapter) {
  if (adapter.parameters.count("shaking") != 0) adapter.parameters["shaking"] = 0;
  return adapter;
}

/// Unit round-off of the engine's own numbers.
inline double rounding(const Adapter& adapter) {
  return adapter.single_precision ? std::numeric_limits<float>::epsilon()
                                  : std::numeric_limits<double>::epsilon();
}

/// The shortest step at which gravity's share of a step stands clear of rounding, s.
inline double short_step(const Adapter& adapter) {
  return rounding(adapter) > 1e-10 ? 1e-3 : 1e-4;
}

/// What a check asks of an engine: runs, and time steps of single blocks.
struct CheckWork {
  std::size_t runs = 0, block_steps = 0;
};

/// The work of a check with an adapter's parameters, as far as it is known before: that of blocks that stay
/// where they start.
CheckWork work_of(const Check& check, Adapter adapter);

/// All of them: promises, smooth motion, contact, planar motion of one block and of pairs, forces, a centre
/// of mass off the middle, pushes and restraints.
const std::vector<Check>& checks();

// Under a constant acceleration the place after time t is that at t + lead × dt, less a constant of order
// dt²: semi-implicit Euler's is half a step ahead. A contact is found at most a step late.

Judge initial_state_is_the_scenes, same_run_gives_the_same_bits, history_ends_where_a_block_topples,
    free_fall_is_the_schemes, first_step_is_free_fall_or_a_hinge, block_at_rest_stays, stack_at_rest_stays,
    stack_keeps_its_height, pushed_block_does_not_slide, sliding_block_stops, each_interface_has_its_friction,
    without_friction_blocks_slide_on, weak_push_does_not_rock, strong_push_rocks,
    mirrored_scene_mirrors_motion, falling_ground_is_weaker_gravity, quarter_period_is_housners,
    quarter_period_error_is_of_first_order, impact_loses_housners_share, flat_landing_does_not_bounce,
    topples_from_its_slenderness, pair_keeps_its_momentum, pair_meets_the_ground_in_time,
    motion_stays_in_the_plane, resting_block_presses_with_its_weight, block_on_a_slope_presses_by_its_tilt,
    sliding_block_rubs_by_its_friction, pivot_bears_a_turning_block, forces_are_what_moves_the_blocks,
    eccentric_block_falls_as_it_turns, eccentric_block_rocks_both_ways, eccentric_block_lands_in_time,
    eccentric_block_bears_off_its_middle, push_moves_and_turns_a_block, block_swings_on_tendons,
    damper_slows_a_block, tendon_yields_and_goes_slack;

/// Why an engine with one of its solvers and a parameter set cannot pass a check, or an empty text.
std::string known_limit(const std::string& engine, const std::string& solver, const std::string& settings,
                        const std::string& check);

}  // namespace rockstack
