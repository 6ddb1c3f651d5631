#include "tests/analytic/proof/first_zero.hpp"

#include <limits>

#include "tests/analytic/proof/decisions.hpp"

namespace rockstack::proof {
namespace {

constexpr slong low_bits = 128;
constexpr int most_halvings = 70;

/// A guard over t^zeros, with the bound of what its coefficients leave out up to a time.
class Divided {
 public:
  Divided(const Guard& guard, const Ball& length)
      : guard_(guard), first_(guard.coefficients + guard.zeros), terms_(guard.terms - guard.zeros) {
    const Precision low(low_bits);
    const auto order = static_cast<ulong>(guard.terms);
    const Ball share = length / guard.radius;
    const Ball rest = Ball(1) - share;
    const Ball whole = guard.bound * power(share, order) / power(length, static_cast<ulong>(guard.zeros));
    tail_ = magnitude(whole / rest);
    // Σ n xⁿ from n = K on is (K − (K − 1) x) x^K / (1 − x)², at most K x^K / (1 − x)².
    slope_tail_ = magnitude(whole * Ball(static_cast<int>(guard.terms)) / (rest * rest * length));
  }

  Ball value(const Ball& time) const {
    Ball sum;
    for (slong n = terms_; n-- > 0;) sum = sum * time + coefficient(n);
    return Ball(guard_.sign) * sum + within(tail_);
  }
  Ball slope(const Ball& time) const {
    Ball sum;
    for (slong n = terms_; n-- > 1;) sum = sum * time + coefficient(n) * Ball(static_cast<int>(n));
    return Ball(guard_.sign) * sum + within(slope_tail_);
  }

 private:
  Ball coefficient(slong n) const {
    Ball result;
    arb_set_round(result.data(), first_ + n, working_bits);
    return result;
  }

  const Guard& guard_;
  arb_srcptr first_;
  slong terms_;
  Ball tail_, slope_tail_;
};

struct Bracket {
  Ball from, to;
};

/// Goes from left to right through a cell; its first part in which the guard falls through zero, if there is
/// one.
std::optional<Bracket> falls_in(const Divided& guard, const Ball& from, const Ball& to, int halvings,
                                std::vector<Ball>& cover) {
  const Ball cell = hull(from, to);
  const Ball centre = middle(cell);
  const Ball slope = guard.slope(cell);
  const bool above = positive(guard.value(centre) + slope * (cell - centre));
  const bool rises = positive(slope) && positive(guard.value(from));
  const Ball end = negative(slope) ? guard.value(to) : Ball();
  if (above || rises || positive(end)) {
    cover.push_back(to);
    return std::nullopt;
  }
  if (negative(end) && positive(guard.value(from))) return Bracket{from, to};
  if (halvings == 0) throw Undecided("a guard touches zero, or is zero where a step ends");
  if (const auto left = falls_in(guard, from, centre, halvings - 1, cover)) return left;
  return falls_in(guard, centre, to, halvings - 1, cover);
}

/// Newton's method in intervals, until it gains no more.
Ball refined(const Divided& guard, const Bracket& bracket) {
  Ball zero = hull(bracket.from, bracket.to);
  for (double width = std::numeric_limits<double>::infinity();;) {
    const Ball centre = middle(zero);
    const Ball slope = guard.slope(zero);
    if (!negative(slope)) throw Undecided("a guard does not fall strictly through its zero");
    const Ball newton = centre - guard.value(centre) / slope;
    Ball next;
    if (!arb_intersection(next.data(), newton.data(), zero.data(), working_bits))
      throw Undecided("Newton's method finds no zero");
    zero = next;
    const double now = width_exponent(zero);
    if (!(now < width - 0.5)) return zero;
    width = now;
  }
}

}  // namespace

ZeroSearch first_zero(const Guard& guard, const Ball& length) {
  const Divided divided(guard, length);
  ZeroSearch result{{Ball()}, {}};
  std::optional<Bracket> bracket;
  {
    const Precision low(low_bits);
    bracket = falls_in(divided, Ball(), length, most_halvings, result.cover);
  }
  if (bracket) result.zero = refined(divided, *bracket);
  return result;
}

}  // namespace rockstack::proof
