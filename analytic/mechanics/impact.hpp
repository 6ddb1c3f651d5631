#pragma once

#include "analytic/mechanics/pattern_solution.hpp"
#include "analytic/scene/history.hpp"

namespace rockstack {

// An impact takes no time, does not bounce and does not slip. Once the pattern that follows is known, so are
// the velocities: they are the allowed ones nearest to those before (dynamics.hpp). The pattern is chosen
// among those in which every *touching* interface (the one that impacts, and every closed one) pivots left,
// right, or stays closed. A pattern is kinematically admissible if each touching interface opens towards the
// side of its pivot; it is impulse admissible if each pivot pushes, and the impulse of each closed interface
// acts inside its width.
//
// Law `paper` (Spanos et al. 2001, Sections 3 and 4) takes the first of these that is kinematically
// admissible:
//
// 1. open: every touching interface pivots about the side that the impact comes from; patterns 1 and 2.
// 2. joined: only the interface that impacts does so, the others stay closed; 3a → 3b and 4a → 4b.
// 3. closed: every touching interface closes; pattern 3 after an impact between the blocks, Eqs. (84) and
//    (125). The paper is silent where the base would have to leave the ground on the wrong side; this is
//    where it lands.
//
// Law `consistent` takes the pattern that is admissible both ways. There is at most one: no slip is linear
// and the corners' distances are one-sided, so the velocities after are the nearest point of a convex cone to
// those before, and the conditions are those of that nearest point. Where the nearest point lifts a block off
// no pattern is consistent; the law then falls back on the paper's order and the event says so.

/// An impact about to happen: the state just before, with the relative angles of `impacting` interfaces zero.
template <class Real, int N = Eigen::Dynamic>
struct Impact {
  State<Real, N> before;
  Interfaces impacting;

  /// Interfaces that touch along their whole width.
  Interfaces touching() const { return impacting | before.closed(); }
};

/// What an impact finds, whatever pattern follows.
template <class Real, int N = Eigen::Dynamic>
struct BeforeImpact {
  Directions<Real, N> directions;
  Motion<Real, N> motion;
};

/// An impact whose outcome is known.
template <class Real, int N = Eigen::Dynamic>
struct PredictedImpact {
  BeforeImpact<Real, N> before;
  PatternSolution<Real, N> solution;  ///< the consistent one, and that of the law
};

template <class Real, int N>
BeforeImpact<Real, N> before_impact(const Model<Real, N>& model, const State<Real, N>& before,
                                    const Directions<Real, N>& directions) {
  const Vector<Real, N> rates = absolute(before.velocities);
  return {directions, {centre_velocities(make_chain(model.stack, before.pattern, directions), rates), rates}};
}

template <class Real, int N>
BeforeImpact<Real, N> before_impact(const Model<Real, N>& model, const State<Real, N>& before) {
  return before_impact(model, before, directions_at(model, before.angles));
}

/// Where one interface alone is open before an impact and no other opens in it, all above that interface
/// rocks as one body: the motion in which its relative velocity after the impact is `ratio` of that before,
/// about its other end. Nothing where other interfaces are open, or open.
template <class Real, int N>
std::optional<PatternSolution<Real, N>> restored(const Model<Real, N>& model, const Impact<Real, N>& impact,
                                                 const BeforeImpact<Real, N>& before, const Pattern& after,
                                                 const std::vector<double>& ratios) {
  const Pattern& from = impact.before.pattern;
  int rocking = -1;
  for (int k = 0; k < from.size; ++k) {
    const bool impacts = impact.impacting.test(k);
    if (impacts != (from[k] != Contact::closed) || (!impacts && after[k] != Contact::closed) ||
        (impacts && rocking >= 0))
      return std::nullopt;
    if (impacts) rocking = k;
  }
  Vector<Real, N> relative = Vector<Real, N>::Zero(from.size);
  relative[rocking] = Real(ratios[rocking]) * impact.before.velocities[rocking];
  Pattern pattern = from;
  pattern[rocking] = relative[rocking] == 0 ? Contact::closed : opposite(from[rocking]);
  return solution_for(model, pattern, before.directions, make_chain(model.stack, pattern, before.directions),
                      before.motion, relative);
}

/// The velocities that follow if `pattern` does, in rad/s, and the impulses that bring them about, in N·s.
template <class Real, int N>
PatternSolution<Real, N> velocities_after(const Model<Real, N>& model, const BeforeImpact<Real, N>& before,
                                          const Pattern& pattern) {
  return respond(model, pattern, before.directions, make_chain(model.stack, pattern, before.directions),
                 before.motion);
}

template <class Real, int N>
PatternSolution<Real, N> velocities_after(const Model<Real, N>& model, const Impact<Real, N>& impact,
                                          const Pattern& pattern) {
  return velocities_after(model, before_impact(model, impact.before), pattern);
}

/// True where every touching interface that is open opens towards its side.
template <class Real, int N>
bool kinematically_admissible(const PatternSolution<Real, N>& solution, const Interfaces& touching) {
  for (int k = 0; k < solution.size(); ++k) {
    if (!touching.test(k) || solution.pattern[k] == Contact::closed) continue;
    if (!(Real(sign(solution.pattern[k])) * solution.relative[k] > 0)) return false;
  }
  return true;
}

/// The pattern that is admissible both ways, if there is one. In most impacts the interfaces that impact go
/// on to their other side, and the others stay as they are.
template <class Real, int N>
std::optional<PatternSolution<Real, N>> consistent_solution(const Model<Real, N>& model,
                                                            const Impact<Real, N>& impact,
                                                            const BeforeImpact<Real, N>& before) {
  Pattern guess = impact.before.pattern;
  for (int k = 0; k < impact.before.size(); ++k)
    if (impact.impacting.test(k)) guess[k] = opposite(guess[k]);
  auto solution =
      find_admissible(model.stack, guess, impact.touching(), Real(0),
                      [&](const Pattern& pattern) { return velocities_after(model, before, pattern); });
  if (solution && !pushes(*solution)) solution.reset();
  return solution;
}

/// The paper's order: open, joined, closed. `evaluate` maps a pattern to its solution.
template <class Real, int N, class Evaluate>
PatternSolution<Real, N> paper_solution(const Impact<Real, N>& impact, const Evaluate& evaluate) {
  const Interfaces touching = impact.touching();
  const Contact side = opposite(impact.before.pattern[lowest(impact.impacting)]);
  Pattern open = impact.before.pattern;
  Pattern joined = impact.before.pattern;
  Pattern closed = impact.before.pattern;
  for (int k = 0; k < impact.before.size(); ++k) {
    if (!touching.test(k)) continue;
    const bool impacts = impact.impacting.test(k);
    open[k] = impacts ? opposite(impact.before.pattern[k]) : side;
    joined[k] = impacts ? open[k] : Contact::closed;
    closed[k] = Contact::closed;
  }
  for (const Pattern& pattern : {open, joined}) {
    PatternSolution<Real, N> solution = evaluate(pattern);
    if (kinematically_admissible(solution, touching)) return solution;
  }
  return evaluate(closed);
}

/// What follows an impact under a law, and whether it is the consistent pattern.
template <class Real, int N = Eigen::Dynamic>
struct Resolution {
  PatternSolution<Real, N> solution;
  Consistency consistency;
  bool closes = false;  ///< chatter has come to its end: something closes that would have parted
  Real chatter = 0;     ///< how long it would have gone on, s
};

template <class Real, int N>
Resolution<Real, N> resolve(const Model<Real, N>& model, const Impact<Real, N>& impact,
                            const BeforeImpact<Real, N>& before, Law law) {
  const auto consistent = consistent_solution(model, impact, before);
  if (law == Law::consistent && consistent) return {*consistent, Consistency::consistent};
  const PatternSolution<Real, N> chosen = paper_solution<Real, N>(impact, [&](const Pattern& pattern) {
    return consistent && consistent->pattern == pattern ? *consistent
                                                        : velocities_after(model, before, pattern);
  });
  if (!consistent) return {chosen, Consistency::none};
  return {chosen, chosen.pattern == consistent->pattern ? Consistency::consistent : Consistency::other};
}

}  // namespace rockstack
