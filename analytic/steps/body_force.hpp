#pragma once

#include "analytic/polynomials/polynomial.hpp"
#include "analytic/steps/ground_pieces.hpp"

namespace rockstack {

// No step is longer than its series holds: what a series leaves out is below the rounding of what it tells,
// or the step is shorter. Of a motion the last coefficients tell (TaylorSteps). Of a pulse f there is a
// bound: by Lagrange's remainder, m terms over a length h leave out sup|f⁽ᵐ⁾| hᵐ/m! at most. With A the
// amplitude, T the period and ω = 2π/T, sup|f⁽ᵐ⁾| ≤ A ωᵐ for a sine, and ≤ A (ω(1 + 1/γ))ᵐ for the three of
// Mavroeidis & Papageorgiou, whose amplitudes add up to A. Ricker's pulse is −A/2 d²/dz² exp(−z²) with z' =
// ω/2, so that its derivatives are Hermite's functions, A/2 |Hₘ₊₂(z)| exp(−z²) (ω/2)ᵐ, and by Cramér's
// inequality |Hₙ(z)| exp(−z²/2) ≤ 1.0865 √(2ⁿ n!) (Abramowitz & Stegun 1964, 22.14.17).

/// What is left out of a pulse's series, over its amplitude: at most this, and for each term that is dropped.
template <class Real>
Real left_out() {
  return std::numeric_limits<Real>::epsilon() / 8;
}

/// The largest x with bound · xᵐ/m! ≤ left_out(), m = max_orders.
template <class Real>
Real convergent(const Real& bound) {
  Real power = left_out<Real>() / bound;
  for (std::size_t i = 2; i <= max_orders<Real>; ++i) power *= Real(i);
  return pow(power, 1 / Real(max_orders<Real>));
}

/// Largest x of a sine, and largest z of Ricker's pulse, whose series leave no more out.
template <class Real>
inline const Real convergent_sine = convergent(Real(1));
template <class Real>
inline const Real convergent_ricker = [] {
  Real square = 1;  // 2ⁿ n!, n = m + 2
  for (std::size_t i = 1; i <= max_orders<Real> + 2; ++i) square *= 2 * Real(i);
  return convergent<Real>(Real(1.0865) / 2 * sqrt(square));
}();

/// How long a step may be at most for a pulse's series to hold, s.
template <class Real>
Real longest_series(const Pulse& pulse) {
  const Real turn = 2 * pi<Real> / Real(pulse.period);
  if (pulse.shape == PulseShape::rectangle) return std::numeric_limits<Real>::infinity();
  if (pulse.shape == PulseShape::ricker) return convergent_ricker<Real> / (turn / 2);
  if (pulse.shape == PulseShape::mavroeidis_papageorgiou)
    return convergent_sine<Real> / (turn * (1 + 1 / Real(pulse.cycles)));
  return convergent_sine<Real> / turn;
}

/// Longest series of a ground piece.
template <class Real>
Real longest_series(const GroundPiece<Real>& piece) {
  Real longest = std::numeric_limits<Real>::infinity();
  for (const Pulse* pulse : {piece.horizontal.pulse, piece.vertical.pulse})
    if (pulse) longest = std::min(longest, longest_series<Real>(*pulse));
  for (const GroundComponent<Real>& push : piece.pushes)
    if (push.pulse) longest = std::min(longest, longest_series<Real>(*push.pulse));
  return longest;
}

/// Adds amplitude · sin(phase + turn · s) to a series, from sin' = cos and cos' = −sin.
template <class Real>
void add_sine(Polynomial<Real>& series, const Real& amplitude, const Real& phase, const Real& turn) {
  Real coefficient = amplitude * sin(phase);
  Real next = amplitude * cos(phase) * turn;
  for (std::size_t i = 0; i < series.terms; ++i) {
    series[i] += coefficient;
    const Real after = -coefficient * turn * turn / Real((i + 1) * (i + 2));
    coefficient = next;
    next = after;
  }
}

/// Adds amplitude (1 − 2z²) exp(−z²), z = start + rate · s: with e = exp(−z²), e' = −2 z z' e.
template <class Real>
void add_ricker(Polynomial<Real>& series, const Real& amplitude, const Real& start, const Real& rate) {
  Polynomial<Real> bell;
  bell[0] = amplitude * exp(-start * start);
  const auto earlier = [&](std::size_t i, std::size_t by) { return i < by ? Real(0) : bell[i - by]; };
  for (std::size_t i = 0; i < series.terms; ++i) {
    series[i] += (1 - 2 * start * start) * bell[i] - 4 * start * rate * earlier(i, 1) -
                 2 * rate * rate * earlier(i, 2);
    if (i + 1 < series.terms)
      bell[i + 1] = -2 * rate * (start * bell[i] + rate * earlier(i, 1)) / Real(i + 1);
  }
}

/// A pulse from `elapsed` s after its start on, over `length` s, at most longest_series(); without the last
/// coefficients where they are negligible.
template <class Real>
Polynomial<Real> series_of(const Pulse& pulse, const Real& elapsed, const Real& length) {
  const Real amplitude(pulse.amplitude);
  const Real turn = 2 * pi<Real> / Real(pulse.period);
  Polynomial<Real> series;
  if (pulse.shape == PulseShape::rectangle) return {amplitude};
  series.terms = max_orders<Real>;
  std::fill(series.begin(), series.end(), Real(0));
  if (pulse.shape == PulseShape::ricker) {
    add_ricker<Real>(series, amplitude, turn / 2 * (elapsed - 2 * Real(pulse.period)), turn / 2 * length);
  } else if (pulse.shape == PulseShape::mavroeidis_papageorgiou) {
    // The products of its sines as sums: the carrier, and the two bands beside it.
    const Real cycles(pulse.cycles);
    const Real s = elapsed - cycles * Real(pulse.period) / 2;
    for (const int band : {-1, 0, 1}) {
      const Real share = band == 0 ? Real(-1) / 2 : -(1 + Real(band) / cycles) / 4;
      const Real rate = turn * (1 + Real(band) / cycles);
      add_sine<Real>(series, amplitude * share, rate * s + Real(pulse.phase), rate * length);
    }
  } else if (pulse.shape == PulseShape::cosine) {
    add_sine<Real>(series, amplitude, turn * elapsed + pi<Real> / 2, turn * length);
  } else {
    add_sine<Real>(series, amplitude, turn * elapsed, turn * length);
  }
  const Real negligible = left_out<Real>() * abs(amplitude);
  while (series.terms > 1 && abs(series[series.terms - 1]) <= negligible) --series.terms;
  return series;
}

/// The body force on a unit of mass in the frame of the ground, (−ẍg, −(g + ÿg)), over one step, times the
/// length squared of the step, m; and the sizes of pushes, likewise, N·s².
template <class Real>
struct ScaledBodyForce {
  Polynomial<Real> x, y;
  std::vector<Polynomial<Real>> pushes = {};

  /// How many terms tell all of it.
  std::size_t terms() const {
    std::size_t most = std::max(x.terms, y.terms);
    for (const Polynomial<Real>& push : pushes) most = std::max(most, push.terms);
    return most;
  }
};

/// A component of it, from `offset` s into the ground's motion on: of that and of what acts `at_rest`,
/// without a change that is negligible, m/s².
template <class Real>
Polynomial<Real> body_force_along(const GroundComponent<Real>& component, const Real& at_rest,
                                  const Real& negligible, const Real& offset, const Real& length) {
  const Real scale = -(length * length);
  if (!component.pulse) [[likely]] {
    const Real first = (component.line_at(offset) + at_rest) * scale;
    const Real change = component.rate * length;
    if (abs(change) <= negligible) return {first};
    return {first, change * scale};
  }
  Polynomial<Real> series = series_of<Real>(*component.pulse, component.elapsed + offset, length);
  series[0] += at_rest + component.value;
  for (Real& coefficient : series) coefficient *= scale;
  return series;
}

/// A change of acceleration that is left out, m/s².
template <class Real>
Real negligible_change(const Real& gravity) {
  return std::numeric_limits<Real>::epsilon() / 8 * gravity;
}

template <class Real>
ScaledBodyForce<Real> scaled_body_force(const Real& gravity, const GroundPiece<Real>& piece,
                                        const Real& offset, const Real& length) {
  const Real negligible = negligible_change(gravity);
  ScaledBodyForce<Real> scaled{body_force_along<Real>(piece.horizontal, 0, negligible, offset, length),
                               body_force_along<Real>(piece.vertical, gravity, negligible, offset, length)};
  for (const GroundComponent<Real>& push : piece.pushes)
    scaled.pushes.push_back(times(-1, body_force_along<Real>(push, 0, 0, offset, length)));
  return scaled;
}

/// The body force over a step `ratio` times as long.
template <class Real>
void shorten(ScaledBodyForce<Real>& body_force, const Real& ratio) {
  const auto shorten_series = [&](Polynomial<Real>& series) {
    rescale(series, ratio);
    for (Real& coefficient : series) coefficient *= ratio * ratio;
  };
  shorten_series(body_force.x);
  shorten_series(body_force.y);
  for (Polynomial<Real>& push : body_force.pushes) shorten_series(push);
}

}  // namespace rockstack
