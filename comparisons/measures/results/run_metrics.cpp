#include "comparisons/measures/results/run_metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

namespace rockstack {
namespace {

using Json = nlohmann::ordered_json;

/// In the order of RunStatus.
constexpr std::array<const char*, 6> status_names{"done",   "failed",     "not finite",
                                                  "signal", "time limit", "memory limit"};

template <class Value>
Json to_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json to_json(const std::string& value) {
  return value;
}

template <class Enumeration>
requires std::is_enum_v<Enumeration> Json to_json(Enumeration value) {
  return name(value);
}

void from_json(const Json& cell, std::optional<double>& value) {
  if (!cell.is_null()) value = cell.get<double>();
}

/// Counts stay whole: a median half way between two is rounded up.
void from_json(const Json& cell, std::optional<int>& value) {
  if (!cell.is_null()) value = static_cast<int>(std::lround(cell.get<double>()));
}

void from_json(const Json& cell, std::string& value) {
  value = cell.get<std::string>();
}

void from_json(const Json& cell, RunStatus& value) {
  value = run_status(cell.get<std::string>());
}

void from_json(const Json& cell, TopplingVerdict& value) {
  value = named_verdict(cell.get<std::string>());
}

template <auto field>
Column column(const char* name, const char* definition) {
  return {name, definition, [](const RunMetrics& row) { return to_json(row.*field); },
          [](RunMetrics& row, const Json& cell) { from_json(cell, row.*field); }};
}

template <auto field>
Column measured(const char* name, const char* definition) {
  Column result = column<field>(name, definition);
  result.measured = true;
  return result;
}

/// Of a number that every draw has its own of.
template <auto field>
Column drawn(const char* name, const char* definition) {
  Column result = column<field>(name, definition);
  result.drawn = true;
  return result;
}

/// The same with its quartiles.
template <auto field, auto lower, auto upper>
Column drawn(const char* name, const char* definition) {
  Column result = drawn<field>(name, definition);
  result.set_quartiles = [](RunMetrics& row, const Json& low, const Json& high) {
    from_json(low, row.*lower);
    from_json(high, row.*upper);
  };
  return result;
}

std::vector<Column> run_columns() {
  return {
      column<&RunMetrics::run>("run", "name of the run, and of its folder under runs/"),
      column<&RunMetrics::scene>("scene", "name of the scene"),
      column<&RunMetrics::law>(
          "law",
          "which pattern follows an impact, in the exact solution that the row is held against; of another "
          "exact solution its own"),
      column<&RunMetrics::engine>("engine", "\"exact\", or the engine's name"),
      column<&RunMetrics::solver>("solver",
                                  "integrator of the exact solver, or the engine's constraint solver"),
      column<&RunMetrics::settings>(
          "settings",
          "the engine's parameter set: default is what a user gets who sets nothing but friction and "
          "restitution; tuned suits this problem best"),
      column<&RunMetrics::dt>("dt", "time step, s; for the exact solver the longest"),
      column<&RunMetrics::status>(
          "status",
          "done; or what kept the run from it: failed (an error that the engine or the solver reports), not "
          "finite (an angle or velocity), signal (the engine's process was ended, as by an assertion), time "
          "limit or memory limit"),
      column<&RunMetrics::reason>("reason", "why a run is not done"),
      column<&RunMetrics::outcome>(
          "outcome", "what becomes of the run, in words: until when it agrees, and what else happens in it"),
      column<&RunMetrics::steps>(
          "steps", "time steps that the engine made; fewer than the duration holds where a block toppled"),
      column<&RunMetrics::draws>(
          "draws",
          "how many runs the numbers of the motion are medians of: the one at this step, and others at steps "
          "and of scenes that hardly differ (draws.csv in the run's folder, spread.csv); empty where it is "
          "one"),
      column<&RunMetrics::draws_failed>("draws_failed", "how many of them failed"),
      column<&RunMetrics::draws_other_verdict>(
          "draws_other_verdict", "in how many of them one of both topples alone, engine or exact solution"),
      column<&RunMetrics::horizon>(
          "horizon",
          "up to when histories can be compared, s: the first time at which the exact motion of one of twenty "
          "scenes that differ in the sixth digit is further than the tolerance from the scene's own; the "
          "duration where none ever is. Differences of angles and slips, impacts, settlings, patterns and "
          "parts are of the time up to the horizon; after it histories part by nature. Of the whole scene are "
          "energy, overlap, gap, slip, residual motion and toppling"),
  };
}

std::vector<Column> cost_columns() {
  return {
      measured<&RunMetrics::stepping_time_minimum>(
          "stepping_time_minimum",
          "least wall time of stepping alone (for the exact solver: of solving), over the repeats, s"),
      measured<&RunMetrics::stepping_time_median>("stepping_time_median", "median of the same times, s"),
      measured<&RunMetrics::stepping_time_spread>("stepping_time_spread",
                                                  "largest less smallest of the same times, s"),
      column<&RunMetrics::repeats>("repeats", "timed runs, after a warm-up that is not counted"),
      measured<&RunMetrics::runs_at_a_time>(
          "runs_at_a_time",
          "how many runs of the comparison shared the machine while this one was "
          "timed; only with 1 are times to "
          "be compared"),
      measured<&RunMetrics::timed_cold>("timed_cold",
                                        "1 where the engine's runtime had taken fewer steps, before the "
                                        "first timed run, than it says that it "
                                        "needs to be warm; such times are not to be compared"),
      measured<&RunMetrics::real_time_factor>(
          "real_time_factor", "seconds of motion for one second of the least wall time of stepping"),
      measured<&RunMetrics::exact_sampled_time>(
          "exact_sampled_time",
          "least wall time of the exact solver giving as many samples as the engine, over the same repeats, "
          "s; the exact row's times are of solving without samples"),
      measured<&RunMetrics::processor_time>(
          "processor_time",
          "user and system time of the engine's process, as the operating system "
          "accounts for it: the run that "
          "gives the history, all timed runs, building and reading, s"),
      measured<&RunMetrics::peak_memory>(
          "peak_memory", "largest resident memory of the engine's process, the history included, bytes"),
  };
}

std::vector<Column> motion_columns() {
  return {
      drawn<&RunMetrics::largest_angle_difference, &RunMetrics::largest_angle_difference_lower,
            &RunMetrics::largest_angle_difference_upper>(
          "largest_angle_difference",
          "largest absolute difference of any block's angle, at the engine's own times up to the horizon, rad"),
      column<&RunMetrics::largest_angle_difference_lower>("largest_angle_difference_lower",
                                                          "lower quartile of the same over replicates"),
      column<&RunMetrics::largest_angle_difference_upper>("largest_angle_difference_upper", "upper quartile"),
      drawn<&RunMetrics::rms_angle_difference, &RunMetrics::rms_angle_difference_lower,
            &RunMetrics::rms_angle_difference_upper>(
          "rms_angle_difference",
          "root of the mean square of that difference over all times up to the horizon and all blocks, rad"),
      column<&RunMetrics::rms_angle_difference_lower>("rms_angle_difference_lower",
                                                      "lower quartile of the same over replicates"),
      column<&RunMetrics::rms_angle_difference_upper>("rms_angle_difference_upper", "upper quartile"),
      drawn<&RunMetrics::largest_position_difference>(
          "largest_position_difference",
          "largest distance of a block's centre of mass from the exact one, up to the horizon, m"),
      drawn<&RunMetrics::rms_position_difference, &RunMetrics::rms_position_difference_lower,
            &RunMetrics::rms_position_difference_upper>(
          "rms_position_difference",
          "root of the mean square of that distance over all times up to the horizon and all blocks, m"),
      column<&RunMetrics::rms_position_difference_lower>("rms_position_difference_lower",
                                                         "lower quartile of the same over replicates"),
      column<&RunMetrics::rms_position_difference_upper>("rms_position_difference_upper", "upper quartile"),
      drawn<&RunMetrics::relative_position_difference>(
          "relative_position_difference",
          "the largest distance of a centre as a share of the least block height"),
      drawn<&RunMetrics::error, &RunMetrics::error_lower, &RunMetrics::error_upper>(
          "error",
          "what rows are ranked by: the RMS angle difference (rad), or the RMS distance of centres as a "
          "share of the "
          "least block height, whichever is larger"),
      column<&RunMetrics::error_lower>("error_lower", "lower quartile of the same over replicates"),
      column<&RunMetrics::error_upper>("error_upper", "upper quartile"),
      column<&RunMetrics::rank>("rank",
                                "one more than there are rows of engines, of this scene and step, that are "
                                "nearer and that a test of "
                                "replicates tells from this one (ranking_definition in comparison.json); "
                                "empty where nothing moves"),
      column<&RunMetrics::motion>(
          "motion",
          "how far the exact motion goes up to the horizon: the largest change of an angle (rad), or the "
          "longest way of a centre as a share of the least block height, whichever is larger; 0 where "
          "the scene is at rest and angles tell nothing apart"),
      drawn<&RunMetrics::peak_angle>("peak_angle",
                                     "largest absolute angle of any block over the whole scene, rad"),
      drawn<&RunMetrics::exact_peak_angle>("exact_peak_angle", "likewise of the exact motion"),
      drawn<&RunMetrics::relative_angle_difference>("relative_angle_difference",
                                                    "the largest angle difference as a share of the largest "
                                                    "exact angle of any block up to the horizon"),
      drawn<&RunMetrics::magnitude_error>(
          "magnitude_error",
          "amplitude part of the difference, blind to delay: root of the engine's mean square angle over the "
          "exact one, less 1 (Sprague & Geers 2003)"),
      drawn<&RunMetrics::phase_error>(
          "phase_error",
          "phase part, blind to amplitude: angle between both histories as vectors of all samples and blocks, "
          "as a share of half a turn (Sprague & Geers 2003); 0 in step, 1 in opposition"),
      drawn<&RunMetrics::second_peak_difference>(
          "second_peak_difference",
          "peak of the top block in its second swing, after its angle first "
          "changed sign, less the exact one, "
          "as a share of the exact one"),
      drawn<&RunMetrics::agreement_time, &RunMetrics::agreement_time_lower,
            &RunMetrics::agreement_time_upper>(
          "agreement_time",
          "time until which no angle differs by more than the tolerance; the horizon where none does before, s"),
      column<&RunMetrics::agreement_time_lower>("agreement_time_lower",
                                                "lower quartile of the same over replicates"),
      column<&RunMetrics::agreement_time_upper>("agreement_time_upper", "upper quartile"),
      drawn<&RunMetrics::position_agreement_time>(
          "position_agreement_time",
          "time until which no centre is further off than the tolerance times the least block height; "
          "the horizon where none is before, s"),
  };
}

std::vector<Column> impact_columns() {
  return {
      drawn<&RunMetrics::first_impact_time_difference>(
          "first_impact_time_difference",
          "time of the engine's first impact at the interface that impacts first, less the exact one's, s"),
      drawn<&RunMetrics::impacts>("impacts", "impacts above the chatter speed over the whole scene"),
      column<&RunMetrics::slower_impacts>("slower_impacts",
                                          "impacts of the exact motion below the chatter speed"),
      drawn<&RunMetrics::impacts_matched>(
          "impacts_matched",
          "impacts above the chatter speed that both have, in order at the same interface, not leaving to "
          "opposite sides, and no further apart than the window: three steps and the drift, which is "
          "twice the angle difference just before over the speed of closing, but never more than half way to "
          "the next "
          "impact of the interface. An impact leaves to a side where the interface's relative angular "
          "velocity after it is at least the chatter speed"),
      drawn<&RunMetrics::impacts_missed>(
          "impacts_missed",
          "exact impacts above the chatter speed, up to the horizon, that the engine does not have"),
      drawn<&RunMetrics::impacts_extra>(
          "impacts_extra", "engine impacts above the chatter speed that the exact solution does not have"),
      drawn<&RunMetrics::impacts_matched_null>("impacts_matched_null",
                                               "the sampling limit: of the exact motion itself, sampled at "
                                               "the engine's steps and read as an engine's, "
                                               "within three steps"),
      drawn<&RunMetrics::impacts_missed_null>("impacts_missed_null", "likewise missed"),
      drawn<&RunMetrics::impacts_extra_null>("impacts_extra_null", "likewise extra"),
      drawn<&RunMetrics::impacts_matched_random>(
          "impacts_matched_random",
          "the chance level: how many match of as many impacts at random times, within the same "
          "windows; median of 101"),
      drawn<&RunMetrics::impacts_matched_shifted>(
          "impacts_matched_shifted",
          "likewise of the engine's own impacts, all shifted by the same time, a tenth of the duration to "
          "nine tenths"),
      drawn<&RunMetrics::rms_impact_time_difference>(
          "rms_impact_time_difference", "root of the mean square time difference of the matched impacts, s"),
      drawn<&RunMetrics::largest_impact_time_difference>(
          "largest_impact_time_difference", "largest absolute time difference of the matched impacts, s"),
      drawn<&RunMetrics::settlings_matched>(
          "settlings_matched",
          "settlings that both have, within the settling duration, 0.1 sqrt(H/g). All chatter "
          "of an interface is one settling: the interface comes to stay within 2 mrad of closed, slower "
          "than the chatter speed, for at least the settling duration"),
      drawn<&RunMetrics::settlings_missed>("settlings_missed",
                                           "exact settlings that the engine does not have"),
      drawn<&RunMetrics::settlings_extra>("settlings_extra",
                                          "engine settlings that the exact solution does not have"),
      drawn<&RunMetrics::slip_error>("slip_error",
                                     "largest difference of how far a block has slipped along what is below "
                                     "it, of all blocks that touch "
                                     "that in the exact solution and all times, m; law unilateral alone"),
      drawn<&RunMetrics::final_slip_error>(
          "final_slip_error",
          "likewise at the last time that both cover, m; empty where no block touches then"),
      drawn<&RunMetrics::pattern_agreement>(
          "pattern_agreement",
          "share of time in which the engine is in the exact pattern. An interface is closed while it stays "
          "within 2 mrad for at least the settling duration, and open to one side else; likewise for the "
          "exact "
          "solution, at the same times. patterns.csv holds the share of time of each pair of patterns"),
      drawn<&RunMetrics::pattern_sequence_time>(
          "pattern_sequence_time",
          "time until which both pass through the same patterns in the same order; the horizon where they do "
          "up to there, s"),
  };
}

std::vector<Column> body_columns() {
  return {
      drawn<&RunMetrics::energy_gain>(
          "energy_gain",
          "largest rise of the blocks' kinetic and potential energy and of what their contacts have stored, "
          "less the work of the ground's motion, above its least value before; as a share of the stack's "
          "weight times the height of its centre of mass at rest. A contact that is a spring stores half of "
          "stiffness k times overlap squared; one so stiff that k dt^2 exceeds the lighter block's mass "
          "counts "
          "as rigid. The true motion never gains any"),
      drawn<&RunMetrics::penetration>("penetration",
                                      "largest depth of a block's corner in the block or ground it meets, m"),
      drawn<&RunMetrics::sinking>(
          "sinking", "the least such depth over the last tenth of the run, m: how far a block has sunk in"),
      drawn<&RunMetrics::gap>("gap", "largest height of a block over what it stands on, m"),
      drawn<&RunMetrics::slip>(
          "slip",
          "largest way of a pivot along the face that it stands on, from its place without slipping, m"),
      drawn<&RunMetrics::out_of_plane>("out_of_plane",
                                       "largest distance of a block's centre from the plane, m"),
      drawn<&RunMetrics::out_of_plane_tilt>("out_of_plane_tilt",
                                            "largest sine of a block's angle out of the plane"),
      drawn<&RunMetrics::complementarity_residual>(
          "complementarity_residual",
          "largest product of gap and normal force of a contact that pushes across a gap; as a share of the "
          "stack's weight times the height of its centre of mass. The gap is that at the step's end, the "
          "force "
          "the step's impulse over its length. Empty where the engine tells no contacts"),
      drawn<&RunMetrics::friction_cone_violation>(
          "friction_cone_violation",
          "impulse along the faces above friction coefficient times normal impulse, added up over all contacts "
          "and steps, as a share of all normal impulse; whatever law of friction the engine itself has"),
      drawn<&RunMetrics::contact_stiffness>(
          "contact_stiffness",
          "stiffness of a contact point where contacts are springs, N/m: that by which all impulses together "
          "overlap as much as by the points' own. In a space of three dimensions a corner of a block is two "
          "points. Empty where contacts are rigid, or the engine tells none"),
      drawn<&RunMetrics::contact_damping>(
          "contact_damping", "damping of the dashpot beside that spring, N s/m: the mean by impulse"),
      drawn<&RunMetrics::contact_points>(
          "contact_points",
          "how many points push together at one end of an interface, the mean by impulse: a corner has that "
          "many times the stiffness and damping of a point"),
      drawn<&RunMetrics::contact_damping_ratio>(
          "contact_damping_ratio",
          "damping ratio of a corner of the lowest block on that spring and dashpot, "
          "c/(2 sqrt(k m)) with 1/m = 1/mass + (half width)^2/inertia"),
      drawn<&RunMetrics::contact_restitution>(
          "contact_restitution",
          "share of its speed with which such a corner leaves again, from that ratio; the force is cut at "
          "zero, weight left out"),
      drawn<&RunMetrics::contact_impacts_matched>(
          "contact_impacts_matched",
          "as impacts_matched, of the engine's impacts as its contacts tell them: an end of an interface that "
          "bore nothing in the step before, and was off, begins to bear while the interface closes at the "
          "chatter speed or faster; the time is that at which gap and speed let both faces touch, the side "
          "that at the step's end. Listed in contact_impacts.csv"),
      drawn<&RunMetrics::contact_impacts_missed>("contact_impacts_missed", "likewise missed"),
      drawn<&RunMetrics::contact_impacts_extra>("contact_impacts_extra", "likewise extra"),
      drawn<&RunMetrics::impact_readings_differ>(
          "impact_readings_differ",
          "impacts that one reading of the engine's motion has and the other has not: from angles, and from "
          "contacts, within three steps"),
      drawn<&RunMetrics::residual_motion>(
          "residual_motion",
          "root of the mean square angular velocity of all blocks over the last "
          "tenth of the scene, where the "
          "exact solution is at rest all that time, rad/s"),
      drawn<&RunMetrics::warnings>("warnings",
                                   "in how many steps the engine said that its solver failed, and went on: "
                                   "ODE with what it had, Bullet with "
                                   "sequential impulse in place of an mlcp solver"),
      column<&RunMetrics::toppled>("toppled",
                                   "block that passed its toppling angle and when, which ends the run"),
      column<&RunMetrics::fallen>(
          "fallen",
          "block that has left the face it stood on, and when: from then on nothing of that is below it"),
      column<&RunMetrics::toppling_verdict>("toppling_verdict",
                                            "in which of both a block topples or falls off within the scene: "
                                            "neither, both, engine alone or exact "
                                            "alone"),
  };
}

std::vector<Column> split_columns() {
  return {
      drawn<&RunMetrics::model_difference>(
          "model_difference",
          "contact model: RMS angle difference from the exact motion to the exact one under law unilateral "
          "with the engine's friction, rad; this and the next two over the time that all motions cover, as "
          "far as a suite asks for softness"),
      drawn<&RunMetrics::softness_difference>(
          "softness_difference",
          "contact softness: from there to the exact motion under law compliant, with corners of the "
          "engine's stiffness and damping, rad; 0 where its contacts are rigid"),
      drawn<&RunMetrics::step_difference>(
          "step_difference", "time step: from there to the engine, rad. In every sample the three add up"),
      drawn<&RunMetrics::model_share>(
          "model_share",
          "share of the contact model in the difference: sum over samples and blocks of that part times the "
          "whole, over the sum of squares of the whole. The three shares add up to 1; one is negative where "
          "its part works against the others"),
      drawn<&RunMetrics::softness_share>("softness_share", "likewise of contact softness"),
      drawn<&RunMetrics::step_share>("step_share", "likewise of the time step"),
      drawn<&RunMetrics::parts_over_whole>(
          "parts_over_whole",
          "root of the sum of squares of the three parts over the whole: 1 where they have nothing to do "
          "with each other, more where they cancel"),
      drawn<&RunMetrics::spring_factor>(
          "spring_factor",
          "1 where the compliant motion has the engine's own stiffness and damping. Where that would take "
          "more than about 100000 steps, its angles are extrapolated from springs that are softer by this "
          "factor and by twice as much"),
      column<&RunMetrics::split_reason>("split_reason", "why a difference is not split"),
  };
}

}  // namespace

std::string name(RunStatus status) {
  return status_names.at(static_cast<std::size_t>(status));
}

RunStatus run_status(const std::string& name) {
  const auto found = std::find(status_names.begin(), status_names.end(), name);
  if (found == status_names.end()) throw std::invalid_argument(fmt::format("{}: no status of a run", name));
  return static_cast<RunStatus>(found - status_names.begin());
}

const std::vector<Column>& columns() {
  static const std::vector<Column> list = [] {
    std::vector<Column> all;
    for (const auto part :
         {run_columns, cost_columns, motion_columns, impact_columns, body_columns, split_columns}) {
      for (const Column& one : part()) all.push_back(one);
    }
    return all;
  }();
  return list;
}

Json metrics_json(const RunMetrics& row) {
  Json cells;
  for (const Column& one : columns()) cells[one.name] = one.cell(row);
  return cells;
}

RunMetrics metrics_from(const Json& cells) {
  RunMetrics row;
  for (const Column& one : columns()) {
    if (cells.contains(one.name)) one.set(row, cells.at(one.name));
  }
  return row;
}

std::vector<RunMetrics> metrics_list(const Json& rows) {
  std::vector<RunMetrics> list;
  list.reserve(rows.size());
  for (const Json& cells : rows) list.push_back(metrics_from(cells));
  return list;
}

}  // namespace rockstack
