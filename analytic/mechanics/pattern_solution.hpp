#pragma once

#include <functional>
#include <utility>

#include "analytic/mechanics/dynamics.hpp"

namespace rockstack {

/// What each interface carries from the block below to the block above, per interface: forces in N and
/// moments in N·m, or impulses in N·s and N·m·s.
template <class Real, int N = Eigen::Dynamic>
struct Reactions {
  Vector<Real, N> normal;      ///< along the normal of the face, pushing positive
  Vector<Real, N> tangential;  ///< along the face, to the right positive
  Vector<Real, N> moment;      ///< clockwise, about the pivot, or about the middle where closed
};

/// Newton–Euler from the top down: what has to act for the blocks to move by `change` more than they freely
/// would. Asked for so often that calls count, as below.
template <class Real, int N>
[[gnu::always_inline]] inline Reactions<Real, N> reactions(const Model<Real, N>& model,
                                                           const Chain<Real, N>& chain,
                                                           const Directions<Real, N>& directions,
                                                           const Motion<Real, N>& change) {
  const Stack<Real, N>& stack = model.stack;
  const int size = stack.size();
  const Vector<Real, N> zero = Vector<Real, N>::Zero(size);
  Reactions<Real, N> result{zero, zero, zero};
  Point<Real> force = Point<Real>::Zero();
  Real moment = 0;
  for (int k = size - 1; k >= 0; --k) {
    const Point<Real> own = stack.mass[k] * change.centre.col(k);
    moment += stack.inertia[k] * change.rotation[k] + quarter_turned<Real>(chain.arms.col(k)).dot(own) +
              quarter_turned<Real>(chain.links.col(k)).dot(force);
    force += own;
    const auto along_face = [&](const Vector<Real, N>& entries, const Real& ground) {
      return k == 0 ? ground : select(stack.overhangs[k], entries[k], entries[k - 1]);
    };
    const Real cosine = along_face(directions.cosine, 1);
    const Real sine = along_face(directions.sine, 0);
    // Small angles leave out what is of second order.
    result.normal[k] = (stack.small_angles ? Real(0) : force.x() * sine) + force.y() * cosine;
    result.tangential[k] = force.x() * cosine - force.y() * sine;
    result.moment[k] = moment;
  }
  return result;
}

/// How far the centre of pressure of a closed interface is from either end, times the normal force: N (w − x)
/// and N (w + x), N·m. It opens about an end where that is negative, as where it would have to pull.
template <class Real>
struct Margins {
  Real right;
  Real left;
};

template <class Real, int N>
Margins<Real> margins(const Stack<Real, N>& stack, const Reactions<Real, N>& reaction, int interface) {
  const Real push = reaction.normal[interface] * stack.half_width[interface];
  return {push + reaction.moment[interface], push - reaction.moment[interface]};
}

/// What a pattern leads to: relative accelerations and forces, or relative velocities and impulses.
template <class Real, int N = Eigen::Dynamic>
struct PatternSolution {
  Pattern pattern;
  Vector<Real, N> relative;      ///< φ̈ in rad/s², or φ̇ in rad/s; zero at closed interfaces
  Reactions<Real, N> reactions;  ///< N and N·m, or N·s and N·m·s
  Vector<Real, N> rounding;      ///< reactions below this are rounding of what stands above, N or N·s

  int size() const { return N == Eigen::Dynamic ? pattern.size : N; }
};

/// A motion that the pattern allows, and what brings it about in place of `free`, with any bias taken off.
template <class Real, int N>
[[gnu::always_inline]] inline PatternSolution<Real, N> solution_for(
    const Model<Real, N>& model, const Pattern& pattern, const Directions<Real, N>& directions,
    const Chain<Real, N>& chain, const Motion<Real, N>& free, const Vector<Real, N>& relative_motion) {
  const Vector<Real, N> rotation = absolute(relative_motion);
  const Motion<Real, N> change{centre_velocities(chain, rotation) - free.centre, rotation - free.rotation};
  Vector<Real, N> rounding = free.centre.colwise().norm().transpose().cwiseProduct(model.stack.mass);
  sum_from_top(rounding);
  rounding *= Real(1024 * std::numeric_limits<Number<Real>>::epsilon());
  return {pattern, relative_motion, reactions(model, chain, directions, change), rounding};
}

/// The allowed motion nearest to `free` (with any bias already taken off) and what brings it about.
template <class Real, int N>
[[gnu::always_inline]] inline PatternSolution<Real, N> respond(const Model<Real, N>& model,
                                                               const Pattern& pattern,
                                                               const Directions<Real, N>& directions,
                                                               const Chain<Real, N>& chain,
                                                               const Motion<Real, N>& free) {
  return solution_for<Real, N>(model, pattern, directions, chain, free,
                               nearest_allowed(model.stack, pattern, chain, free));
}

/// The accelerations of a moving stack and the forces it is under; `directions` are directions_at() the
/// state.
template <class Real, int N>
PatternSolution<Real, N> accelerate(const Model<Real, N>& model, const State<Real, N>& state,
                                    const Directions<Real, N>& directions,
                                    const std::type_identity_t<Loading<Real>>& loading) {
  const Chain<Real, N> chain = make_chain(model.stack, state.pattern, directions);
  return respond(model, state.pattern, directions, chain,
                 free_acceleration(model, state, directions, chain, loading));
}

template <class Real, int N>
PatternSolution<Real, N> accelerate(const Model<Real, N>& model, const State<Real, N>& state,
                                    const std::type_identity_t<Loading<Real>>& loading) {
  return accelerate(model, state, directions_at(model, state.angles), loading);
}

/// A touching interface whose condition fails, and the contact that would mend it.
struct Violation {
  int interface;
  Contact mend;
};

/// The lowest touching interface that is open and moves into itself (by more than `slack`, in the unit of the
/// relative motion), or is closed with its centre of pressure outside.
template <class Real, int N>
std::optional<Violation> first_violation(const Stack<Real, N>& stack,
                                         const PatternSolution<Real, N>& solution, const Interfaces& touching,
                                         const Real& slack) {
  for (int k = 0; k < solution.size(); ++k) {
    if (!touching.test(k)) continue;
    const Contact contact = solution.pattern[k];
    if (contact == Contact::closed) {
      const Margins<Real> margin = margins(stack, solution.reactions, k);
      const Real least = -solution.rounding[k] * stack.half_width[k];
      if (margin.right < least && margin.right <= margin.left) return Violation{k, Contact::right};
      if (margin.left < least) return Violation{k, Contact::left};
    } else if (Real(sign(contact)) * solution.relative[k] < -slack) {
      return Violation{k, Contact::closed};
    }
  }
  return std::nullopt;
}

/// The closed interfaces that would open about either end, as they would have to pull.
template <class Real, int N>
Interfaces pulled_apart(const Stack<Real, N>& stack, const PatternSolution<Real, N>& solution) {
  Interfaces result;
  for (int k = 0; k < solution.size(); ++k) {
    const Margins<Real> margin = margins(stack, solution.reactions, k);
    const Real least = -solution.rounding[k] * stack.half_width[k];
    result.set(k, solution.pattern[k] == Contact::closed && margin.right < least && margin.left < least);
  }
  return result;
}

inline Pattern with_closed(Pattern pattern, const Interfaces& closed) {
  for (int k = 0; k < pattern.size; ++k)
    if (closed.test(k)) pattern[k] = Contact::closed;
  return pattern;
}

/// A pattern, and of those with interfaces of `either` on their other sides all that are admissible, up to 64
/// in all.
template <class Admissible>
std::vector<Pattern> with_other_sides(const Pattern& pattern, const Interfaces& either,
                                      const Admissible& is_admissible) {
  constexpr std::size_t most = 64;
  std::vector<Pattern> ways{pattern};
  for (int k = 0; k < pattern.size; ++k) {
    const std::size_t known = either.test(k) && ways.size() < most ? ways.size() : 0;
    for (std::size_t i = 0; i < known; ++i) {
      ways.push_back(ways[i]);
      ways.back()[k] = opposite(ways.back()[k]);
    }
  }
  const auto others = ways.begin() + 1;
  ways.erase(std::remove_if(others, ways.end(), std::not_fn(is_admissible)), ways.end());
  return ways;
}

/// Principal pivoting: changes what violates, lowest interface first or all at once, until nothing does.
/// Leaves in `pattern` where the attempts ended. An interface that opens because its centre of pressure is
/// outside moves apart, as the mass matrix is positive; where it moves into itself though nothing else has
/// changed, both are rounding, and it stays open.
template <class Real, int N, class Evaluate>
std::optional<PatternSolution<Real, N>> mend_violations(const Stack<Real, N>& stack, Pattern& pattern,
                                                        const Interfaces& touching, const Real& slack,
                                                        bool at_once, int attempts,
                                                        const Evaluate& evaluate) {
  int opened = -1;  // by the last change
  while (attempts-- > 0) {
    const PatternSolution<Real, N> solution = evaluate(pattern);
    Interfaces others = touching;
    auto violation = first_violation(stack, solution, others, slack);
    if (violation && violation->interface == opened) {
      others.reset(opened);
      violation = first_violation(stack, solution, others, slack);
    }
    if (!violation) return solution;
    opened = violation->mend == Contact::closed || at_once ? -1 : violation->interface;
    do {
      pattern[violation->interface] = violation->mend;
      others.reset(violation->interface);
      if (at_once) violation = first_violation(stack, solution, others, slack);
    } while (at_once && violation);
  }
  return std::nullopt;
}

/// Every pattern in which touching interfaces stay closed or pivot either way; the lowest changes fastest.
inline std::vector<Pattern> candidates(const Pattern& pattern, const Interfaces& touching) {
  std::vector<Pattern> list{pattern};
  for (int k = 0; k < pattern.size; ++k) {
    if (!touching.test(k)) continue;
    std::vector<Pattern> longer;
    for (const Contact contact : {Contact::closed, Contact::right, Contact::left})
      for (const Pattern& candidate : list) longer.emplace_back(candidate)[k] = contact;
    list = std::move(longer);
  }
  return list;
}

/// Finds a pattern without violations among those in which the touching interfaces may pivot either way or
/// stay closed, by principal pivoting from a first guess. One interface at a time, two changes each are
/// usual, but in long stacks their number may double with every interface; there all at once are quicker, but
/// may go in circles. Of up to six touching interfaces all patterns are tried at last. `evaluate` maps a
/// pattern to its solution. Nothing is found where blocks would have to lift off.
template <class Real, int N, class Evaluate>
std::optional<PatternSolution<Real, N>> find_admissible(const Stack<Real, N>& stack, Pattern pattern,
                                                        const Interfaces& touching, const Real& slack,
                                                        const Evaluate& evaluate) {
  const int few = 4 * pattern.size;
  auto found = mend_violations(stack, pattern, touching, slack, false, few, evaluate);
  if (!found) found = mend_violations(stack, pattern, touching, slack, true, few, evaluate);
  if (!found) found = mend_violations(stack, pattern, touching, slack, false, 4 * few, evaluate);
  if (found || touching.count() > 6) return found;
  for (const Pattern& candidate : candidates(pattern, touching)) {
    const PatternSolution<Real, N> solution = evaluate(candidate);
    if (!first_violation(stack, solution, touching, slack)) return solution;
  }
  return std::nullopt;
}

/// True where no interface is pulled at.
template <class Real, int N>
bool pushes(const PatternSolution<Real, N>& solution) {
  return (solution.reactions.normal.array() >= -solution.rounding.array()).all();
}

}  // namespace rockstack
