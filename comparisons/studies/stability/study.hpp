#pragma once

#include "analytic/scene/input/key.hpp"
#include "comparisons/runs/compare.hpp"

namespace rockstack {

/// What a run's measures are held against. Shares, so that they hold for a pebble and a tower alike: of the
/// energy that tips the stack over as one block, of the smallest block's height and width, of its
/// slenderness, and of √(g/H), H the stack's height.
struct StabilityLimits {
  double unstable_energy = 0.5;  ///< energy gained that could tip over what stands
  double unstable_rise = 0.1;  ///< height beyond the exact one above what a block stands on: it is thrown up
  double unstable_tilt = 0.1;  ///< sine of an angle out of the plane
  double energy = 0.05;        ///< energy gained
  double penetration = 0.01;   ///< of the height
  double slip = 0.02;          ///< of the width
  double out_of_plane = 0.01;  ///< of the width
  double angle = 0.05;         ///< difference from the exact angles, of the slenderness
  double residual = 1e-3;      ///< angular velocity left where the exact stack is at rest
};

inline constexpr StabilityLimits stability_limits;

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
StabilityVerdict judge_stability(const RunMetrics& row, const Scene& scene);

/// What is varied beside the time step: keys of a scene, or one parameter of the engines.
struct StabilityAxis {
  std::string name;            ///< with its unit
  std::string parameter;       ///< of the engines; empty: scenes
  std::vector<double> values;  ///< one a scene, in the suite's order
};

/// Which solvers are sound at which steps, along an axis.
struct StabilityStudy {
  Suite suite = usual();
  StabilityAxis axis;
  std::string text;  ///< the file as it was read

 private:
  /// A suite with what a file of a study may leave out.
  static Suite usual() {
    Suite suite;
    suite.wanted = {.angles = true, .impacts = false, .patterns = false, .bodies = true, .histories = false};
    suite.repeats = 1;
    suite.limits.time = 60;
    return suite;
  }
};

/// Reads a study. @throws InputError with file:line, key, value and what is allowed.
StabilityStudy read_stability_study(const std::filesystem::path& file,
                                    const std::vector<std::string>& overrides);

/// One run with its verdict.
struct StabilityRun {
  RunMetrics row;
  double value = 0;  ///< on the axis
  StabilityVerdict verdict;
};

/// The largest steps of one solver at one value of the axis up to which all smaller ones of the study hold
/// too; 0: not even the smallest. s.
struct LargestSteps {
  std::string engine, solver, settings;
  double value = 0;
  double sound = 0;
  double stable = 0;  ///< sound or inexact

  bool operator==(const LargestSteps&) const = default;
};

/// In the order of the rows. Exact runs are passed over.
std::vector<LargestSteps> largest_steps(const std::vector<StabilityRun>& rows);

/// Makes the runs that are not there yet, as compare(), and writes besides stability.csv, steps.csv and
/// stability.json. @throws as compare().
std::vector<StabilityRun> run_stability(const StabilityStudy& study, const std::filesystem::path& folder,
                                        Executor& executor, const CompareOptions& options);

// The keys of a study of stability that a suite has not, or has otherwise: a map of engines over a parameter.

extern const KeysOf<StabilityStudy> stability_keys;
extern const KeysOf<StabilityAxis> axis_keys;

inline constexpr std::initializer_list<const KeyTable*> stability_tables{&stability_keys, &axis_keys};

}  // namespace rockstack
