#pragma once

#include "comparisons/measures/metrics/difference.hpp"

namespace rockstack {

/// The difference of an engine's motion from the exact one, from one motion to the next: exact; exact with
/// rigid contacts and the engine's friction; exact on springs as soft as its contacts; the engine.
struct DifferenceParts {
  Difference model, softness, step;  ///< of the same samples; they add up to the whole
};

/// Over the time that all four cover. @throws std::invalid_argument as difference().
DifferenceParts difference_parts(const History& exact, const History& rigid, const History& soft,
                                 const History& engine);

/// A part as a share of the whole, Σ part·whole/Σ whole²: shares of parts add up to 1, and one is negative
/// where its part works against the others. NaN where there is no difference.
double share_of(const Difference& part, const Difference& whole);

/// The sum of all parts.
Difference whole_of(const DifferenceParts& parts);

}  // namespace rockstack
