#pragma once

#include <array>
#include <memory>

#include "tests/benchmarks/lean_chain.hpp"

namespace rockstack::benchmarks {

/// Lanes of a pack, a bit each.
class LaneSet {
 public:
  explicit LaneSet(unsigned bits = 0) : bits_(bits) {}
  bool any() const { return bits_ != 0; }
  bool has(std::size_t lane) const { return (bits_ >> lane & 1U) != 0; }

 private:
  unsigned bits_;
};

/// Steps of Boost.odeint's dopri5 for as many stacks as a pack of AVX2 has lanes. The state, the time and the
/// step are packs: each lane is at a time of its own and steps as far as its own error lets it, by the rules
/// of Boost's controller. Steps end at the ends of the ground's straight pieces, so that the last derivative
/// of one is the first of the next. What it is made of stays in the one file that has AVX2.
template <int N>
class PackSteps {
 public:
  static constexpr std::size_t lanes = 4;

  PackSteps() = default;
  PackSteps(const PackSteps&) = delete;
  PackSteps& operator=(const PackSteps&) = delete;
  virtual ~PackSteps() = default;

  /// A lane has a scene.
  virtual void start(std::size_t lane, double gravity, const std::array<double, N>& toppling) = 0;
  /// A lane has none any more.
  virtual void stop(std::size_t lane) = 0;
  /// A lane goes along a piece of ground, which is straight.
  virtual void follow(std::size_t lane, const GroundPiece<double>& piece, double offset) = 0;
  /// A lane goes on from values and in a pattern that its last step did not lead to.
  virtual void go_on(std::size_t lane, const Values<N>& values, const LeanChain<N>& chain) = 0;

  struct Outcome {
    LaneSet made;     ///< whose steps are accurate enough; others try shorter ones
    LaneSet happens;  ///< of these, those with an event in it
    LaneSet leaves;   ///< of these, those with an event, or at the end of their piece of ground
  };
  /// Tries a step of each lane, of which nothing is kept yet.
  virtual Outcome step() = 0;
  /// A lane's step: from which offset to which, and the values there.
  struct Step {
    double from, to;
    Values<N> after;
  };
  virtual Step step_of(std::size_t lane) const = 0;
  /// Values within it.
  virtual Values<N> at(std::size_t lane, double offset) const = 0;
  /// Lanes whose step was made are where it leads.
  virtual void keep() = 0;
};

/// @param tolerance absolute and relative
template <int N>
std::unique_ptr<PackSteps<N>> make_pack_steps(double tolerance);

}  // namespace rockstack::benchmarks
