#include "comparisons/runs/measure.hpp"

#include <fmt/format.h>

#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/forces.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/measures/statistics/samples.hpp"

namespace rockstack {
namespace {

double largest_angle(const History& history) {
  return std::ranges::max(peak_angles(history));
}

/// The second swing of the top block; nothing where it has not peaked by the end.
std::optional<double> second_peak(const History& history) {
  const auto list = swings(history, static_cast<std::size_t>(history.blocks) - 1);
  if (list.size() < 2 || list[1].peak_time >= history.times.back()) return {};
  return list[1].peak;
}

void add_angles(const History& exact, const History& other, const Difference& apart, double tolerance,
                RunMetrics& row) {
  row.largest_angle_difference = largest(apart);
  row.rms_angle_difference = root_mean_square(apart);
  row.agreement_time = agreement_time(apart, tolerance);
  if (const double peak = largest_angle(exact); peak > 0 && largest_angle(other) > 0) {
    row.relative_angle_difference = largest(apart) / peak;
    const MagnitudePhase parts = magnitude_phase(exact, other);
    row.magnitude_error = parts.magnitude;
    row.phase_error = parts.phase;
  }
  if (const auto slips = slip_difference(exact, other)) {
    row.slip_error = slips->largest;
    row.final_slip_error = slips->last;
  }
  const auto expected = second_peak(exact), found = second_peak(other);
  if (expected && found) row.second_peak_difference = (*found - *expected) / *expected;
}

/// The first impact of the interface that impacts first in the exact motion.
void add_first_impact(const std::vector<ImpactTime>& expected, const std::vector<ImpactTime>& found,
                      double horizon, RunMetrics& row) {
  if (expected.empty()) return;
  const auto first = std::ranges::find(found, expected.front().interface, &ImpactTime::interface);
  if (first == found.end()) return;
  row.first_impact_time = first->time;
  row.first_impact_speed = first->approach;
  if (expected.front().time <= horizon)
    row.first_impact_time_difference = first->time - expected.front().time;
}

void set_counts(const std::vector<AlignedImpact>& alignment, std::optional<int>& matched,
                std::optional<int>& missed, std::optional<int>& extra) {
  const AlignmentCounts counts = count(alignment);
  matched = counts.matched;
  missed = counts.missed;
  extra = counts.extra;
}

/// The engine's times between impacts of an interface over the exact ones, less 1; of impacts that follow
/// each other in both.
std::optional<double> swing_time_error(const std::vector<AlignedImpact>& alignment) {
  double exact = 0, engine = 0;
  std::map<int, const AlignedImpact*> last;  // of each interface, or null where one alone has it
  for (const AlignedImpact& one : alignment) {
    const bool both = one.exact && one.engine && *one.exact < thread_lost(alignment, one.interface);
    const AlignedImpact*& before = last[one.interface];
    if (both && before != nullptr) {
      exact += *one.exact - *before->exact;
      engine += *one.engine - *before->engine;
    }
    before = both ? &one : nullptr;
  }
  return exact > 0 ? std::optional(engine / exact - 1) : std::nullopt;
}

void add_impacts(const Scene& scene, const History& exact, const CandidateMotion& candidate,
                 const Difference& gaps, double horizon, RunMetrics& row, RunFiles& files) {
  const auto expected = reported_impacts(scene, exact, chatter_speed(scene));
  const auto windows = matching_windows(expected, gaps, candidate.interval);
  const auto alignment = align(expected, candidate.impacts, windows);
  const auto compared = up_to(alignment, horizon);
  row.impacts = static_cast<int>(candidate.impacts.size());
  set_counts(compared, row.impacts_matched, row.impacts_missed, row.impacts_extra);
  add_first_impact(expected, candidate.impacts, horizon, row);
  if (*row.impacts_matched > 0) {
    const AlignmentCounts counts = count(compared);
    row.rms_impact_time_difference = counts.rms_apart;
    row.largest_impact_time_difference = counts.largest_apart;
    row.swing_time_error = swing_time_error(compared);
  }
  // What the exact motion itself scores when it is read from samples as an engine's is.
  const auto sampled = observed_impacts(scene, exact, chatter_speed(scene));
  set_counts(up_to(align(expected, sampled, still_windows(expected, candidate.interval)), horizon),
             row.impacts_matched_null, row.impacts_missed_null, row.impacts_extra_null);
  const ChanceMatches chance = chance_matches(up_to(expected, horizon), up_to(candidate.impacts, horizon),
                                              windows, std::min(horizon, scene.duration));
  row.impacts_matched_random = chance.random;
  row.impacts_matched_shifted = chance.shifted;
  const auto settled = settlings(scene, exact);
  const std::vector<double> durations(settled.size(), settling_duration(scene));
  set_counts(up_to(align(settled, settlings(scene, candidate.history), durations), horizon),
             row.settlings_matched, row.settlings_missed, row.settlings_extra);
  files["impacts.csv"] = impacts_csv(alignment);
}

/// `times`: those that are compared.
void add_patterns(const Scene& scene, const std::vector<double>& times, const History& exact,
                  const History& other, RunMetrics& row, RunFiles& files) {
  const auto expected = sampled_patterns(scene, exact), found = sampled_patterns(scene, other);
  const auto shares = pattern_shares(times, expected, found);
  row.pattern_agreement = agreement(shares);
  row.pattern_sequence_time = sequence_time(times, expected, found);
  files["patterns.csv"] = patterns_csv(shares);
}

/// What rises higher than in the exact motion, and what goes on where that does not.
void add_rest(const Scene& scene, const History& exact, const CandidateMotion& candidate, double horizon,
              RunMetrics& row) {
  constexpr double lag = 2;  // steps: engines are late by about one
  const BodyRecord& bodies = *candidate.bodies;
  row.rise = largest_rise(exact, bodies.gaps, horizon, lag * candidate.interval);
  const Unrest unrest = unrest_of(scene, exact, candidate.history, bodies.centres, bodies.gaps);
  row.hover = unrest.hover;
  row.turn = unrest.turn;
  row.creep = unrest.creep;
  row.offset = unrest.offset;
}

void add_bodies(const Scene& scene, const BodyRecord& bodies, RunMetrics& row) {
  const double scale = energy_scale(scene);
  row.energy_gain = largest_gain(energy_balance(bodies.energy, bodies.input, elastic_energy(bodies))) / scale;
  row.penetration = *std::ranges::max_element(bodies.penetration);
  row.gap = std::ranges::max(bodies.gaps);
  row.slip = bodies.slip;
  row.out_of_plane = bodies.out_of_plane;
  row.out_of_plane_tilt = bodies.out_of_plane_tilt;
  if (!bodies.contacts) return;
  row.complementarity_residual = bodies.contacts->complementarity / scale;
  row.friction_cone_violation = bodies.contacts->friction_excess;
  if (std::isinf(bodies.contacts->stiffness)) return;
  row.contact_stiffness = bodies.contacts->stiffness;
  row.contact_damping = bodies.contacts->damping;
  row.contact_points = bodies.contacts->points;
  const double ratio = damping_ratio(corner_of(*bodies.contacts), scene.blocks.front());
  if (!std::isfinite(ratio)) return;  // dashpots without springs
  row.contact_damping_ratio = ratio;
  row.contact_restitution = restitution_of(*row.contact_damping_ratio);
}

/// Where centres are; `exact` and `times`: those that are compared.
void add_positions(const Scene& scene, const History& exact, const std::vector<double>& times,
                   const std::optional<BodyRecord>& bodies, double tolerance, RunMetrics& row) {
  const std::vector<double> centres = centres_of(scene, exact);
  row.motion = extent_of_motion(scene, exact, centres);
  row.error = row.rms_angle_difference;
  if (!bodies) return;
  Difference apart{scene.blocks.size(), times, {}};
  for (std::size_t i = 0; i < 2 * times.size() * scene.blocks.size(); i += 2)
    apart.values.push_back(
        std::hypot(bodies->centres[i] - centres[i], bodies->centres[i + 1] - centres[i + 1]));
  const double height = least_height(scene.blocks);
  row.largest_position_difference = largest(apart);
  row.rms_position_difference = root_mean_square(apart);
  row.relative_position_difference = largest(apart) / height;
  row.position_agreement_time = agreement_time(apart, tolerance * height);
  row.error = std::max(*row.error, *row.rms_position_difference / height);
  row.sinking = support_of(bodies->penetration, bodies->unsupported_since).sinking;
}

std::vector<ImpactTime> without_landings(std::vector<ImpactTime> impacts) {
  std::erase_if(impacts, std::mem_fn(&ImpactTime::lands));
  return impacts;
}

/// The impacts that the engine's contacts tell, beside the exact ones and beside those read from its motion.
/// They tell no landings.
void add_contact_impacts(const Scene& scene, const History& exact, const CandidateMotion& candidate,
                         const Difference& gaps, double horizon, RunMetrics& row, RunFiles& files) {
  if (!candidate.bodies->contacts) return;
  const double slowest = chatter_speed(scene);
  std::vector<ImpactTime> told;
  for (const ContactImpact& impact : candidate.bodies->contacts->impacts)
    if (impact.speed >= slowest)
      told.push_back({impact.time, impact.interface, side_of(impact.after, slowest)});
  std::ranges::stable_sort(told, {}, &ImpactTime::time);
  const auto expected = without_landings(reported_impacts(scene, exact, slowest));
  const auto alignment = align(expected, told, matching_windows(expected, gaps, candidate.interval));
  set_counts(up_to(alignment, horizon), row.contact_impacts_matched, row.contact_impacts_missed,
             row.contact_impacts_extra);
  const auto read = without_landings(candidate.impacts);
  const AlignmentCounts readings =
      count(up_to(align(read, told, still_windows(read, candidate.interval)), horizon));
  row.impact_readings_differ = readings.missed + readings.extra;
  files["contact_impacts.csv"] = impacts_csv(alignment);
}

/// What an engine's interfaces bear, where it tells that.
void add_forces(const Scene& scene, const History& exact, const CandidateMotion& candidate,
                const Difference& gaps, double horizon, RunMetrics& row, RunFiles& files) {
  if (candidate.history.reactions.empty()) return;
  const auto expected = reported_impacts(scene, exact, chatter_speed(scene));
  const auto alignment =
      align(expected, candidate.impacts, matching_windows(expected, gaps, candidate.interval));
  const auto [forces, impulses] = compare_forces(
      scene, up_to(exact, horizon), up_to(candidate.history, horizon), up_to(alignment, horizon));
  row.normal_force_error = forces.normal;
  row.friction_force_error = forces.tangential;
  row.peak_normal_force = forces.peak;
  row.exact_peak_normal_force = forces.exact_peak;
  row.impulse_error = impulse_error(impulses);
  if (!impulses.empty())
    row.first_impulse_error = impulses.front().engine.normal / impulses.front().exact.normal - 1;
  files["impulses.csv"] = impulses_csv(impulses);
}

/// @throws std::runtime_error where there is none, so that it is not taken for a failure of the other
/// candidate.
History exact_motion(const Scene& scene, const std::vector<double>& times) {
  try {
    return solve(scene, {.sample_times = times});
  } catch (const std::exception& failure) {
    throw std::runtime_error(fmt::format("no exact motion to compare with: {}", failure.what()));
  }
}

/// Whether a block turns at the end, by more than engines let what stands creep: what is past balance and
/// stays there stands.
bool moves_at_end(const Scene& scene, const History& history) {
  constexpr double slow = 0.01;  // √(g/H)
  return largest_magnitude(history.velocities_at(history.size() - 1)) >
         slow * std::sqrt(scene.gravity / stack_height(scene));
}

}  // namespace

void compare_with_exact(const Scene& scene, const Suite& suite, const CandidateMotion& candidate,
                        double horizon, RunMetrics& row, RunFiles& files) {
  const ResultSelection& wanted = suite.wanted;
  const History& history = candidate.history;
  const History exact = exact_motion(scene, history.times);
  const Difference apart = difference(exact, history);
  row.horizon = horizon;
  // Times are rounded: where everything is compared, so is the last sample.
  if (horizon >= scene.duration) horizon = std::numeric_limits<double>::infinity();
  const Difference compared = up_to(apart, horizon);
  const bool topples = !reported_toppling(exact).empty();
  // What is past balance as the scene ends would topple later; samples go no further than the engine's.
  const auto falls = [&](const History& other) {
    return moves_at_end(scene, other) && falling_block(scene, other, other.size() - 1);
  };
  if (topples == candidate.topples || !falls(topples ? history : solve(scene, {.end = true})))
    row.toppling_verdict = toppling_verdict(topples, candidate.topples);
  if (wanted.angles) {
    const History seen = up_to(exact, horizon);
    add_angles(seen, up_to(history, horizon), compared, suite.tolerance, row);
    add_positions(scene, seen, compared.times, candidate.bodies, suite.tolerance, row);
    row.peak_angle = largest_angle(history);
    row.exact_peak_angle = largest_angle(exact);
    row.peak_over_slenderness = largest_lean(scene, history).ratio;
    row.exact_peak_over_slenderness = largest_lean(scene, exact).ratio;
    row.residual_motion = residual_motion(exact, history);
  }
  const Difference gaps = gap_difference(scene, exact, history);
  if (wanted.impacts) add_impacts(scene, exact, candidate, gaps, horizon, row, files);
  if (wanted.patterns) add_patterns(scene, compared.times, exact, history, row, files);
  const bool bodies = candidate.bodies && wanted.bodies;
  if (bodies) add_bodies(scene, *candidate.bodies, row);
  if (bodies) add_rest(scene, exact, candidate, horizon, row);
  if (bodies && wanted.impacts) add_contact_impacts(scene, exact, candidate, gaps, horizon, row, files);
  if (bodies && suite.softness) add_parts(scene, exact, candidate, horizon, wanted.histories, row, files);
  if (wanted.forces) add_forces(scene, exact, candidate, gaps, horizon, row, files);
  if (!wanted.histories) return;
  if (!history.reactions.empty()) files["reactions.csv"] = reactions_csv(scene, history);
  files["history.csv"] = history_csv(history);
  files["difference.csv"] = difference_csv(apart);
  if (bodies) files["energy.csv"] = energy_csv(apart.times, energies(scene, exact), *candidate.bodies);
}

}  // namespace rockstack
