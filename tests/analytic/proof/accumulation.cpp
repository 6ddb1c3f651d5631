#include "tests/analytic/proof/accumulation.hpp"

namespace rockstack::proof {
namespace {

/// Bounds in a box while the interface is on one side.
struct Flight {
  Ball back;                       ///< −σφ̈ₖ, rad/s²
  Decision impact;                 ///< at its end
  Ball ratio;                      ///< η
  Ball stretch;                    ///< r
  std::vector<Ball> gain, throws;  ///< magnitudes: φ̈ⱼ, and jumps of φ̇ⱼ for unit closing speed
  std::vector<Ball> drift;         ///< dζⱼ/dt
  std::vector<Ball> coupling;      ///< Cⱼ now
  std::vector<Ball> variation;     ///< of Cⱼ in the box, D
};

/// Sums over infinitely many flights.
struct Sums {
  Ball duration;  ///< T*
  Ball speeds;    ///< of all leavings and all landings
  Ball fastest;   ///< no speed is larger
  Ball farthest;  ///< no |φₖ| is larger
};

class Chatter {
 public:
  Chatter(const Stack& stack, bool paper, const Motion& motion, std::size_t interface,
          const GroundPiece& piece, const Ball& offset)
      : stack_(stack), paper_(paper), now_(motion), k_(interface), piece_(piece), offset_(offset) {
    others_ = motion.pattern;
    others_[k_] = 0;
    speed_ = Ball(motion.pattern[k_]) * motion.rates[k_];
  }

  bool is_other(std::size_t j) const { return others_[j] != 0; }

  /// The flights on the present side and on the other one. @throws Undecided where (i), (ii) or (iii) is not
  /// certain.
  std::vector<Flight> flights(const Box& box) const {
    std::vector<Ball> angles = now_.angles;
    std::vector<Ball> rates = now_.rates;
    for (std::size_t j = 0; j < angles.size(); ++j) {
      if (!is_other(j)) continue;
      angles[j] = angles[j] + within(box.angles[j]);
      rates[j] = rates[j] + within(box.rates[j]);
    }
    angles[k_] = within(box.reach);
    rates[k_] = within(box.speed);
    require_sides(angles);
    const Ball time = hull(offset_, offset_ + box.duration);
    const Point<Ball> ground{acceleration(piece_.horizontal, time), acceleration(piece_.vertical, time)};
    Pattern other = now_.pattern;
    other[k_] = -other[k_];
    return {flight(now_.pattern, angles, rates, ground), flight(other, angles, rates, ground)};
  }

  /// @throws Undecided where (iv) is not certain.
  Sums sums(const std::vector<Flight>& flights) const {
    const Flight& first = flights[0];
    const Flight& second = flights[1];
    const Ball one(1);
    const Ball q1 = first.ratio * first.stretch;
    const Ball q2 = second.ratio * second.stretch;
    const Ball contracts = one - q1 * q2;
    if (!positive(contracts)) throw Undecided("impacts do not fade");
    const Ball pair = speed_ * (one + first.stretch + q1 * (one + second.stretch));
    const Ball least = lower(hull(first.back, second.back));
    return {Ball(2) * speed_ * (one / first.back + q1 / second.back) / contracts, pair / contracts,
            magnitude(pair), magnitude(pair * pair / (Ball(2) * least))};
  }

  /// What changes within the sums.
  Box needed(const std::vector<Flight>& flights, const Sums& sums) const {
    Box box{magnitude(sums.duration), sums.fastest, sums.farthest, std::vector<Ball>(others_.size()),
            std::vector<Ball>(others_.size())};
    for (std::size_t j = 0; j < others_.size(); ++j) {
      if (!is_other(j)) continue;
      const Ball gain = upper(hull(flights[0].gain[j], flights[1].gain[j]));
      const Ball thrown = upper(hull(flights[0].throws[j], flights[1].throws[j]));
      box.rates[j] = magnitude(gain * sums.duration + thrown * sums.speeds);
      box.angles[j] = magnitude((magnitude(now_.rates[j]) + box.rates[j]) * sums.duration);
    }
    return box;
  }

  bool is_inside(const Box& inner, const Box& outer) const {
    bool inside = positive(outer.duration - inner.duration) && positive(outer.speed - inner.speed) &&
                  positive(outer.reach - inner.reach);
    for (std::size_t j = 0; j < others_.size(); ++j)
      if (is_other(j))
        inside = inside && positive(outer.rates[j] - inner.rates[j]) &&
                 positive(outer.angles[j] - inner.angles[j]);
    return inside;
  }

  Motion after(const std::vector<Flight>& flights, const Sums& sums) const {
    Motion result = now_;
    for (std::size_t j = 0; j < others_.size(); ++j) {
      result.zeros[j] = 0;
      if (!is_other(j)) continue;
      const Ball start = now_.rates[j] + flights[0].coupling[j] * now_.rates[k_];
      const Ball varies =
          within(magnitude(upper(hull(flights[0].variation[j], flights[1].variation[j])) * sums.speeds));
      const Ball end = start + hull(flights[0].drift[j], flights[1].drift[j]) * sums.duration;
      result.rates[j] = end + varies;
      result.angles[j] = now_.angles[j] + (hull(start, end) + varies) * sums.duration;
    }
    result.angles[k_] = result.rates[k_] = Ball();
    result.pattern[k_] = 0;
    result.time = now_.time + sums.duration;
    return result;
  }

 private:
  /// The second part of (ii).
  void require_sides(const std::vector<Ball>& angles) const {
    for (std::size_t j = 0; j < others_.size(); ++j)
      if (is_other(j) && !positive(Ball(others_[j]) * angles[j]))
        throw Undecided("another interface may close");
    Pattern open = now_.pattern;
    const std::vector<Ball> theta = summed(open, angles);
    for (std::size_t j = 0; j < open.size(); ++j)
      if (!positive(stack_.toppling_angle[j] - magnitude(theta[j]))) throw Undecided("a block may topple");
  }

  Flight flight(const Pattern& pattern, const std::vector<Ball>& angles, const std::vector<Ball>& rates,
                const Point<Ball>& ground) const {
    const Accelerations<Ball> found = accelerate(stack_, pattern, angles, rates, ground);
    Flight flight;
    flight.back = Ball(-pattern[k_]) * found.relative[k_];
    if (!positive(flight.back)) throw Undecided("a flight may not come back");
    for (std::size_t j = 0; j < pattern.size(); ++j)
      if (!pattern[j] && !(positive(found.margins[j].right) && positive(found.margins[j].left)))
        throw Undecided("another interface may open");
    const Ball spread = upper(flight.back) / lower(flight.back);
    flight.stretch = hull(root(Ball(1) / spread), root(spread));
    flight.impact = impact(pattern, angles);
    const std::vector<Ball>& thrown = flight.impact.rates;
    flight.ratio = Ball(-pattern[k_]) * thrown[k_];
    const std::vector<Ball> here = coupling(pattern, angles);
    std::vector<Ball> closing = now_.angles;
    closing[k_] = Ball();
    flight.coupling = coupling(pattern, closing);
    for (std::size_t j = 0; j < pattern.size(); ++j) {
      flight.gain.push_back(magnitude(found.relative[j]));
      flight.throws.push_back(magnitude(thrown[j]));
      flight.drift.push_back(found.relative[j] + flight.coupling[j] * found.relative[k_]);
      flight.variation.push_back(magnitude(here[j] - flight.coupling[j]));
    }
    return flight;
  }

  /// (iii), at unit closing speed.
  Decision impact(const Pattern& pattern, std::vector<Ball> angles) const {
    angles[k_] = Ball();
    Decision decision = unit_impact(stack_, paper_, pattern, k_, angles);
    Pattern thrown = pattern;
    thrown[k_] = -thrown[k_];
    if (decision.pattern != thrown) throw Undecided("an impact does more than throw its interface");
    return decision;
  }

  /// C: the others' rates that have the momenta of φ̇ₖ = 1.
  std::vector<Ball> coupling(const Pattern& pattern, const std::vector<Ball>& angles) const {
    const Chain<Ball> chain = make_chain(stack_, pattern, angles, std::vector<Ball>(angles.size()));
    const Matrix<Ball> matrix = mass_matrix(stack_, pattern, chain);
    return solve_open(others_, matrix, matrix[k_]);
  }

  const Stack& stack_;
  bool paper_;
  const Motion& now_;
  std::size_t k_;
  const GroundPiece& piece_;
  const Ball& offset_;
  Pattern others_;
  Ball speed_;
};

/// A box half as large again.
Box enlarged(Box box) {
  const Ball half_more(1.5);
  for (Ball* size : {&box.duration, &box.speed, &box.reach}) *size = magnitude(*size * half_more);
  for (std::vector<Ball>* sizes : {&box.angles, &box.rates})
    for (Ball& size : *sizes) size = magnitude(size * half_more);
  return box;
}

}  // namespace

Accumulation accumulate(const Stack& stack, bool paper, const Motion& motion, std::size_t interface,
                        const GroundPiece& piece, const Ball& offset, const Ball& left) {
  const Chatter chatter(stack, paper, motion, interface, piece, offset);
  const std::size_t size = stack.size();
  Box box{0, 0, 0, std::vector<Ball>(size), std::vector<Ball>(size)};
  for (int attempt = 0; attempt < 8; ++attempt) {
    const std::vector<Flight> flights = chatter.flights(box);
    const Sums sums = chatter.sums(flights);
    const Box needed = chatter.needed(flights, sums);
    if (chatter.is_inside(needed, box)) {
      if (!positive(left - box.duration)) throw Undecided("an accumulation at the end of a ground piece");
      return {chatter.after(flights, sums), sums.duration, box, {flights[0].impact, flights[1].impact}};
    }
    box = enlarged(needed);
  }
  throw Undecided("no box holds the chatter");
}

}  // namespace rockstack::proof
