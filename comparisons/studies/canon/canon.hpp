#pragma once

#include "comparisons/suites/suite.hpp"
#include "engines/worker/pace.hpp"

namespace rockstack {

// A canon of contact: small scenes with closed forms, answered by any engine at several time steps. An engine
// that follows Coulomb's law, rigid contact and impacts without bounce is off by what steps explain, which
// falls with the step; one that follows another law is off by some amount at any step.

/// The time steps of each answer, s: from a coarse one to one finer than is usual.
inline constexpr std::array canon_steps{8e-3, 4e-3, 2e-3, 1e-3, 5e-4};

/// A contact is met a step late at most and smooth motion is half a step ahead: so many steps explain, with
/// as much again for what one makes of the other. The laws that a scene tells apart differ by more, at 1 ms.
inline constexpr double canon_agreement = 3;

/// A deviation that is left at any step counts from here, s of the fastest motion: a tenth of a step of 1 ms.
inline constexpr double canon_resolution = 1e-4;

/// Where successive samples of what an engine is off by correlate by less, either way, it is scatter: a law
/// leaves less than half of the mean square, since blocks move smoothly. White noise correlates by 0 ± 1/√n
/// over n samples, 100 or more at the finest step, so that 0.5 is five deviations off.
inline constexpr double canon_scatter = 0.5;

/// How far an engine is off at most in one quantity, over the fastest motion of it.
struct Deviation {
  double time = 0;            ///< what it is off by, over the speed, s
  double speed = 1;           ///< rad/s or m/s
  std::string of = "angles";  ///< or "slips", "gaps"
  double correlation = 1;     ///< of what it is off by at successive samples, from −1 to 1

  double amount() const { return time * speed; }  ///< rad or m
  const char* unit() const { return of == "angles" ? "rad" : "m"; }
};

/// What an engine makes of a scene of the canon.
struct CanonAnswer {
  std::string scene;  ///< its name
  std::vector<Deviation>
      deviations;                  ///< at canon_steps, of the median replicate, in one quantity; none: no run
  std::string verdict = "no run";  ///< or "agrees", "converges", "another law", "cannot tell", "scatters"
  std::string reason;              ///< what the verdict rests on, or why there is no run
};

/// An engine with one of its parameter sets on all scenes.
struct CanonRow {
  const WorkerEngine* engine = nullptr;
  std::string settings;  ///< "default" or "tuned"
  std::vector<CanonAnswer> answers;
};

/// The largest over all samples: of angles, over the largest angular velocity; where both tell of contact, of
/// slips where blocks touch, over the largest speed of a slip, and of gaps, over the largest of theirs. A
/// motion that is slower than what gravity gives a block in 1 ms counts as that fast, and one of gaps as fast
/// as makes the sinking that is told a canon_resolution. Both histories have the same times.
std::vector<Deviation> deviations(const Scene& scene, const History& exact, const History& engine);

/// Replicates at a step of canon_steps.
struct CanonErrors {
  double step = 0;                                 ///< s
  std::vector<std::vector<Deviation>> replicates;  ///< one or more, each with the same quantities
};

/// Verdict and reason of the quantity in which the engine is off most: by verdict, and among equal ones by
/// time at the finest step. Each by a fit of its medians over the steps (fit_steps()), in this order:
/// "agrees" where the median is within canon_resolution at the three finest steps; "another law" where it is
/// above there and hardly changes, or where the fit leaves a deviation above canon_resolution at any step;
/// "converges" where none is left at the two finest; "cannot tell" where errors scatter, do not fall, are
/// none at some step, or leave room for one of canon_agreement steps of 1 ms; "agrees" where it is off by
/// canon_agreement steps at most at the finest; else "converges". What neither agrees nor converges
/// "scatters" where it does at the finest step (canon_scatter).
CanonAnswer judge_canon(const std::string& scene, const std::vector<CanonErrors>& errors);

/// Runs a scene at all steps, each with the suite's replicates.
CanonAnswer answer_canon(const Suite& suite, const NamedScene& scene, const WorkerEngine& engine,
                         const std::string& settings);

/// Answer kept in a folder: one of the same scene, engine and program that is there is read back;
/// where there was no run, it is tried again.
CanonAnswer kept_canon_answer(const Suite& suite, const NamedScene& scene, const WorkerEngine& engine,
                              const std::string& settings, const std::filesystem::path& folder);

/// Estimate of the time that a scene takes at all steps and replicates, on all cores, s.
double canon_time(const WorkerPace& pace, const Suite& suite, const NamedScene& scene);

/// Whether an engine follows the law: it agrees or converges.
bool follows_law(const CanonAnswer& answer);

/// The sets that follow the law in most scenes.
std::string canon_headline(const Suite& suite, const std::vector<CanonRow>& rows);

/// canon.json and canon.csv.
std::string canon_json(const Suite& suite, const std::vector<CanonRow>& rows, const std::string& command);
std::string canon_csv(const std::vector<CanonRow>& rows);

}  // namespace rockstack
