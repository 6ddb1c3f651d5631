#pragma once

#include <optional>

#include "analytic/outcome.hpp"
#include "analytic/scene/history.hpp"

namespace rockstack {

// An impact takes no time, does not bounce and does not slip. Once the pattern that follows is known, so are
// the velocities: they are the allowed ones nearest to those before (dynamics.hpp). The pattern is chosen
// among those in which every *touching* interface (the one that impacts, and every closed one) pivots left,
// right, or stays closed:
//
//   kinematically admissible   each touching interface opens towards the side of its pivot,
//   impulse admissible         each pivot pushes, and the impulse of each closed interface acts inside its
//   width.
//
// Law `paper` (Spanos et al. 2001, Sections 3 and 4) tries, in this order, and takes the first that is
// kinematically admissible:
//   open     every touching interface pivots about the side that the impact comes from: patterns 1 and 2;
//   joined   only the interface that impacts does so, the others stay closed: 3a → 3b and 4a → 4b;
//   closed   every touching interface closes: pattern 3 after an impact between the blocks, Eqs. (84) and
//   (125). The
//            paper is silent where the base would have to leave the ground on the wrong side; this is where
//            it lands.
//
// Law `consistent` takes the pattern that is admissible both ways. There is at most one: no slip is linear
// and the corners' gaps are one-sided, so the velocities after are the nearest point of a convex cone to
// those before, and the conditions are those of that nearest point. Where the nearest point lifts a block off
// no pattern is consistent; the law then falls back on the paper's order and the event says so.

/// An impact about to happen: the state just before, with the relative angles of `impacting` interfaces zero.
template <class Real, int N = Eigen::Dynamic>
struct Impact {
  State<Real, N> before;
  Interfaces impacting;

  /// Interfaces that touch along their whole width.
  Interfaces touching() const {
    Interfaces result = impacting;
    for (int k = 0; k < before.pattern.size; ++k) {
      if (before.pattern[k] == Contact::closed) result.set(static_cast<std::size_t>(k));
    }
    return result;
  }
};

/// The velocities that follow if `pattern` does, in rad/s, and the impulses that bring them about, in N·s.
template <class Real, int N>
Outcome<Real, N> velocities_after(const Model<Real, N>& model, const Impact<Real, N>& impact,
                                  const Pattern& pattern) {
  const State<Real, N>& before = impact.before;
  const Vector<Real, N> rates = absolute(before.velocities);
  const Motion<Real, N> motion{centre_velocities(chain_at(model, before.pattern, before.angles), rates),
                               rates};
  const Chain<Real, N> chain = chain_at(model, pattern, before.angles);
  return respond(model, pattern, before.angles, chain, motion);
}

/// True where every touching interface that is open opens towards its side.
template <class Real, int N>
bool kinematically_admissible(const Outcome<Real, N>& outcome, const Interfaces& touching) {
  for (int k = 0; k < outcome.pattern.size; ++k) {
    if (!touching.test(static_cast<std::size_t>(k)) || outcome.pattern[k] == Contact::closed) continue;
    if (!(Real(sign(outcome.pattern[k])) * outcome.relative[k] > 0)) return false;
  }
  return true;
}

/// The pattern that is admissible both ways, if there is one.
template <class Real, int N>
std::optional<Outcome<Real, N>> consistent_outcome(const Model<Real, N>& model,
                                                   const Impact<Real, N>& impact) {
  auto outcome =
      find_admissible(model.stack, impact.before.pattern, impact.touching(), Real(0),
                      [&](const Pattern& pattern) { return velocities_after(model, impact, pattern); });
  if (outcome && !pushes(*outcome)) outcome.reset();
  return outcome;
}

/// The paper's order: open, joined, closed.
template <class Real, int N>
Outcome<Real, N> paper_outcome(const Model<Real, N>& model, const Impact<Real, N>& impact) {
  const Interfaces touching = impact.touching();
  int lowest = 0;
  while (!impact.impacting.test(static_cast<std::size_t>(lowest))) ++lowest;
  const Contact side = opposite(impact.before.pattern[lowest]);
  Pattern open = impact.before.pattern;
  Pattern joined = impact.before.pattern;
  Pattern closed = impact.before.pattern;
  for (int k = 0; k < open.size; ++k) {
    const auto bit = static_cast<std::size_t>(k);
    if (!touching.test(bit)) continue;
    const bool impacts = impact.impacting.test(bit);
    open[k] = impacts ? opposite(impact.before.pattern[k]) : side;
    joined[k] = impacts ? open[k] : Contact::closed;
    closed[k] = Contact::closed;
  }
  for (const Pattern& pattern : {open, joined}) {
    Outcome<Real, N> outcome = velocities_after(model, impact, pattern);
    if (kinematically_admissible(outcome, touching)) return outcome;
  }
  return velocities_after(model, impact, closed);
}

/// What follows an impact under a law, and whether it is the consistent pattern.
template <class Real, int N = Eigen::Dynamic>
struct Resolution {
  Outcome<Real, N> outcome;
  Consistency consistency;
};

template <class Real, int N>
Resolution<Real, N> resolve(const Model<Real, N>& model, const Impact<Real, N>& impact, Law law) {
  const auto consistent = consistent_outcome(model, impact);
  if (law == Law::consistent && consistent) return {*consistent, Consistency::consistent};
  const Outcome<Real, N> chosen = paper_outcome(model, impact);
  if (!consistent) return {chosen, Consistency::none};
  return {chosen, chosen.pattern == consistent->pattern ? Consistency::consistent : Consistency::other};
}

}  // namespace rockstack
