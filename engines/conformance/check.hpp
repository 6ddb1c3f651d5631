#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engines/body_record.hpp"
#include "engines/engine.hpp"
#include "engines/trajectory.hpp"

namespace rockstack {

/// An engine, wherever it runs, with the parameters that it is to be judged by.
struct Adapter {
  bool single_precision = false;
  double lead = 0.5;  ///< as Capabilities have it, of these parameters
  Parameters parameters;
  /// Runs a scene and tells its bodies. @throws the engine's own error.
  std::function<Trajectory(const Setup&, const Parameters&)> run;
};

/// What a check found: a measured number and what it may be at most.
struct Judgement {
  double value = 0;
  double limit = 0;
  std::string what;  ///< of the value, with its unit
  bool holds() const { return value <= limit; }
};

/// A law that every engine must follow, as a function, so that an adapter broken on purpose can be held to it
/// as well.
struct Check {
  const char* name;
  Judgement (*judge)(const Adapter&);
};

/// All of them: promises, smooth motion, contact, and planar motion of one block and of pairs.
const std::vector<Check>& checks();

/// The check of that name. Precondition: it is there.
const Check& find_check(const std::string& name);

// Under a constant acceleration the place after time t is that at t + lead × dt, less a constant of order
// dt²: semi-implicit Euler's is half a step ahead. A contact is found at most a step late.

Judgement initial_state_is_the_scenes(const Adapter& adapter);
Judgement same_run_gives_the_same_bits(const Adapter& adapter);
Judgement history_ends_where_a_block_topples(const Adapter& adapter);
Judgement free_fall_is_the_schemes(const Adapter& adapter);
Judgement first_step_is_free_fall_or_a_hinge(const Adapter& adapter);
Judgement block_at_rest_stays(const Adapter& adapter);
Judgement stack_at_rest_stays(const Adapter& adapter);
Judgement stack_keeps_its_height(const Adapter& adapter);
Judgement pushed_block_does_not_slide(const Adapter& adapter);
Judgement sliding_block_stops(const Adapter& adapter);
Judgement each_interface_has_its_friction(const Adapter& adapter);
Judgement without_friction_blocks_slide_on(const Adapter& adapter);
Judgement weak_push_does_not_rock(const Adapter& adapter);
Judgement strong_push_rocks(const Adapter& adapter);
Judgement mirrored_scene_mirrors_motion(const Adapter& adapter);
Judgement falling_ground_is_weaker_gravity(const Adapter& adapter);
Judgement quarter_period_is_housners(const Adapter& adapter);
Judgement quarter_period_error_is_of_first_order(const Adapter& adapter);
Judgement impact_loses_housners_share(const Adapter& adapter);
Judgement flat_landing_does_not_bounce(const Adapter& adapter);
Judgement topples_from_its_slenderness(const Adapter& adapter);
Judgement pair_keeps_its_momentum(const Adapter& adapter);
Judgement pair_meets_the_ground_in_time(const Adapter& adapter);
Judgement motion_stays_in_the_plane(const Adapter& adapter);

}  // namespace rockstack
