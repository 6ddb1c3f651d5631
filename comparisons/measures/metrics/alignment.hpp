#pragma once

#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/metrics/impacts.hpp"

namespace rockstack {

/// One line of two impact sequences set side by side: both matched, the first alone (missed) or the second
/// alone (extra).
struct AlignedImpact {
  int interface = 0;                    ///< from 1
  std::optional<int> number;            ///< of the exact impact, from 1
  std::optional<double> exact;          ///< s
  std::optional<double> engine;         ///< s
  Contact exact_side{}, engine_side{};  ///< to which it leaves, where there is one
};

/// Sets two impact sequences side by side, each interface by itself: as many pairs as possible in their
/// order, no further apart than the exact impact's window (s, one each), and not leaving to opposite sides
/// (closed goes with either); among those alignments, one with the least sum of time differences. Lines are
/// in order of time.
std::vector<AlignedImpact> align(const std::vector<ImpactTime>& exact, const std::vector<ImpactTime>& engine,
                                 const std::vector<double>& windows);

/// Without the lines beyond a time, s: those of exact impacts that come later, and of later ones alone.
std::vector<AlignedImpact> up_to(std::vector<AlignedImpact> alignment, double time);

struct AlignmentCounts {
  int matched = 0;
  int missed = 0;            ///< exact impacts that the engine does not have
  int extra = 0;             ///< engine impacts that the exact solution does not have
  double rms_apart = 0;      ///< of the time differences of matched impacts, s; 0 where none are
  double largest_apart = 0;  ///< likewise the largest absolute one
};

AlignmentCounts count(const std::vector<AlignedImpact>& alignment);

/// When the thread of an interface is lost, s; infinite where it never is. Both motions have two impacts or
/// more then, since the last that matches, of which none does: which belongs to which is chance from there
/// on.
double thread_lost(const std::vector<AlignedImpact>& alignment, int interface);

/// How far apart in time an exact impact and an engine's may be and still be the same one, s, for each exact
/// impact: three steps, and the drift. A flight of duration T that ends at speed v is v τ (1 − τ/T) open the
/// time τ before, thus v τ/2 at least in its second half: where the gaps of an interface that closes at v
/// differ by δ, its impacts are at most 2 δ/v apart. The drift takes the largest difference over the window
/// itself before the impact, so that it covers an engine that has impacted already. It never goes further
/// than half way to the next exact impact of the interface on either side. `apart`: the gap_difference() of
/// the engine from the exact solution, at steps of `dt` s.
std::vector<double> matching_windows(const std::vector<ImpactTime>& exact, const Difference& apart,
                                     double dt);

/// The windows of an answer that does not drift: three steps each.
std::vector<double> still_windows(const std::vector<ImpactTime>& exact, double dt);

}  // namespace rockstack
