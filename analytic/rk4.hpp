#pragma once

#include "analytic/flow.hpp"
#include "analytic/ground_pieces.hpp"

namespace rockstack {

/// One step of the classical fourth-order Runge–Kutta method from `offset` into a ground piece, with the
/// quintic that has the angle, velocity and acceleration of both its ends: its error, of order length⁶, stays
/// below the method's own. The increments enter as they are, not as differences of end states, so that
/// motions that start from zero keep their relative precision.
///
/// An interface that has just opened accelerates towards its side; `fresh` holds those whose acceleration may
/// round to the other one.
template <class Real>
Flow<Real> rk4_step(const Model<Real>& model, const State<Real>& state, const GroundPiece<Real>& piece,
                    const Real& offset, const Real& length, const Interfaces& fresh) {
  const auto derivative = [&](const Vector<Real>& angles, const Vector<Real>& velocities, const Real& tau) {
    return accelerations(model, State<Real>{state.pattern, angles, velocities}, piece.at(offset + tau));
  };
  const Real half = length / 2;
  const Vector<Real>& start = state.velocities;
  const Vector<Real> a1 = derivative(state.angles, start, Real(0));
  const Vector<Real> v2 = start + half * a1;
  const Vector<Real> a2 = derivative(state.angles + half * start, v2, half);
  const Vector<Real> v3 = start + half * a2;
  const Vector<Real> a3 = derivative(state.angles + half * v2, v3, half);
  const Vector<Real> v4 = start + length * a3;
  const Vector<Real> a4 = derivative(state.angles + length * v3, v4, length);
  // Increments beyond uniform motion: of the mean velocity over the step, and of the velocity at its end.
  const Vector<Real> mean = length / 6 * (a1 + a2 + a3);
  const Vector<Real> gain = length / 6 * (a1 + 2 * (a2 + a3) + a4);
  const Vector<Real> end =
      derivative(state.angles + length * (start + mean), Vector<Real>(start + gain), length);

  Flow<Real> flow{length, state, {}};
  for (int k = 0; k < state.pattern.size; ++k) {
    if (state.pattern[k] == Contact::closed) continue;
    Real first = length * a1[k];
    if (fresh.test(static_cast<std::size_t>(k)) && first * Real(sign(state.pattern[k])) < 0) first = 0;
    const Real last = length * end[k];
    const Real curve = first / 2;
    flow.angles[static_cast<std::size_t>(k)] = {state.angles[k],
                                                length * start[k],
                                                length * curve,
                                                length * (10 * mean[k] - 4 * gain[k] - 3 * curve + last / 2),
                                                length * (7 * gain[k] - 15 * mean[k] + 3 * curve - last),
                                                length * (6 * mean[k] - 3 * gain[k] - curve + last / 2)};
  }
  return flow;
}

}  // namespace rockstack
