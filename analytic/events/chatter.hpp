#pragma once

#include "analytic/mechanics/pattern_solution.hpp"

namespace rockstack {

/// Chatter, ever smaller impacts whose number is infinite, ends where an interface would part at a speed u
/// that takes it no further than the resolution ρ = u²/(2a), a the relative acceleration that brings it back:
/// it closes instead, and in any case at u = 500 ε √(g/H), with ε the rounding of 1 in double precision or ρ,
/// whichever is less, and H the stack's height. What is left out are excursions of at most ρ rad, or what
/// rounding makes of speeds. As the angular momentum above the other pivots is kept, by one impact as by the
/// many it stands for, the motion after it is off by some ρ at most; its closure is told at the end of that
/// chatter (collisions.hpp).
/// Where one interface chatters alone, the motion after it is off by less, in proportion to u³: the other
/// angles and their momenta are continuous through its impacts, flights change their rates by terms in φ̇, φ
/// and φ̇², φ̇ adds up to nothing over a flight, and ∫φ dt and ∫φ̇² dt go with u³ (zeno_summation.hpp makes use
/// of it). As each impact takes its share of the speed, the number of impacts is at most ln(u₀/u)/ln(1/η),
/// for a speed u₀ at first and a velocity ratio η.
///
/// Where several interfaces chatter together, each may do so to its end between two impacts of another. No
/// burst of events has been seen to exceed 2 ∏ (1 + nₖ), nₖ the bound of each alone with η the largest 1 −
/// 2mw²/I of what stands above it; this is not proved, as an impact may speed up another interface.
template <class Real, int N>
class EndOfChatter {
 public:
  /// Keeps a reference to `model`. `resolution` in rad, > 0.
  EndOfChatter(const Model<Real, N>& model, const Real& resolution) : model_(model), resolution_(resolution) {
    rate_ = model.gravity / (2 * model.stack.half_height.sum());
    slow_speed_ = 500 * std::min(resolution, Real(std::numeric_limits<double>::epsilon())) * sqrt(rate_);
    acceleration_gain_ = 2 * sqrt(model.stack.mass.sum() / model.stack.inertia.minCoeff());
    links_length_ = 2 * (model.stack.half_width + model.stack.half_height).sum();
  }

  /// No relative angle accelerates more, rad/s². By Gauss's principle a motion has no more energy than that
  /// of free blocks: Σ Iω̇² ≤ Σ m|a|², with a their body force less what is centripetal, ω² times all links at
  /// most.
  Real fastest_return(const State<Real, N>& state, const std::type_identity_t<Loading<Real>>& loading) const {
    Real effective_gravity = loading.ground.template lpNorm<1>() + model_.gravity;
    if (loading.pushes > 0 || !model_.restraints.empty())
      effective_gravity += effect_of_forces(state, loading);
    const Real rotation_rate = state.velocities.template lpNorm<1>();
    return acceleration_gain_ * (effective_gravity + rotation_rate * rotation_rate * links_length_);
  }

  /// Open by what rounding makes of angles and speeds: such interfaces close with the next that does, or two
  /// of them would push each other open for ever.
  bool negligibly_open(const State<Real, N>& state, int k) const {
    return state.pattern[k] != Contact::closed && abs(state.velocities[k]) <= slow_speed_ &&
           abs(state.angles[k]) * rate_ <= slow_speed_ * slow_speed_;
  }

  /// The pattern after an impact with the interfaces closed that part too slowly to be followed. `directions`
  /// are directions_at() the state.
  Pattern without_slow(const State<Real, N>& after, const Interfaces& touching,
                       const Directions<Real, N>& directions, const Loading<Real>& loading) const {
    Pattern pattern = after.pattern;
    const Real fastest = fastest_return(after, loading);
    for (int k = 0; k < after.size(); ++k) {
      if (!touching.test(k) || pattern[k] == Contact::closed) continue;
      const Real speed = abs(after.velocities[k]);
      bool slow = speed <= slow_speed_;
      if (!slow && speed * speed <= 2 * resolution_ * fastest) {
        const Vector<Real, N> back = accelerations(model_, after, directions, loading);
        slow = speed * speed <= -2 * resolution_ * back[k] * Real(sign(pattern[k]));
      }
      if (slow) pattern[k] = Contact::closed;
    }
    return pattern;
  }

 private:
  /// The acceleration of all masses that has as much of Σ m|a|² as applied forces make of free blocks, m/s².
  [[gnu::cold]] Real effect_of_forces(const State<Real, N>& state, const Loading<Real>& loading) const {
    const Directions<Real, N> directions = directions_at(model_, state.angles);
    const int size = model_.stack.size();
    Motion<Real, N> free{Points<Real, N>::Zero(2, size), Vector<Real, N>::Zero(size)};
    add_pushes(model_, directions, loading, free);
    add_restraints(model_, state, directions, make_chain(model_.stack, state.pattern, directions), free);
    Real sum = 0;
    for (int k = 0; k < size; ++k)
      sum += model_.stack.mass[k] * free.centre.col(k).squaredNorm() +
             model_.stack.inertia[k] * free.rotation[k] * free.rotation[k];
    return sqrt(sum / model_.stack.mass.sum());
  }

  const Model<Real, N>& model_;
  Real resolution_;           ///< rad
  Real rate_{};               ///< g/H, 1/s²
  Real slow_speed_{};         ///< rad/s
  Real acceleration_gain_{};  ///< relative angular acceleration to that of free blocks, at most, 1/m
  Real links_length_{};       ///< of all links together, at most, m
};

}  // namespace rockstack
