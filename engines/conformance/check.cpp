#include "engines/conformance/check.hpp"

#include <algorithm>

namespace rockstack {

const std::vector<Check>& checks() {
  static const std::vector<Check> list{
      {"InitialStateIsTheScenes", initial_state_is_the_scenes},
      {"SameRunGivesTheSameBits", same_run_gives_the_same_bits},
      {"HistoryEndsWhereABlockTopples", history_ends_where_a_block_topples},
      {"FreeFallIsTheSchemes", free_fall_is_the_schemes},
      {"FirstStepIsFreeFallOrAHinge", first_step_is_free_fall_or_a_hinge},
      {"BlockAtRestStays", block_at_rest_stays},
      {"StackAtRestStays", stack_at_rest_stays},
      {"StackKeepsItsHeight", stack_keeps_its_height},
      {"PushedBlockDoesNotSlide", pushed_block_does_not_slide},
      {"SlidingBlockStops", sliding_block_stops},
      {"EachInterfaceHasItsFriction", each_interface_has_its_friction},
      {"WithoutFrictionBlocksSlideOn", without_friction_blocks_slide_on},
      {"WeakPushDoesNotRock", weak_push_does_not_rock},
      {"StrongPushRocks", strong_push_rocks},
      {"MirroredSceneMirrorsMotion", mirrored_scene_mirrors_motion},
      {"FallingGroundIsWeakerGravity", falling_ground_is_weaker_gravity},
      {"QuarterPeriodIsHousners", quarter_period_is_housners},
      {"QuarterPeriodErrorIsOfFirstOrder", quarter_period_error_is_of_first_order},
      {"ImpactLosesHousnersShare", impact_loses_housners_share},
      {"FlatLandingDoesNotBounce", flat_landing_does_not_bounce},
      {"TopplesFromItsSlenderness", topples_from_its_slenderness},
      {"PairKeepsItsMomentum", pair_keeps_its_momentum},
      {"PairMeetsTheGroundInTime", pair_meets_the_ground_in_time},
      {"MotionStaysInThePlane", motion_stays_in_the_plane},
  };
  return list;
}

const Check& find_check(const std::string& name) {
  return *std::find_if(checks().begin(), checks().end(),
                       [&](const Check& check) { return check.name == name; });
}

}  // namespace rockstack
