#pragma once

#include <optional>

#include "analytic/scene/history.hpp"

namespace rockstack {

/// What two histories differ by at the same times, over the time that both cover: angles, or places of
/// centres.
struct Difference {
  std::size_t blocks = 0;
  std::vector<double> times;   ///< s
  std::vector<double> values;  ///< second minus first, rad; or distances, m; times.size() × blocks

  std::span<const double> at(std::size_t sample) const { return {values.data() + sample * blocks, blocks}; }
};

/// Difference of angles. @throws std::invalid_argument where the histories are of different stacks or their
/// common times differ.
Difference difference(const History& first, const History& second);

/// The samples of a difference up to a time, s, the first one in any case.
Difference up_to(Difference difference, double time);

/// Those of a history, and its events.
History up_to(History history, double time);

/// Largest absolute difference of any block.
double largest(const Difference& difference);

/// Root of the mean square over all samples and blocks.
double root_mean_square(const Difference& difference);

/// The first time at which a block differs by more than `tolerance`; the last time where none does. s.
double agreement_time(const Difference& difference, double tolerance);

/// How far slips differ, m: of all interfaces that touch in the first history, at any time and at the last
/// common one.
struct SlipDifference {
  double largest = 0;
  std::optional<double> last;  ///< nothing where none touches then
};

/// Nothing where either history tells no slips.
/// @throws std::invalid_argument as difference().
std::optional<SlipDifference> slip_difference(const History& first, const History& second);

/// The difference of an engine's motion from the exact one, from one motion to the next: exact; exact with
/// rigid contacts and the engine's friction; exact on springs as soft as its contacts; the engine.
struct DifferenceParts {
  Difference model, softness, step;  ///< of the same samples; they add up to the whole
};

/// Over the time that all four cover. @throws std::invalid_argument as difference().
DifferenceParts difference_parts(const History& exact, const History& rigid, const History& soft,
                                 const History& engine);

/// A part as a share of the whole, Σ part·whole/Σ whole²: shares of parts add up to 1, and one is negative
/// where its part works against the others. Nothing where there is no difference.
std::optional<double> share_of(const Difference& part, const Difference& whole);

/// The sum of all parts.
Difference whole_of(const DifferenceParts& parts);

/// The difference between two histories in the two parts of Sprague & Geers (2003), as in L. E. Schwer,
/// "Validation metrics for response histories: perspectives and case studies", Engineering with Computers 23
/// (2007): of the angles as vectors m (exact) and c (of the other) over all samples and blocks, magnitude
/// |c|/|m| − 1 and phase arccos(c·m/(|c||m|))/π.
struct MagnitudePhase {
  double magnitude = 0;  ///< blind to delay
  double phase = 0;      ///< blind to amplitude, 0 to 1
};

/// Over the time that both cover. Precondition: the same blocks and times, neither without motion.
MagnitudePhase magnitude_phase(const History& exact, const History& other);

}  // namespace rockstack
