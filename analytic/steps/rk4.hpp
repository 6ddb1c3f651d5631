#pragma once

#include "analytic/scene/solve_options.hpp"
#include "analytic/steps/dense_output.hpp"
#include "analytic/steps/ground_pieces.hpp"

namespace rockstack {

/// Makes steps by the classical fourth-order Runge–Kutta method from the general rule (dynamics.hpp): the
/// baseline, and an answer independent of the Taylor series.
template <class Real, int N>
class Rk4Steps {
 public:
  /// Keeps a reference to `model`.
  Rk4Steps(const Model<Real, N>& model, const SolveOptions& options) : model_(model), step_(options.step) {}

  /// A step from `offset` into a ground piece, no longer than `remaining`, with margins of `watched`
  /// interfaces: the quintic that has the angle, velocity and acceleration of both its ends. Its error, of
  /// order length⁶, stays below the method's own. The increments enter as they are, not as differences of end
  /// states, so that motions that start from zero keep their relative precision.
  DenseOutput<Real, N> operator()(const State<Real, N>& state, const Directions<Real, N>& directions,
                                  const Linkage<Real, N>&, const GroundPiece<Real>& piece, const Real& offset,
                                  const Real& remaining, const Interfaces& watched) const {
    // A stack at rest needs no steps where the ground's straight line alone decides when it opens.
    const bool whole = is_closed(state.pattern) && piece.straight();
    const Real length = whole ? remaining : remaining / ceil(remaining / step_);
    DenseOutput<Real, N> output = free_motion(state, directions, piece, offset, length);
    if (watched.any()) add_margins(piece, offset, watched, output);
    return output;
  }

 private:
  static constexpr std::size_t nodes = 5;  ///< points of a step at which margins are evaluated

  DenseOutput<Real, N> free_motion(const State<Real, N>& state, const Directions<Real, N>& directions,
                                   const GroundPiece<Real>& piece, const Real& offset,
                                   const Real& length) const {
    const auto derivative = [&](const Vector<Real, N>& angles, const Vector<Real, N>& velocities,
                                const Real& tau) {
      return accelerations(model_, State<Real, N>{state.pattern, angles, velocities}, piece.at(offset + tau));
    };
    const Real half = length / 2;
    const Vector<Real, N>& start = state.velocities;
    const Vector<Real, N> a1 = accelerations(model_, state, directions, piece.at(offset));
    const Vector<Real, N> v2 = start + half * a1;
    const Vector<Real, N> a2 = derivative(state.angles + half * start, v2, half);
    const Vector<Real, N> v3 = start + half * a2;
    const Vector<Real, N> a3 = derivative(state.angles + half * v2, v3, half);
    const Vector<Real, N> v4 = start + length * a3;
    const Vector<Real, N> a4 = derivative(state.angles + length * v3, v4, length);
    // Increments beyond uniform motion: of the mean velocity over the step, and of the velocity at its end.
    const Vector<Real, N> mean = length / 6 * (a1 + a2 + a3);
    const Vector<Real, N> gain = length / 6 * (a1 + 2 * (a2 + a3) + a4);
    const Vector<Real, N> end = derivative(state.angles + length * (start + mean), start + gain, length);

    DenseOutput<Real, N> output{length, state, {}, {}};
    for (int k = 0; k < state.pattern.size; ++k) {
      if (state.pattern[k] == Contact::closed) continue;
      const Real curve = length * a1[k] / 2;
      const Real last = length * end[k];
      output.angles[k] = {state.angles[k],
                          length * start[k],
                          length * curve,
                          length * (10 * mean[k] - 4 * gain[k] - 3 * curve + last / 2),
                          length * (7 * gain[k] - 15 * mean[k] + 3 * curve - last),
                          length * (6 * mean[k] - 3 * gain[k] - curve + last / 2)};
    }
    return output;
  }

  /// The quartics through five points of the step.
  void add_margins(const GroundPiece<Real>& piece, const Real& offset, const Interfaces& watched,
                   DenseOutput<Real, N>& output) const {
    std::array<std::array<Real, nodes>, capacity(N)> right, left;
    for (std::size_t i = 0; i < nodes; ++i) {
      const Real s = Real(i) / Real(nodes - 1);
      const auto solution = accelerate(model_, output.at(s), piece.at(offset + s * output.length));
      for (int k = 0; k < output.start.pattern.size; ++k) {
        const Margins<Real> margin = margins(model_.stack, solution.reactions, k);
        right[k][i] = margin.right;
        left[k][i] = margin.left;
      }
    }
    for (std::size_t k = 0; k < right.size(); ++k)
      if (watched.test(k)) output.margins[k] = {quartic_through(right[k]), quartic_through(left[k])};
  }

  const Model<Real, N>& model_;
  Real step_;
};

}  // namespace rockstack
