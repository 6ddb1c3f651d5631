#pragma once

#include <algorithm>
#include <cstdint>

#include "analytic/scene/ground/ground_motion.hpp"

namespace rockstack {

/// A made-up accelerogram: filtered white noise under an envelope, scaled to its peak. The seed decides
/// everything else: same numbers, same compiler and machine, same bits. SI units.
struct SyntheticMotion {
  std::uint64_t seed = 0;
  double peak = 0;         ///< largest absolute acceleration, m/s², > 0
  double duration = 20;    ///< s, > 0, at most 1000; rounded to a whole number of intervals
  double interval = 0.01;  ///< s, > 0; 16 to 20000 of them in the duration
  double frequency = 2.5;  ///< of the ground layer, Hz, from 1/duration to synthetic_cutoff(); firm ground
  double damping = 0.6;    ///< of the ground layer, as a fraction of critical, > 0, at most 1
};

/// The highest frequency in a motion: 25 Hz, or half the sampling rate where that is lower. Hz.
inline double synthetic_cutoff(const SyntheticMotion& motion) {
  return std::min(25.0, 0.5 / motion.interval);
}

/// Shape of the power spectrum at a frequency in Hz, 1 between the two filters: white noise through a ground
/// layer (Kanai 1957, Tajimi 1960) and a high-pass at a tenth of the layer's frequency with damping 0.6
/// (Clough & Penzien 1975, Dynamics of Structures), which leaves slow drift out.
double synthetic_spectrum(const SyntheticMotion& motion, double frequency);

/// The factor (t/tₚ)² exp(2 (1 − t/tₚ)), tₚ a fifth of the duration: 0 at the start, 1 at its largest, 0.008
/// at the end (Saragoni & Hart 1974, Earthquake Engineering & Structural Dynamics 2, 249–267).
double synthetic_envelope(const SyntheticMotion& motion, double t);

/// Normal noise with that spectrum up to the cutoff and variance 1, times the envelope, at every sample; not
/// scaled, base line not corrected. A sum of cosines and sines at the odd multiples of 1/(4 duration), with
/// independent normal amplitudes (Shinozuka & Deodatis 1991, Applied Mechanics Reviews 44, 191–204).
/// Precondition: validate() accepts the motion.
std::vector<double> modulated_noise(const SyntheticMotion& motion);

/// The noise with its base line corrected and scaled to the peak. The correction is a straight line times the
/// envelope, such that velocity and displacement, integrated from rest with straight lines between samples,
/// end at zero but for rounding.
/// @throws FieldError as validate().
GroundMotion make_synthetic(const SyntheticMotion& motion);

/// @throws FieldError for a number out of its range; its key starts with `key`.
void validate(const SyntheticMotion& motion, const std::string& key = "synthetic");

}  // namespace rockstack
