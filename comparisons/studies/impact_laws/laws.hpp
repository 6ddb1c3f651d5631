#pragma once

#include "analytic/mechanics/impact.hpp"

namespace rockstack {

// How often the two laws of analytic/mechanics/impact.hpp differ, and where. With the velocities before drawn
// at random the answer is a share; a law's choice does not depend on their size, on gravity or on the scale
// of the blocks, but whether the pattern before can carry itself does.

struct Range {
  double from = 0, to = 0;
};

/// What impacts are drawn from. Lengths follow from a lowest block 2 m wide, masses from one of 1 kg.
struct ImpactDraws {
  std::uint64_t seed = 1;
  int samples = 400;                 ///< impacts a cell and kind
  int cells = 8;                     ///< along either axis of the grid
  std::vector<int> blocks{2, 3};     ///< stacks of so many blocks, each 2 or 3
  Range aspect_ratio{0.25, 8};       ///< h/b of the top block, logarithmic axis of the grid
  Range mass_ratio{0.05, 20};        ///< of a block to the one below, logarithmic axis of the grid
  Range base_aspect_ratio{0.25, 8};  ///< h/b of the other blocks
  Range width_ratio{0.3, 1};         ///< of a block to the one below
  double largest_angle = 0.3;        ///< of an open interface that does not impact, rad
  Range speed{0.05, 0.5};            ///< largest relative rate before, in √(g/H), H the stack's height
};

/// A kind of impact: the pattern before and the open interface that closes (index from 0).
struct ImpactKind {
  Pattern before;
  int interface = 0;

  bool operator==(const ImpactKind&) const = default;
};

/// "3a-ground", "1a-blocks"; of three blocks "RCC-ground", "RRL-interface-2".
std::string name(const ImpactKind& kind);

/// All kinds of a stack, one of each pair of mirror images: the lowest open interface pivots right.
std::vector<ImpactKind> impact_kinds(int blocks);

/// A stack at the instant before an impact.
struct DrawnImpact {
  Scene scene;  ///< blocks alone
  Impact<double> impact;
};

/// What the laws make of an impact. `consistent` is empty where no candidate is.
struct LawVerdict {
  PatternSolution<double> paper;
  std::optional<PatternSolution<double>> consistent;
  int admissible = 0;   ///< candidates that are admissible both ways, of all 3ⁿ for n touching interfaces
  bool missed = false;  ///< law `consistent` finds none although there is one

  bool differ() const { return consistent && !(consistent->pattern == paper.pattern); }
};

LawVerdict judge(const DrawnImpact& drawn);

/// One cell of the grid for one kind.
struct ImpactShare {
  int blocks = 0;
  ImpactKind kind;
  Range aspect_ratio = {}, mass_ratio = {};
  int drawn = 0;    ///< states, among them those whose pattern cannot carry itself
  int impacts = 0;  ///< states that were judged
  int differ = 0;   ///< both laws have an answer, and not the same
  int none = 0;     ///< no pattern is consistent
  int several = 0;  ///< more than one is
  int missed = 0;   ///< one is, and the solver's search does not find it
};

/// A pair of answers to one kind of impact: how often it occurs, and its clearest case.
struct Disagreement {
  ImpactKind kind;
  Pattern paper, consistent;
  int count = 0;
  double clearness = 0;  ///< smallest of the rates that tell the answers apart, over the largest before
  DrawnImpact clearest;
};

struct ImpactLaws {
  std::vector<ImpactShare> shares;
  std::vector<Disagreement> disagreements;
};

/// The whole grid; the same for the same draws on every machine of the same arithmetic.
ImpactLaws study_impact_laws(const ImpactDraws& draws);

}  // namespace rockstack
