#pragma once

#include <string>
#include <vector>

#include "comparisons/studies/impact_laws/laws.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

// What engines make of an impact on which the laws differ: a short scene that starts `lead` before it and
// ends `follow` after it.

inline constexpr double lead = 5e-3;    ///< s
inline constexpr double follow = 5e-3;  ///< s

/// Relative angles count as open above this share of the largest relative rate before times `follow`.
inline constexpr double open_share = 0.03;

/// The scene that runs into an impact after `lead`, to the first order in `lead`.
Scene scene_before(const DrawnImpact& drawn);

/// A disagreement as a scene, with the exact solver's answer under either law.
struct ImpactCase {
  std::string name;  ///< kind and both answers, "4a-blocks.4b.3b"
  Disagreement disagreement;
  Scene scene;
  double time = 0;                        ///< of the impact, s
  double largest_rate = 0;                ///< relative, just before, rad/s
  std::vector<double> before;             ///< angular velocities just before, rad/s
  std::vector<double> paper, consistent;  ///< mean angular velocities, see EngineVerdict, rad/s
};

/// Cases of the disagreements that are at least so clear, of each the clearest state; left out where the
/// scene's first event is not that impact, or another follows within `follow`.
std::vector<ImpactCase> clear_cases(const std::vector<Disagreement>& disagreements, double least_clearness);

/// The law whose pattern an engine shows after an impact.
enum class Follows { consistent, paper, neither };

/// "consistent", …
std::string name(Follows follows);

/// One engine run of a case.
struct EngineVerdict {
  std::string engine, solver, settings;
  double dt = 0;               ///< s
  std::string failure;         ///< why there is no answer, or empty
  Pattern pattern;             ///< `follow` after the impact
  Follows follows{};           ///< where there is an answer
  std::vector<double> rates;   ///< mean angular velocities over the second half of `follow`, rad/s
  double from_paper = 0;       ///< largest difference of those rates from law paper's, over largest_rate
  double from_consistent = 0;  ///< likewise from law consistent's
};

EngineVerdict ask_engine(const ImpactCase& question, const EngineSeries& series, double dt);

}  // namespace rockstack
