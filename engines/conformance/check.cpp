#include "engines/conformance/check.hpp"

#include <iterator>
#include <sstream>
#include <utility>

#include "rockstack_conformance_texts.hpp"

namespace rockstack {
namespace {

/// Whether words have this one or * among them.
bool fits(const std::string& words, const std::string& word) {
  std::istringstream each(words);
  return std::any_of(std::istream_iterator<std::string>(each), {},
                     [&](const std::string& one) { return one == "*" || one == word; });
}

}  // namespace

Scene at_rest(std::vector<Block> blocks, double duration) {
  Scene scene;
  scene.duration = duration;
  scene.initial.angles = scene.initial.velocities = std::vector<double>(blocks.size());
  scene.blocks = std::move(blocks);
  return scene;
}

Scene slender_block(double duration) {
  Scene scene = at_rest({make_block(0.4, 2, 2500)}, duration);
  scene.initial.angles = {0.5 * std::atan(0.2)};
  return scene;
}

Scene paper_scene(double duration) {
  Scene scene = at_rest({make_block(1.25, 1.25, 2500), make_block(1, 2.5, 2500)}, duration);
  scene.initial.angles = {0.15, 0.15};
  return scene;
}

ObservedMotion run(const Adapter& adapter, const Scene& scene, double dt) {
  Setup setup = set_up(scene, dt, adapter.parameters);
  setup.lookahead = lookahead(dt, adapter.lead);
  Trajectory trajectory = adapter.run(setup, adapter.parameters);
  std::vector<BodyState> bodies = trajectory.bodies;
  return {engine_run_of(scene, setup, std::move(trajectory), false).history, std::move(bodies)};
}

CheckWork work_of(const Check& check, Adapter adapter) {
  CheckWork work;
  adapter.run = [&](const Setup& setup, const Parameters&) {
    ++work.runs;
    work.block_steps += setup.steps * setup.blocks.size();
    Trajectory still;
    for (std::size_t sample = 0; sample <= setup.steps; ++sample)
      for (const Placement& block : setup.blocks) {
        still.angles.push_back(block.angle);
        still.velocities.push_back(0);
        still.bodies.push_back({.x = block.x, .y = block.y});
      }
    return still;
  };
  check.judge(adapter);
  return work;
}

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
      {"RestingBlockPressesWithItsWeight", resting_block_presses_with_its_weight},
      {"BlockOnASlopePressesByItsTilt", block_on_a_slope_presses_by_its_tilt},
      {"SlidingBlockRubsByItsFriction", sliding_block_rubs_by_its_friction},
      {"PivotBearsATurningBlock", pivot_bears_a_turning_block},
      {"ForcesAreWhatMovesTheBlocks", forces_are_what_moves_the_blocks},
      {"EccentricBlockFallsAsItTurns", eccentric_block_falls_as_it_turns},
      {"EccentricBlockRocksBothWays", eccentric_block_rocks_both_ways},
      {"EccentricBlockLandsInTime", eccentric_block_lands_in_time},
      {"EccentricBlockBearsOffItsMiddle", eccentric_block_bears_off_its_middle},
      {"PushMovesAndTurnsABlock", push_moves_and_turns_a_block},
      {"BlockSwingsOnTendons", block_swings_on_tendons},
      {"DamperSlowsABlock", damper_slows_a_block},
      {"TendonYieldsAndGoesSlack", tendon_yields_and_goes_slack},
  };
  return list;
}

std::string known_limit(const std::string& engine, const std::string& solver, const std::string& settings,
                        const std::string& check) {
  std::istringstream text{std::string(limits_txt)};
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream whose(line);
    std::string engines, solvers, sets, reason, checks;
    for (std::string* part : {&engines, &solvers, &sets}) std::getline(whose, *part, '|');
    std::getline(text, reason);
    while (std::getline(text, line) && !line.empty()) checks += line + " ";
    if (fits(engines, engine) && fits(solvers, solver) && fits(sets, settings) && fits(checks, check))
      return reason;
  }
  return "";
}

}  // namespace rockstack
