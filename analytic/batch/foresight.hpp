#pragma once

#include "analytic/mechanics/impact.hpp"

namespace rockstack {

/// What follows the impacts of a pack, as resolve() tells of one: where the interface that impacts alone goes
/// on to its other side, and the others stay as they are. Patterns are in sides; the solution's has no value.
template <class Real, int N>
struct ImpactPrediction {
  PredictedImpact<Real, N> impact;
  Truth<Real> holds;  ///< whether this follows under either law
};

/// From the sides and the relative velocities before, at directions with the impacting angles zero.
template <class Real, int N>
ImpactPrediction<Real, N> foresee(const Model<Real, N>& model, const PerBlock<Real, N>& sides,
                                  const Vector<Real, N>& velocities, const Directions<Real, N>& directions,
                                  const PerBlock<Truth<Real>, N>& impacting) {
  const Stack<Real, N>& stack = model.stack;
  const Vector<Real, N> rates = absolute(velocities);
  const Motion<Real, N> motion{centre_velocities(make_chain(stack, sides, directions), rates), rates};
  PerBlock<Real, N> thrown;
  Real other_side = 0;
  for (std::size_t k = 0; k < thrown.size(); ++k) {
    thrown[k] = select(impacting[k], -sides[k], sides[k]);
    other_side = select(impacting[k], thrown[k], other_side);
  }
  const Chain<Real, N> chain = make_chain(stack, thrown, directions);
  const NearestMotion<Real, N> after = nearest_motion(stack, thrown, chain, motion);
  ImpactPrediction<Real, N> result{
      {{directions, motion},
       solution_for<Real, N>(model, {}, directions, chain, motion,
                             Eigen::Map<const Vector<Real, N>>(after.relative.data()))},
      after.well_conditioned};
  const PatternSolution<Real, N>& solution = result.impact.solution;
  // What is clearly pressed inside its width does not open under the paper's first trial either. That trial
  // and this pattern pivot about the same corners; where the one parts, or the other presses, it is the
  // nearest motion of one cone, those that turn away from these corners, and there is one.
  for (std::size_t k = 0; k < thrown.size(); ++k) {
    const auto closed = (sides[k] == Real(0)) & (other_side != Real(0));
    const Margins<Real> margin = margins(stack, solution.reactions, static_cast<int>(k));
    const Real edge = solution.rounding[k] * stack.half_width[k];
    result.holds = result.holds & (solution.reactions.normal[k] >= -solution.rounding[k]) &
                   (~closed | ((margin.right > edge) & (margin.left > edge))) &
                   (~impacting[k] | (thrown[k] * after.relative[k] > Real(0)));
  }
  return result;
}

}  // namespace rockstack
