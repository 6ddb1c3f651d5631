#include "comparisons/runs/against_exact.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/solve.hpp"
#include "comparisons/metrics/contact_patterns.hpp"
#include "comparisons/metrics/difference.hpp"
#include "comparisons/metrics/energy.hpp"
#include "comparisons/metrics/magnitude_phase.hpp"
#include "comparisons/metrics/rest.hpp"
#include "comparisons/metrics/swings.hpp"
#include "comparisons/metrics/toppling.hpp"
#include "comparisons/results/files.hpp"
#include "comparisons/results/tables.hpp"

namespace rockstack {
namespace {

double largest_angle(const History& history) {
  double result = 0;
  for (const double angle : history.angles) result = std::max(result, std::abs(angle));
  return result;
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
  const auto expected = second_peak(exact), found = second_peak(other);
  if (expected && found) row.second_peak_difference = (*found - *expected) / *expected;
  row.residual_motion = residual_motion(exact, other);
}

void add_impacts(const Scene& scene, const History& exact, const OtherAnswer& answer,
                 const std::filesystem::path& folder, RunMetrics& row) {
  const auto expected = reported_impacts(exact, chatter_speed(scene));
  const auto alignment = align(expected, answer.impacts, matching_window(scene));
  const AlignmentCounts counts = count(alignment);
  row.impacts_matched = counts.matched;
  row.impacts_missed = counts.missed;
  row.impacts_extra = counts.extra;
  if (!expected.empty() && !answer.impacts.empty()) {
    row.first_impact_time_difference = answer.impacts.front().time - expected.front().time;
  }
  if (counts.matched > 0) {
    const TimeDifferences apart = time_differences(alignment);
    row.rms_impact_time_difference = apart.root_mean_square;
    row.largest_impact_time_difference = apart.largest;
  }
  const AlignmentCounts settled =
      count(align(settlings(scene, exact), settlings(scene, answer.history), matching_window(scene)));
  row.settlings_matched = settled.matched;
  row.settlings_missed = settled.missed;
  row.settlings_extra = settled.extra;
  write_file(folder / "impacts.csv", impacts_csv(alignment));
}

void add_patterns(const Scene& scene, const std::vector<double>& times, const History& exact,
                  const History& other, const std::filesystem::path& folder, RunMetrics& row) {
  const auto expected = sampled_patterns(scene, exact), found = sampled_patterns(scene, other);
  const auto shares = pattern_shares(times, expected, found);
  row.pattern_agreement = agreement(shares);
  row.pattern_sequence_time = sequence_time(times, expected, found);
  write_file(folder / "patterns.csv", patterns_csv(shares));
}

void add_bodies(const Scene& scene, const BodyRecord& bodies, RunMetrics& row) {
  row.energy_gain = largest_gain(bodies.energy, bodies.input) / energy_scale(scene);
  row.penetration = bodies.penetration;
  row.gap = bodies.gap;
  row.slip = bodies.slip;
  row.out_of_plane = bodies.out_of_plane;
  row.out_of_plane_tilt = bodies.out_of_plane_tilt;
}

}  // namespace

void compare_with_exact(const Scene& scene, const Suite& suite, const OtherAnswer& answer,
                        const std::filesystem::path& folder, RunMetrics& row) {
  const Wanted& wanted = suite.wanted;
  const History& history = answer.history;
  const History exact = solve(scene, {.sample_times = history.times});
  const Difference apart = difference(exact, history);
  row.toppling_verdict = toppling_verdict(!reported_toppling(exact).empty(), answer.topples);
  if (wanted.angles) add_angles(exact, history, apart, suite.tolerance, row);
  if (wanted.impacts) add_impacts(scene, exact, answer, folder, row);
  if (wanted.patterns) add_patterns(scene, apart.times, exact, history, folder, row);
  if (answer.bodies) add_bodies(scene, *answer.bodies, row);
  if (!wanted.histories) return;
  write_file(folder / "history.csv", history_csv(history));
  write_file(folder / "difference.csv", difference_csv(apart));
  if (answer.bodies) {
    write_file(folder / "energy.csv",
               energy_csv(apart.times, energies(scene, exact), answer.bodies->energy, answer.bodies->input));
  }
}

}  // namespace rockstack
