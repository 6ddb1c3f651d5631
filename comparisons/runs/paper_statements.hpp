#pragma once

#include "comparisons/suites/suite.hpp"

namespace rockstack {

// What Spanos, Roussis & Politis 2001 say about their numerical examples (Section 5), set beside what was
// computed.

enum class Verdict { holds, fails, undecidable };

std::string name(Verdict verdict);

/// One statement of the paper, in the project's own words.
struct Statement {
  std::string source;     ///< figure of the paper
  std::string claim;      ///< what is said
  Verdict verdict{};      ///< by the exact solver and the criterion
  std::string criterion;  ///< what is counted as holding
  std::string computed;   ///< numbers from the exact solver and each engine
};

/// One answer to a scene: the exact solver's, with events, or an engine's.
struct Answer {
  std::string name;
  History history;
};

/// The two scenes of Section 5 with their answers; the exact one comes first and holds events. What the paper
/// says of Fig. 22 is of one record, Northridge 1994 at Simi Valley. Under another earthquake a verdict tells
/// whether the same can be said of that one; under a made-up motion it cannot be decided.
struct Evidence {
  Scene free;  ///< Figs. 18 to 20
  std::vector<Answer> free_answers;
  History free_linear;  ///< at the times of the exact answer
  Scene shaken;         ///< Figs. 21 and 22
  std::vector<Answer> shaken_answers;

  const History& free_exact() const { return free_answers.front().history; }
  const History& shaken_exact() const { return shaken_answers.front().history; }
};

/// Solves both scenes, the shaken one to the end of its record, and runs each tuned engine of the suite at
/// its step nearest to 1 ms. A run that fails is left out. Precondition: the suite names its statements'
/// scenes.
Evidence gather(const Suite& suite);

std::vector<Statement> judge(const Evidence& evidence);

}  // namespace rockstack
