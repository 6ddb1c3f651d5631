#pragma once

#include "analytic/events/first_event.hpp"
#include "analytic/events/zeno_summation.hpp"

namespace rockstack {

/// The largest relative angle that each interface comes to. That of the lowest one is its block's own.
template <class Real, int N>
class Openings {
 public:
  /// Where nobody asks, no angle is larger than what is known.
  explicit Openings(bool asked) { angles_.fill(asked ? Real(0) : std::numeric_limits<Real>::infinity()); }

  /// Takes in a step up to s of its length, but for interfaces of which it is known that it tells nothing.
  /// Each relative angle keeps its sign through a step. `lowest`: of the lowest interface so far, rad.
  void note_step(const DenseOutput<Real, N>& output, const AngleHulls<Real, N>& hulls, const Real& s,
                 const Interfaces& cleared, const Real& lowest) {
    angles_[0] = lowest;
    for (int k = 1; k < output.start.size(); ++k) {
      Real& known = angles_[static_cast<std::size_t>(k)];
      if (hulls[k].size() <= known || cleared.test(k)) continue;
      const Polynomial<Real>& angle = output.angles[k];
      known = is_monotone(angle) ? std::max<Real>({known, abs(angle[0]), abs(value(angle, s))})
                                 : largest(times(sign(output.start.pattern[k]), angle), s, known);
    }
  }

  /// Whether an interface above others may open further within chatter than before it and after it. The one
  /// that chatters has been further open before.
  bool may_rise(const RestOfChatter<Real, N>& rest) const {
    const Vector<Real, N> thrown = rest.velocity_jump();
    for (int k = 1; k < thrown.size(); ++k) {
      const Real speed = abs(rest.closure.relative[k]);
      const Real change = 2 * abs(thrown[k]) + rest.fastest * rest.duration;
      const Real reach = abs(rest.angles[k]) + (speed + change) * rest.duration;
      if (k != rest.interface && reach > angles_[static_cast<std::size_t>(k)] && speed <= change) return true;
    }
    return false;
  }

  /// Raises them to those of a whole step.
  void raise(const PerBlock<Real, N>& angles) { angles_ = angles; }

  const PerBlock<Real, N>& angles() const { return angles_; }  ///< rad; infinite where nobody asks

  /// What they make of corners, m: corner_rise().
  std::vector<Real> uplifts(const Scene& scene) const {
    std::vector<Real> list;
    list.reserve(scene.blocks.size());
    for (int k = 0; const Real& angle : std::span(angles_).first(scene.blocks.size()))
      list.push_back(Real(corner_rise(scene, k++, static_cast<double>(angle))));
    return list;
  }

 private:
  /// The larger one of what is known and of a polynomial up to s.
  static Real largest(Polynomial<Real> opening, const Real& s, const Real& known) {
    rescale(opening, s);
    const auto top = maximum(opening, known);
    return top ? top->height : known;
  }

  PerBlock<Real, N> angles_;
};

}  // namespace rockstack
