#pragma once

#include <string>
#include <vector>

#include "engines/engine.hpp"

namespace rockstack {

/// An engine with the parameters that it is to be judged by.
struct Adapter {
  const Engine* engine;
  Parameters parameters;
};

/// What a check found: a measured number and what it may be at most.
struct Verdict {
  double value = 0;
  double limit = 0;
  std::string what;  ///< of the value, with its unit
  bool holds() const { return value <= limit; }
};

/// A law that every engine must follow, as a function, so that an adapter broken on purpose can be held to it
/// as well.
struct Check {
  const char* name;
  Verdict (*judge)(const Adapter&);
};

/// All of them: smooth motion, contact, and planar motion of one block and of pairs.
const std::vector<Check>& checks();

/// The check of that name. Precondition: it is there.
const Check& find_check(const std::string& name);

// Engines step by semi-implicit Euler: under a constant acceleration the position after time t is that at t +
// dt/2, less a constant of order dt². So smooth motion is half a step ahead, and a contact is found at most a
// step late.

Verdict free_fall_is_the_schemes(const Adapter& adapter);
Verdict first_step_is_free_fall_or_a_hinge(const Adapter& adapter);
Verdict block_at_rest_stays(const Adapter& adapter);
Verdict stack_at_rest_stays(const Adapter& adapter);
Verdict pushed_block_does_not_slide(const Adapter& adapter);
Verdict sliding_block_stops(const Adapter& adapter);
Verdict each_interface_has_its_friction(const Adapter& adapter);
Verdict without_friction_blocks_slide_on(const Adapter& adapter);
Verdict weak_push_does_not_rock(const Adapter& adapter);
Verdict strong_push_rocks(const Adapter& adapter);
Verdict mirrored_scene_mirrors_motion(const Adapter& adapter);
Verdict falling_ground_is_weaker_gravity(const Adapter& adapter);
Verdict quarter_period_is_housners(const Adapter& adapter);
Verdict quarter_period_error_is_of_first_order(const Adapter& adapter);
Verdict impact_loses_housners_share(const Adapter& adapter);
Verdict flat_landing_does_not_bounce(const Adapter& adapter);
Verdict topples_from_its_slenderness(const Adapter& adapter);
Verdict pair_keeps_its_momentum(const Adapter& adapter);
Verdict pair_meets_the_ground_in_time(const Adapter& adapter);
Verdict motion_stays_in_the_plane(const Adapter& adapter);

}  // namespace rockstack
