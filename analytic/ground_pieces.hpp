#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

/// A stretch of time over which the ground's acceleration is a straight line, in the number type of a
/// calculation.
template <class Real>
struct GroundPiece {
  Real start;         ///< s
  Real length;        ///< s, > 0
  Point<Real> value;  ///< (ẍg, ÿg) at the start, m/s²
  Point<Real> rate;   ///< its change, m/s³

  Point<Real> at(const Real& offset) const { return value + offset * rate; }
};

/// Walks through a scene's ground motion piece by piece: pieces end at the samples of either component and at
/// the end of the scene. Without ground motion there is one piece.
template <class Real>
class GroundPieces {
 public:
  explicit GroundPieces(const Scene& scene) : scene_(scene) { find_piece(); }

  bool finished() const { return !(start_ < Real(scene_.duration)); }
  const GroundPiece<Real>& current() const { return piece_; }

  /// True where the ground stays still from this piece to the end.
  bool still() const {
    const auto over = [&](const GroundMotion& motion) {
      return motion.empty() || start_ >= Real(motion.end());
    };
    return over(scene_.horizontal) && over(scene_.vertical);
  }

  void advance() {
    start_ = end_;
    find_piece();
  }

 private:
  struct Line {
    Real end;
    Real value = 0;
    Real rate = 0;
  };

  /// The line of one component from start_ on.
  Line line(const GroundMotion& motion) const {
    using std::floor;
    const Real forever = std::numeric_limits<Real>::infinity();
    if (motion.empty()) return {forever};
    const Real interval(motion.interval);
    // The quotient of a sample's time by the interval may round to just below its number.
    auto sample = static_cast<std::size_t>(floor(start_ / interval));
    if (Real(sample + 1) * interval <= start_) ++sample;
    if (sample + 1 >= motion.samples.size()) return {forever};
    const Real first(motion.samples[sample]);
    const Real rate = (Real(motion.samples[sample + 1]) - first) / interval;
    return {Real(sample + 1) * interval, first + (start_ - Real(sample) * interval) * rate, rate};
  }

  void find_piece() {
    const Line horizontal = line(scene_.horizontal);
    const Line vertical = line(scene_.vertical);
    end_ = std::min({horizontal.end, vertical.end, Real(scene_.duration)});
    piece_ = {start_, end_ - start_, {horizontal.value, vertical.value}, {horizontal.rate, vertical.rate}};
  }

  const Scene& scene_;
  Real start_ = 0;
  Real end_ = 0;
  GroundPiece<Real> piece_{};
};

}  // namespace rockstack
