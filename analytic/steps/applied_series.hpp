#pragma once

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/scene/lists.hpp"
#include "analytic/steps/block_series.hpp"
#include "analytic/steps/restraint_series.hpp"

namespace rockstack {

/// A point of a block in a chain, with its arm from the block's pivot, in that one's frame, m.
template <class Real>
struct ChainPoint {
  int block;  ///< −1: the ground
  PlaneVector<Real> arm;
};

/// A point by its arm from the centre of mass; `sides`: signs of contacts.
template <class Real, int N>
ChainPoint<Real> chain_point(const Stack<Real, N>& stack, const PerBlock<Real, N>& sides, int k,
                             const Point<Real>& arm) {
  if (k < 0) return {k, {arm.x(), arm.y()}};
  const Real pivot = sides[static_cast<std::size_t>(k)] * stack.half_width[k];
  return {k, {arm.x() + stack.centre_x[k] - pivot, arm.y() + stack.centre_y[k]}};
}

/// Order n of the moment of a force at the end of a vector (x, y) of a block's frame about its beginning;
/// `force_at` has each order of the force.
template <class Real, class ForceAt>
Real moment_of(const BlockSeries<Real>& block, const Real& x, const Real& y, const ForceAt& force_at,
               std::size_t n) {
  Real sum = 0;
  for (std::size_t m = 0; m <= n; ++m) sum += across(turned(block.direction[n - m], x, y), force_at(m));
  return sum;
}

/// Takes order n of the moments of a force at a point about all pivots from what the others leave.
template <class Real, int N, class Blocks, class ForceAt>
void add_moments_of(const ChainPoint<Real>& point, const ForceAt& force_at, const Linkage<Real, N>& linkage,
                    const Blocks& blocks, std::size_t n, PerBlock<Real, N>& moments) {
  if (point.block < 0) return;
  const auto own = static_cast<std::size_t>(point.block);
  Real sum = moment_of(blocks[own], point.arm.x, point.arm.y, force_at, n);
  for (std::size_t k = own + 1; k-- > 0;) {
    if (k < own) sum += moment_of(blocks[k], linkage.link_x[k], linkage.link_y[k], force_at, n);
    moments[k] -= sum;
  }
}

/// The forces at points of a chain along one step: pushes, whose sizes are given, and restraints, which grow.
template <class Real, int N>
class AppliedSeries {
 public:
  using Point2 = PlaneVector<Real>;

  /// `sides`: signs of contacts; `step` in s.
  AppliedSeries(const Model<Real, N>& model, const PerBlock<Real, N>& sides, const Real& step)
      : foot_{sides[0] * model.stack.half_width[0], Real(0)} {
    for (const PushPoint<Real>& push : model.pushes)
      pushes_.push_back(
          {chain_point(model.stack, sides, push.block, push.arm), {push.direction.x(), push.direction.y()}});
    for (const RestraintLaw<Real>& law : model.restraints)
      restraints_.push_back({chain_point(model.stack, sides, law.from, law.from_arm),
                             chain_point(model.stack, sides, law.to, law.to_arm),
                             {law, step}});
  }

  /// Order n of forces; takes their moments about all pivots from what the others leave.
  template <class Blocks>
  void extend(std::size_t n, const std::vector<Polynomial<Real>>& sizes, const Linkage<Real, N>& linkage,
              const Blocks& blocks, PerBlock<Real, N>& moments) {
    for (std::size_t i = 0; i < pushes_.size(); ++i)
      add_moments_of(pushes_[i].point, force_of(pushes_[i], sizes[i]), linkage, blocks, n, moments);
    for (ChainRestraint& restraint : restraints_) {
      restraint.series.extend(n, apart_of(restraint, linkage, blocks));
      for (const int way : {1, -1})
        add_moments_of(way > 0 ? restraint.from : restraint.to, force_of(restraint, way), linkage, blocks, n,
                       moments);
    }
  }

  /// Takes order n of forces from those that blocks need of interfaces.
  template <class Blocks>
  void add_forces(std::size_t n, const std::vector<Polynomial<Real>>& sizes, Blocks& blocks) const {
    const auto take = [&](int block, const Point2& force) {
      for (int k = 0; k <= block; ++k)
        blocks[static_cast<std::size_t>(k)].force[n] =
            blocks[static_cast<std::size_t>(k)].force[n] + Real(-1) * force;
    };
    for (std::size_t i = 0; i < pushes_.size(); ++i)
      take(pushes_[i].point.block, force_of(pushes_[i], sizes[i])(n));
    for (const ChainRestraint& restraint : restraints_) {
      take(restraint.from.block, force_of(restraint, 1)(n));
      take(restraint.to.block, force_of(restraint, -1)(n));
    }
  }

  /// Makes the step `ratio` times as long, where order 0 is known; `blocks` are so already.
  template <class Blocks>
  void shorten(const Real& ratio, const Linkage<Real, N>& linkage, const Blocks& blocks) {
    for (ChainRestraint& restraint : restraints_) {
      restraint.series.step *= ratio;
      restraint.series.extend(0, apart_of(restraint, linkage, blocks));
    }
  }

  /// Lengths of restraints over so many orders.
  template <class Blocks>
  std::vector<Polynomial<Real>> lengths(std::size_t orders, const Linkage<Real, N>& linkage,
                                        const Blocks& blocks) {
    std::vector<Polynomial<Real>> result;
    for (ChainRestraint& restraint : restraints_) {
      restraint.series.extend_length(orders + 1, apart_of(restraint, linkage, blocks));
      result.push_back(restraint.series.length);
    }
    return result;
  }

 private:
  struct ChainPush {
    ChainPoint<Real> point;
    Point2 direction;
  };
  struct ChainRestraint {
    ChainPoint<Real> from, to;
    GrowingRestraint<Real> series;
  };

  static auto force_of(const ChainPush& push, const Polynomial<Real>& size) {
    return [&](std::size_t m) { return coefficient(size, m) * push.direction; };
  }
  static auto force_of(const ChainRestraint& restraint, int way) {
    return [&restraint, way](std::size_t m) {
      return Point2{way * restraint.series.force_x[m], way * restraint.series.force_y[m]};
    };
  }

  /// Order m of where a point is.
  template <class Blocks>
  Point2 place(const ChainPoint<Real>& point, const Linkage<Real, N>& linkage, const Blocks& blocks,
               std::size_t m) const {
    const Point2 still{Real(0), Real(0)};
    if (point.block < 0) return m == 0 ? point.arm : still;
    Point2 sum = m == 0 ? foot_ : still;
    const auto own = static_cast<std::size_t>(point.block);
    for (std::size_t k = 0; k < own; ++k)
      sum = sum + turned(blocks[k].direction[m], linkage.link_x[k], linkage.link_y[k]);
    return sum + turned(blocks[own].direction[m], point.arm.x, point.arm.y);
  }
  template <class Blocks>
  auto apart_of(const ChainRestraint& restraint, const Linkage<Real, N>& linkage,
                const Blocks& blocks) const {
    return [&](std::size_t m) {
      return place(restraint.to, linkage, blocks, m) + Real(-1) * place(restraint.from, linkage, blocks, m);
    };
  }

  Point2 foot_;
  std::vector<ChainPush> pushes_;
  std::vector<ChainRestraint> restraints_;
};

}  // namespace rockstack
