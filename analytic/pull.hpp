#pragma once

#include "analytic/ground_pieces.hpp"
#include "analytic/polynomial.hpp"

namespace rockstack {

/// Adds amplitude · sin(phase + turn · s) to a series, from sin' = cos and cos' = −sin.
template <class Real>
void add_sine(Polynomial<Real>& series, const Real& amplitude, const Real& phase, const Real& turn) {
  using std::cos;
  using std::sin;
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
  using std::exp;
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

/// A pulse from `elapsed` s after its start on, over `length` s.
template <class Real>
Polynomial<Real> series_of(const Pulse& pulse, const Real& elapsed, const Real& length) {
  const Real amplitude(pulse.amplitude);
  const Real turn = 2 * pi<Real> / Real(pulse.period);
  Polynomial<Real> series;
  if (pulse.shape == PulseShape::rectangle) return {amplitude};
  series.terms = max_terms<Real>;
  std::fill(series.begin(), series.end(), Real(0));
  switch (pulse.shape) {
    case PulseShape::sine:
    case PulseShape::half_sine:
      add_sine<Real>(series, amplitude, turn * elapsed, turn * length);
      break;
    case PulseShape::cosine:
      add_sine<Real>(series, amplitude, turn * elapsed + pi<Real> / 2, turn * length);
      break;
    case PulseShape::ricker:
      add_ricker<Real>(series, amplitude, turn / 2 * (elapsed - 2 * Real(pulse.period)), turn / 2 * length);
      break;
    case PulseShape::mavroeidis_papageorgiou: {
      // The products of its sines as sums: the carrier, and the two bands beside it.
      const Real cycles(pulse.cycles);
      const Real s = elapsed - cycles * Real(pulse.period) / 2;
      for (const int band : {-1, 0, 1}) {
        const Real share = band == 0 ? Real(-1) / 2 : -(1 + Real(band) / cycles) / 4;
        const Real rate = turn * (1 + Real(band) / cycles);
        add_sine<Real>(series, amplitude * share, rate * s + Real(pulse.phase), rate * length);
      }
      break;
    }
    case PulseShape::rectangle:
      break;
  }
  return series;
}

/// What pulls at every unit of mass in the frame of the ground, (−ẍg, −(g + ÿg)), over one step, times its
/// length squared, m.
template <class Real>
struct Pull {
  Polynomial<Real> x, y;
};

/// A component of it, from `offset` s into the ground's course on: of the course and of what pulls `at_rest`,
/// without the last coefficients where they are negligible, m/s².
template <class Real>
Polynomial<Real> pull_along(const GroundCourse<Real>& course, const Real& at_rest, const Real& negligible,
                            const Real& offset, const Real& length) {
  using std::abs;
  const Real scale = -(length * length);
  if (!course.pulse) [[likely]] {
    const Real first = (course.line_at(offset) + at_rest) * scale;
    const Real change = course.rate * length;
    if (abs(change) <= negligible) return {first};
    return {first, change * scale};
  }
  Polynomial<Real> series = series_of<Real>(*course.pulse, course.elapsed + offset, length);
  series[0] += at_rest;
  while (series.terms > 1 && abs(series[series.terms - 1]) <= negligible) --series.terms;
  for (Real& coefficient : series) coefficient *= scale;
  return series;
}

template <class Real>
Pull<Real> make_pull(const Real& gravity, const GroundPiece<Real>& piece, const Real& offset,
                     const Real& length) {
  const Real negligible = std::numeric_limits<Real>::epsilon() / 8 * gravity;
  return {pull_along<Real>(piece.horizontal, 0, negligible, offset, length),
          pull_along<Real>(piece.vertical, gravity, negligible, offset, length)};
}

/// The pull over a step `ratio` times as long.
template <class Real>
void shorten(Pull<Real>& pull, const Real& ratio) {
  for (Polynomial<Real>* series : {&pull.x, &pull.y}) {
    rescale(*series, ratio);
    for (Real& coefficient : *series) coefficient *= ratio * ratio;
  }
}

}  // namespace rockstack
