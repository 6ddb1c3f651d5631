#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparisons/suites/suite.hpp"

namespace rockstack {

// A canon of contact: small scenes with closed forms, answered by any engine. What is off is told in steps: a
// deviation from the exact solution over what the fastest motion of that kind does in one time step. An
// engine that follows Coulomb's law, rigid contact and impacts without bounce is a few steps off, whatever
// the step.

/// How far an engine is off.
struct Deviation {
  double steps = 0;   ///< over what the fastest motion of its kind does in a step
  double amount = 0;  ///< rad or m
};

/// What an engine makes of a scene of the canon.
struct CanonAnswer {
  std::string scene;       ///< its name
  Deviation coarse, fine;  ///< at canon_steps(), of the median draw
  std::string verdict;     ///< "agrees", "converges", "another law" or "no run"
  std::string reason;      ///< why there is no run
};

/// An engine with one of its parameter sets on all scenes.
struct CanonRow {
  const WorkerEngine* engine = nullptr;
  std::string settings;  ///< "default" or "tuned"
  std::vector<CanonAnswer> answers;
};

struct CanonSteps {
  double coarse = 4e-3, fine = 1e-3;  ///< s
};
constexpr CanonSteps canon_steps() {
  return {};
}

/// A contact is met a step late at most and smooth motion is half a step ahead: what a step explains, with as
/// much again for what one makes of the other.
inline constexpr double canon_agreement = 3;

/// The larger of both, by steps, over all samples: angles that differ, over the largest angular velocity ×
/// dt; slips that differ where blocks touch, over the largest speed of a slip × dt. A motion that is slower
/// than what gravity gives a block in one step counts as that fast. Both histories have the same times; dt in
/// s.
Deviation deviation_in_steps(const Scene& scene, const History& exact, const History& engine, double dt);

/// "agrees" within canon_agreement at the fine step; "converges" where the amount falls to half or less from
/// the coarse to the fine step, a quarter of it; else "another law".
std::string canon_verdict(const Deviation& coarse, const Deviation& fine);

/// Runs all scenes of a suite, each with its draws. `done` is told each answer.
CanonRow make_canon_row(const Suite& suite, const WorkerEngine& engine, const std::string& settings,
                        const std::function<void(const CanonAnswer&)>& done);

/// canon.json and canon.csv.
std::string canon_json(const Suite& suite, const std::vector<CanonRow>& rows, const std::string& command);
std::string canon_csv(const std::vector<CanonRow>& rows);

}  // namespace rockstack
