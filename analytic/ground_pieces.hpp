#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

/// One component of the ground's acceleration over a stretch of time: a straight line, or part of a pulse.
template <class Real>
struct GroundCourse {
  Real end = std::numeric_limits<Real>::infinity();  ///< s
  Real value = 0;                                    ///< at the start, m/s²
  Real rate = 0;                                     ///< its change, m/s³
  const Pulse* pulse = nullptr;                      ///< in place of the line
  Real elapsed = 0;  ///< from the start of the pulse to that of the stretch, s

  Real at(const Real& offset) const {
    return pulse ? acceleration(*pulse, elapsed + offset) : value + offset * rate;
  }
};

/// A stretch of time over which the ground's acceleration is smooth, in the number type of a calculation.
template <class Real>
struct GroundPiece {
  Real start;   ///< s
  Real length;  ///< s, > 0
  GroundCourse<Real> horizontal, vertical;

  /// (ẍg, ÿg), m/s².
  Point<Real> at(const Real& offset) const { return {horizontal.at(offset), vertical.at(offset)}; }

  /// True where neither component is a pulse.
  bool straight() const { return !horizontal.pulse && !vertical.pulse; }
};

/// Walks through a scene's ground motion piece by piece: pieces end at the samples of either component, where
/// a pulse starts or ends, and at the end of the scene. Without ground motion there is one piece.
template <class Real>
class GroundPieces {
 public:
  explicit GroundPieces(const Scene& scene) : scene_(scene) { find_piece(); }

  bool finished() const { return !(start_ < Real(scene_.duration)); }
  const GroundPiece<Real>& current() const { return piece_; }

  void advance() {
    start_ = end_;
    find_piece();
  }

 private:
  /// A component from start_ on.
  GroundCourse<Real> course(const GroundMotion& motion) const {
    if (motion.pulse) return pulse_course(*motion.pulse);
    return motion.empty() ? GroundCourse<Real>{} : line_course(motion);
  }

  GroundCourse<Real> pulse_course(const Pulse& pulse) const {
    const Real start(pulse.start);
    const Real end = start + Real(length(pulse));
    if (start_ < start) return {start};
    return start_ < end ? GroundCourse<Real>{end, 0, 0, &pulse, start_ - start} : GroundCourse<Real>{};
  }

  GroundCourse<Real> line_course(const GroundMotion& motion) const {
    const Real interval(motion.interval);
    // The quotient of a sample's time by the interval may round to just below its number.
    auto sample = static_cast<std::size_t>(start_ / interval);
    if (Real(sample + 1) * interval <= start_) ++sample;
    if (sample + 1 >= motion.samples.size()) return {};
    const Real first(motion.samples[sample]);
    const Real rate = (Real(motion.samples[sample + 1]) - first) / interval;
    return {Real(sample + 1) * interval, first + (start_ - Real(sample) * interval) * rate, rate};
  }

  void find_piece() {
    const GroundCourse<Real> horizontal = course(scene_.horizontal);
    const GroundCourse<Real> vertical = course(scene_.vertical);
    end_ = std::min({horizontal.end, vertical.end, Real(scene_.duration)});
    piece_ = {start_, end_ - start_, horizontal, vertical};
  }

  const Scene& scene_;
  Real start_ = 0;
  Real end_ = 0;
  GroundPiece<Real> piece_{};
};

}  // namespace rockstack
