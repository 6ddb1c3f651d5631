#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {
namespace {

Column plain(const char* name, Column::Field field, const char* definition) {
  return {name, definition, field};
}

Column measured(const char* name, Column::Field field, const char* definition) {
  return {.name = name, .definition = definition, .field = field, .measured = true};
}

/// Of a number that every replicate has its own of: their median, and where they have columns its quartiles.
Column median(const char* name, Column::Field field, const char* definition,
              const std::optional<Column::Field>& lower = {},
              const std::optional<Column::Field>& upper = {}) {
  return {name, definition, field, false, true, lower, upper};
}

/// With the columns of quartiles behind the one that they are of.
std::vector<Column> with_quartiles(const std::vector<Column>& list) {
  std::vector<Column> all;
  for (const Column& one : list) {
    all.push_back(one);
    if (!one.lower) continue;
    all.push_back({one.name + "_lower", "lower quartile of the same over replicates", *one.lower});
    all.push_back({one.name + "_upper", "upper quartile", *one.upper});
  }
  return all;
}

using M = RunMetrics;

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> list = with_quartiles({
      // Which run it is, and how it ended.
      plain("run", &M::run, "name of the run, and of its folder under runs/"),
      plain("scene", &M::scene, "name of the scene"),
      plain("law", &M::law,
            "which pattern follows an impact, in the exact solution that the row is held against; of "
            "another exact solution its own"),
      plain("engine", &M::engine, "\"exact\", or the engine's name"),
      plain("solver", &M::solver, "integrator of the exact solver, or the engine's constraint solver"),
      plain("settings", &M::settings,
            "the engine's parameter set: default is what a user gets who sets nothing but friction and "
            "restitution; tuned suits this problem best"),
      plain("dt", &M::dt, "time step, s; for the exact solver the longest"),
      plain("status", &M::status,
            "done; or what kept the run from it: failed (an error that the engine or the solver reports), "
            "not finite (an angle or velocity), signal (the engine's process was ended, as by an "
            "assertion), time limit or memory limit"),
      plain("reason", &M::reason, "why a run is not done"),
      plain(
          "outcome", &M::outcome,
          "what becomes of the run, in words: until when it agrees, and what else happens in it; of the exact "
          "motion, why it need not be the one that follows"),
      plain("steps", &M::steps,
            "time steps that the engine made; fewer than the duration holds where a block toppled"),
      plain("draws", &M::replicates,
            "how many runs the numbers of the motion are medians of: the one at this step, and others at "
            "steps and of scenes that hardly differ (draws.csv in the run's folder, spread.csv); empty "
            "where it is one"),
      plain("draws_failed", &M::replicates_failed, "how many of them failed"),
      plain("draws_other_verdict", &M::replicates_other_verdict,
            "in how many of them one of both topples alone, engine or exact solution"),
      plain("horizon", &M::horizon,
            "up to when histories can be compared, s: the first time at which the exact motion of one of "
            "twenty scenes that differ in the sixth digit is further than the tolerance from the scene's "
            "own; the duration where none ever is. Differences of angles and slips, impacts, settlings, "
            "patterns and parts are of the time up to the horizon; after it histories part by nature. Of "
            "the whole scene are energy, overlap, gap, slip, residual motion and toppling"),
      // What it cost.
      measured("stepping_time_minimum", &M::stepping_time_minimum,
               "least wall time of stepping alone (for the exact solver: of solving), over the repeats, s"),
      measured("stepping_time_median", &M::stepping_time_median, "median of the same times, s"),
      measured("stepping_time_spread", &M::stepping_time_spread,
               "largest less smallest of the same times, s"),
      plain("repeats", &M::repeats, "timed runs, after a warm-up that is not counted"),
      measured("runs_at_a_time", &M::runs_at_a_time,
               "how many runs of the comparison shared the machine while this one was timed; only with 1 "
               "are times to be compared"),
      measured("timed_cold", &M::timed_cold,
               "1 where the engine's runtime had taken fewer steps, before the first timed run, than it "
               "says that it needs to be warm; such times are not to be compared"),
      measured("real_time_factor", &M::real_time_factor,
               "seconds of motion for one second of the least wall time of stepping"),
      measured("exact_sampled_time", &M::exact_sampled_time,
               "least wall time of the exact solver giving as many samples as the engine, over the same "
               "repeats, s; the exact row's times are of solving without samples"),
      measured("processor_time", &M::processor_time,
               "user and system time of the engine's process, as the operating system accounts for it: the "
               "run that gives the history, all timed runs, building and reading, s"),
      measured("peak_memory", &M::peak_memory,
               "largest resident memory of the engine's process, the history included, bytes"),
      // How far the motion is off.
      median("largest_angle_difference", &M::largest_angle_difference,
             "largest absolute difference of any block's angle, at the engine's own times up to the horizon, "
             "rad",
             &M::largest_angle_difference_lower, &M::largest_angle_difference_upper),
      median("rms_angle_difference", &M::rms_angle_difference,
             "root of the mean square of that difference over all times up to the horizon and all blocks, "
             "rad",
             &M::rms_angle_difference_lower, &M::rms_angle_difference_upper),
      median("largest_position_difference", &M::largest_position_difference,
             "largest distance of a block's centre of mass from the exact one, up to the horizon, m"),
      median("rms_position_difference", &M::rms_position_difference,
             "root of the mean square of that distance over all times up to the horizon and all blocks, m",
             &M::rms_position_difference_lower, &M::rms_position_difference_upper),
      median("relative_position_difference", &M::relative_position_difference,
             "the largest distance of a centre as a share of the least block height"),
      median("error", &M::error,
             "what rows are ranked by: the RMS angle difference (rad), or the RMS distance of centres as a "
             "share of the least block height, whichever is larger",
             &M::error_lower, &M::error_upper),
      plain("rank", &M::rank,
            "one more than there are rows of engines, of this scene and step, that are nearer and that a "
            "test of replicates tells from this one (ranking_definition in comparison.json); empty where "
            "nothing moves"),
      plain("motion", &M::motion,
            "how far the exact motion goes up to the horizon: the largest change of an angle (rad), or the "
            "longest way of a centre as a share of the least block height, whichever is larger; 0 where the "
            "scene is at rest and angles tell nothing apart"),
      median("peak_angle", &M::peak_angle, "largest absolute angle of any block over the whole scene, rad"),
      median("exact_peak_angle", &M::exact_peak_angle, "likewise of the exact motion"),
      median("relative_angle_difference", &M::relative_angle_difference,
             "the largest angle difference as a share of the largest exact angle of any block up to the "
             "horizon"),
      median("magnitude_error", &M::magnitude_error,
             "amplitude part of the difference, blind to delay: root of the engine's mean square angle over "
             "the exact one, less 1 (Sprague & Geers 2003)"),
      median("phase_error", &M::phase_error,
             "phase part, blind to amplitude: angle between both histories as vectors of all samples and "
             "blocks, as a share of half a turn (Sprague & Geers 2003); 0 in step, 1 in opposition"),
      median("second_peak_difference", &M::second_peak_difference,
             "peak of the top block in its second swing, after its angle first changed sign, less the exact "
             "one, as a share of the exact one"),
      median("agreement_time", &M::agreement_time,
             "time until which no angle differs by more than the tolerance; the horizon where none does "
             "before, s",
             &M::agreement_time_lower, &M::agreement_time_upper),
      median("position_agreement_time", &M::position_agreement_time,
             "time until which no centre is further off than the tolerance times the least block height; the "
             "horizon where none is before, s"),
      median(
          "rms_test_difference", &M::rms_test_difference,
          "root of the mean square, over readings up to the horizon, of the motion less the test's, rad or m"),
      // Impacts, settlings and patterns.
      median(
          "first_impact_time_difference", &M::first_impact_time_difference,
          "time of the engine's first impact at the interface that impacts first, less the exact one's, s"),
      median("impacts", &M::impacts, "impacts above the chatter speed over the whole scene"),
      plain("slower_impacts", &M::slower_impacts, "impacts of the exact motion below the chatter speed"),
      median("impacts_matched", &M::impacts_matched,
             "impacts above the chatter speed that both have, in order at the same interface, not leaving to "
             "opposite sides, and no further apart than the window: three steps and the drift, which is "
             "twice the angle difference just before over the speed of closing, but never more than half way "
             "to the next impact of the interface. An impact leaves to a side where the interface's relative "
             "angular velocity after it is at least the chatter speed"),
      median("impacts_missed", &M::impacts_missed,
             "exact impacts above the chatter speed, up to the horizon, that the engine does not have"),
      median("impacts_extra", &M::impacts_extra,
             "engine impacts above the chatter speed that the exact solution does not have"),
      median("impacts_matched_null", &M::impacts_matched_null,
             "the sampling limit: of the exact motion itself, sampled at the engine's steps and read as an "
             "engine's, within three steps"),
      median("impacts_missed_null", &M::impacts_missed_null, "likewise missed"),
      median("impacts_extra_null", &M::impacts_extra_null, "likewise extra"),
      median("impacts_matched_random", &M::impacts_matched_random,
             "the chance level: how many match of as many impacts at random times, within the same windows; "
             "median of 101"),
      median("impacts_matched_shifted", &M::impacts_matched_shifted,
             "likewise of the engine's own impacts, all shifted by the same time, a tenth of the duration to "
             "nine tenths"),
      median("rms_impact_time_difference", &M::rms_impact_time_difference,
             "root of the mean square time difference of the matched impacts, s"),
      median("largest_impact_time_difference", &M::largest_impact_time_difference,
             "largest absolute time difference of the matched impacts, s"),
      median("settlings_matched", &M::settlings_matched,
             "settlings that both have, within the settling duration, 0.1 sqrt(H/g). All chatter of an "
             "interface is one settling: the interface comes to stay within 2 mrad of closed, slower than "
             "the chatter speed, for at least the settling duration"),
      median("settlings_missed", &M::settlings_missed, "exact settlings that the engine does not have"),
      median("settlings_extra", &M::settlings_extra,
             "engine settlings that the exact solution does not have"),
      median("slip_error", &M::slip_error,
             "largest difference of how far a block has slipped along what is below it, of all blocks that "
             "touch that in the exact solution and all times, m; law unilateral alone"),
      median("final_slip_error", &M::final_slip_error,
             "likewise at the last time that both cover, m; empty where no block touches then"),
      median("pattern_agreement", &M::pattern_agreement,
             "share of time in which the engine is in the exact pattern. An interface is closed while it "
             "stays within 2 mrad for at least the settling duration, and open to one side else; likewise "
             "for the exact solution, at the same times. patterns.csv holds the share of time of each pair "
             "of patterns"),
      median("pattern_sequence_time", &M::pattern_sequence_time,
             "time until which both pass through the same patterns in the same order; the horizon where they "
             "do up to there, s"),
      // What bodies and contacts do.
      median("energy_gain", &M::energy_gain,
             "largest rise of the blocks' kinetic and potential energy and of what their contacts have "
             "stored, less the work of the ground's motion, above its least value before; as a share of the "
             "stack's weight times the height of its centre of mass at rest. A contact that is a spring "
             "stores half of stiffness k times overlap squared; one so stiff that k dt^2 exceeds the lighter "
             "block's mass counts as rigid. The true motion never gains any"),
      median("penetration", &M::penetration,
             "largest depth of a block's corner in the block or ground it meets, m"),
      median("sinking", &M::sinking,
             "the least such depth over the last tenth of the run, m: how far a block has sunk in"),
      median("gap", &M::gap, "largest height of a block over what it stands on, m"),
      median("slip", &M::slip,
             "largest way of a pivot along the face that it stands on, from its place without slipping, m"),
      median("out_of_plane", &M::out_of_plane, "largest distance of a block's centre from the plane, m"),
      median("out_of_plane_tilt", &M::out_of_plane_tilt, "largest sine of a block's angle out of the plane"),
      median("complementarity_residual", &M::complementarity_residual,
             "largest product of gap and normal force of a contact that pushes across a gap; as a share of "
             "the stack's weight times the height of its centre of mass. The gap is that at the step's end, "
             "the force the step's impulse over its length. Empty where the engine tells no contacts"),
      median("friction_cone_violation", &M::friction_cone_violation,
             "impulse along the faces above friction coefficient times normal impulse, added up over all "
             "contacts and steps, as a share of all normal impulse; whatever law of friction the engine "
             "itself has"),
      median("contact_stiffness", &M::contact_stiffness,
             "stiffness of a contact point where contacts are springs, N/m: that by which all impulses "
             "together overlap as much as by the points' own. In a space of three dimensions a corner of a "
             "block is two points. Empty where contacts are rigid, or the engine tells none"),
      median("contact_damping", &M::contact_damping,
             "damping of the dashpot beside that spring, N s/m: the mean by impulse"),
      median("contact_points", &M::contact_points,
             "how many points push together at one end of an interface, the mean by impulse: a corner has "
             "that many times the stiffness and damping of a point"),
      median("contact_damping_ratio", &M::contact_damping_ratio,
             "damping ratio of a corner of the lowest block on that spring and dashpot, c/(2 sqrt(k m)) with "
             "1/m = 1/mass + (half width)^2/inertia"),
      median("contact_restitution", &M::contact_restitution,
             "share of its speed with which such a corner leaves again, from that ratio; the force is cut at "
             "zero, weight left out"),
      median("contact_impacts_matched", &M::contact_impacts_matched,
             "as impacts_matched, of the engine's impacts as its contacts tell them: an end of an interface "
             "that bore nothing in the step before, and was off, begins to bear while the interface closes "
             "at the chatter speed or faster; the time is that at which gap and speed let both faces touch, "
             "the side that at the step's end. Listed in contact_impacts.csv"),
      median("contact_impacts_missed", &M::contact_impacts_missed, "likewise missed"),
      median("contact_impacts_extra", &M::contact_impacts_extra, "likewise extra"),
      median("impact_readings_differ", &M::impact_readings_differ,
             "impacts that one reading of the engine's motion has and the other has not: from angles, and "
             "from contacts, within three steps"),
      median("residual_motion", &M::residual_motion,
             "root of the mean square angular velocity of all blocks over the last tenth of the scene, where "
             "the exact solution is at rest all that time, rad/s"),
      median("warnings", &M::warnings,
             "in how many steps the engine said that its solver failed, and went on: ODE with what it had, "
             "Bullet with sequential impulse in place of an mlcp solver"),
      plain("toppled", &M::toppled, "block that passed its toppling angle and when, which ends the run"),
      plain("fallen", &M::fallen,
            "block that has left the face it stood on, and when: from then on nothing of that is below it"),
      plain("toppling_verdict", &M::toppling_verdict,
            "in which of both a block topples or falls off within the scene: neither, both, engine alone or "
            "exact alone"),
      // What the difference comes from.
      median("model_difference", &M::model_difference,
             "contact model: RMS angle difference from the exact motion to the exact one under law "
             "unilateral with the engine's friction, rad; this and the next two over the time that all "
             "motions cover, as far as a suite asks for softness"),
      median("softness_difference", &M::softness_difference,
             "contact softness: from there to the exact motion under law compliant, with corners of the "
             "engine's stiffness and damping, rad; 0 where its contacts are rigid"),
      median("step_difference", &M::step_difference,
             "time step: from there to the engine, rad. In every sample the three add up"),
      median("model_share", &M::model_share,
             "share of the contact model in the difference: sum over samples and blocks of that part times "
             "the whole, over the sum of squares of the whole. The three shares add up to 1; one is negative "
             "where its part works against the others"),
      median("softness_share", &M::softness_share, "likewise of contact softness"),
      median("step_share", &M::step_share, "likewise of the time step"),
      median("parts_over_whole", &M::parts_over_whole,
             "root of the sum of squares of the three parts over the whole: 1 where they have nothing to do "
             "with each other, more where they cancel"),
      median("spring_factor", &M::spring_factor,
             "1 where the compliant motion has the engine's own stiffness and damping. Where that would take "
             "more than about 100000 steps, its angles are extrapolated from springs that are softer by this "
             "factor and by twice as much"),
      plain("split_reason", &M::split_reason, "why a difference is not split"),
  });
  return list;
}

}  // namespace rockstack
