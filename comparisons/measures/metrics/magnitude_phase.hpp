#pragma once

#include "analytic/scene/history.hpp"

namespace rockstack {

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
