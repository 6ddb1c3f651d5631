#pragma once

#include "analytic/flow.hpp"
#include "analytic/ground_pieces.hpp"
#include "analytic/outcome.hpp"

namespace rockstack {

/// What comes first within a step, at s of its length; nothing, at s = 1, where neither an interface closes
/// or opens nor a block topples.
template <class Real>
struct Next {
  Real s = 1;
  Interfaces closing;
  Interfaces opening;
  Pattern opened;     ///< the sides that opening interfaces open to
  int toppling = -1;  ///< block, from 0

  bool happens() const { return closing.any() || opening.any() || toppling >= 0; }

  /// Makes room for an event at `crossing`: earlier than all so far, or at the same time. False where it is
  /// later.
  bool admit(const std::optional<Real>& crossing) {
    if (!crossing || *crossing > s) return false;
    if (*crossing < s) *this = Next{*crossing, {}, {}, opened, -1};
    return true;
  }
};

/// Finds the first event in a step. `held` interfaces stay closed.
template <class Real>
class Guards {
 public:
  static constexpr std::size_t nodes = 5;  ///< points of a step at which margins are evaluated

  Guards(const Model<Real>& model, const Flow<Real>& flow, const GroundPiece<Real>& piece, const Real& offset)
      : model_(model), flow_(flow), piece_(piece), offset_(offset), pattern_(flow.start.pattern) {}

  Next<Real> first(const Interfaces& held, const std::array<Real, max_blocks>& toppling_angles) const {
    Next<Real> next;
    next.opened = pattern_;
    find_closing(next);
    find_opening(held, next);
    find_toppling(toppling_angles, next);
    return next;
  }

 private:
  using Angle = Polynomial<Real, Flow<Real>::terms>;

  /// How far an open interface is open, as a polynomial.
  Angle gap(int interface) const {
    Angle polynomial = flow_.angles[static_cast<std::size_t>(interface)];
    for (Real& coefficient : polynomial) coefficient *= Real(sign(pattern_[interface]));
    return polynomial;
  }

  void find_closing(Next<Real>& next) const {
    for (int k = 0; k < pattern_.size; ++k) {
      if (pattern_[k] == Contact::closed) continue;
      if (next.admit(first_crossing(gap(k)))) next.closing.set(static_cast<std::size_t>(k));
    }
    if (next.closing.none()) return;
    // What rounding has carried past zero by then closes at the same time.
    for (int k = 0; k < pattern_.size; ++k) {
      if (pattern_[k] != Contact::closed && value(gap(k), next.s) < 0)
        next.closing.set(static_cast<std::size_t>(k));
    }
  }

  /// Follows the margins of closed interfaces by the quartics through five points of the step.
  void find_opening(const Interfaces& held, Next<Real>& next) const {
    const auto watched = [&](int k) {
      return pattern_[k] == Contact::closed && !held.test(static_cast<std::size_t>(k));
    };
    std::array<std::array<Margins<Real>, max_blocks>, nodes> values;
    bool evaluated = false;
    for (int k = 0; k < pattern_.size; ++k) {
      if (!watched(k)) continue;
      if (!evaluated) evaluate_margins(values);
      evaluated = true;
      Polynomial<Real, nodes> right;
      Polynomial<Real, nodes> left;
      for (std::size_t i = 0; i < nodes; ++i) {
        const Margins<Real>& margin = values[i][static_cast<std::size_t>(k)];
        right[i] = margin.right;
        left[i] = margin.left;
      }
      consider_opening(right, k, Contact::right, next);
      consider_opening(left, k, Contact::left, next);
    }
  }

  void evaluate_margins(std::array<std::array<Margins<Real>, max_blocks>, nodes>& values) const {
    for (std::size_t i = 0; i < nodes; ++i) {
      const Real s = Real(i) / Real(nodes - 1);
      const auto outcome = accelerate(model_, flow_.at(s), piece_.at(offset_ + s * flow_.length));
      for (int k = 0; k < pattern_.size; ++k) {
        values[i][static_cast<std::size_t>(k)] = margins(model_.stack, outcome.reactions, k);
      }
    }
  }

  void consider_opening(const Polynomial<Real, nodes>& values, int interface, Contact side,
                        Next<Real>& next) const {
    if (!next.admit(first_crossing(quartic_through(values)))) return;
    next.opening.set(static_cast<std::size_t>(interface));
    next.opened[interface] = side;
  }

  void find_toppling(const std::array<Real, max_blocks>& toppling_angles, Next<Real>& next) const {
    Angle angle{};
    for (int k = 0; k < pattern_.size; ++k) {
      const auto block = static_cast<std::size_t>(k);
      for (std::size_t i = 0; i < angle.size(); ++i) angle[i] += flow_.angles[block][i];
      Angle room = angle;
      for (Real& coefficient : room) coefficient *= angle[0] > 0 ? Real(-1) : Real(1);
      room[0] += toppling_angles[block];
      const auto crossing = first_crossing(room);
      if (crossing && *crossing < next.s && next.admit(crossing)) next.toppling = k;
    }
  }

  const Model<Real>& model_;
  const Flow<Real>& flow_;
  const GroundPiece<Real>& piece_;
  const Real& offset_;
  const Pattern& pattern_;
};

}  // namespace rockstack
