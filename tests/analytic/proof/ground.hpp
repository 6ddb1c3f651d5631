#pragma once

#include "tests/analytic/proof/exact_scene.hpp"

namespace rockstack::proof {

/// One term A sin(ωs + φ) of the ground's acceleration.
struct Wave {
  Ball amplitude, frequency, phase;
};

/// The ground's acceleration along one axis over a piece, m/s², s the time since its start: a straight line
/// and waves.
struct GroundLine {
  Ball value, slope;
  std::vector<Wave> waves;

  bool still() const { return waves.empty() && arb_is_zero(slope.data()); }
};

template <class Number>
Number acceleration(const GroundLine& line, const Number& time) {
  Number sum = Number(line.value) + Number(line.slope) * time;
  for (const Wave& wave : line.waves) {
    const Number angle = Number(wave.frequency) * time + Number(wave.phase);
    sum = sum + Number(wave.amplitude) * sine_cosine(angle, Number(wave.frequency)).sine;
  }
  return sum;
}

/// A stretch of time over which the ground's acceleration is analytic.
struct GroundPiece {
  Rational start, end;  ///< s
  GroundLine horizontal, vertical;
};

/// Pieces from 0 to the end of the scene, cut at each sample and where a pulse starts or ends.
std::vector<GroundPiece> ground_pieces(const ExactScene& scene);

}  // namespace rockstack::proof
