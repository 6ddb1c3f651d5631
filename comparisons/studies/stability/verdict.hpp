#pragma once

#include <string>

#include "analytic/scene/scene.hpp"
#include "comparisons/measures/results/run_metrics.hpp"

namespace rockstack {

/// What a run's measures are held against. Shares, so that they hold for a pebble and a tower alike: of the
/// energy that tips the stack over as one block, of the smallest block's height and width, of its
/// slenderness, and of √(g/H), H the stack's height.
struct StabilityLimits {
  double unstable_energy = 0.5;  ///< energy gained that could tip over what stands
  double unstable_gap = 0.1;     ///< height above what a block stands on: it is thrown up
  double unstable_tilt = 0.1;    ///< sine of an angle out of the plane
  double energy = 0.05;          ///< energy gained
  double penetration = 0.01;     ///< of the height
  double slip = 0.02;            ///< of the width
  double out_of_plane = 0.01;    ///< of the width
  double angle = 0.05;           ///< difference from the exact angles, of the slenderness
  double residual = 1e-3;        ///< angular velocity left where the exact stack is at rest
};

enum class Soundness {
  sound,     ///< within all limits
  inexact,   ///< physical, but beyond a limit of exactness, or topples otherwise than the exact solution
  unstable,  ///< gains energy, throws blocks up or out of the plane, or topples what does not topple
  failed,    ///< the run did not come to its end
};

std::string name(Soundness soundness);

struct StabilityVerdict {
  Soundness soundness = Soundness::sound;
  std::string reason;  ///< the measure that decides, with its limit; empty where sound
};

/// The verdict on a run of a scene by its measures; those that are not there are passed over.
StabilityVerdict judge_stability(const RunMetrics& row, const Scene& scene,
                                 const StabilityLimits& limits = {});

}  // namespace rockstack
