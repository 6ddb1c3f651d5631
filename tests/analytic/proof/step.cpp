#include "tests/analytic/proof/step.hpp"

#include <cmath>

namespace rockstack::proof {
namespace {

constexpr slong disc_bits = 64;

/// Reaches of rates and angles that a motion at its present accelerations would need, with a little more.
void guess_reach(const Motion& motion, const std::vector<Ball>& accelerations, Enclosure& enclosure) {
  const Ball more(1.2);
  for (std::size_t k = 0; k < motion.pattern.size(); ++k) {
    if (!motion.pattern[k]) continue;
    const Ball gain = magnitude(accelerations[k]) + Ball(1e-3);
    enclosure.rate_reach[k] = magnitude(enclosure.radius * gain * more);
    enclosure.angle_reach[k] =
        magnitude(enclosure.radius * (magnitude(motion.rates[k]) + enclosure.rate_reach[k]) * more);
  }
}

struct OnDisc {
  std::vector<ComplexBall> rates;
  Accelerations<ComplexBall> motion;
};

OnDisc on_disc(const Stack& stack, const Motion& motion, const GroundPiece& piece, const Ball& offset,
               const Enclosure& enclosure) {
  const ComplexBall time = disc(offset, enclosure.radius);
  std::vector<ComplexBall> angles, rates;
  for (std::size_t k = 0; k < motion.pattern.size(); ++k) {
    angles.push_back(motion.pattern[k] ? disc(motion.angles[k], enclosure.angle_reach[k]) : 0);
    rates.push_back(motion.pattern[k] ? disc(motion.rates[k], enclosure.rate_reach[k]) : 0);
  }
  auto found =
      accelerate<ComplexBall>(stack, motion.pattern, angles, rates,
                              {acceleration(piece.horizontal, time), acceleration(piece.vertical, time)});
  return {std::move(rates), std::move(found)};
}

/// Whether the test holds with the present reaches, with room for who checks it by other bounds of f; where
/// not, they become a little more than what it needs.
bool picard(const Motion& motion, const OnDisc& on, Enclosure& enclosure, bool& finite_reach) {
  const Ball room(1.1);
  Enclosure needed = enclosure;
  bool holds = true;
  for (std::size_t k = 0; k < motion.pattern.size(); ++k) {
    if (motion.pattern[k]) {
      finite_reach = finite_reach && finite(on.motion.relative[k]);
      if (!finite_reach) return false;
      needed.angle_reach[k] = magnitude(enclosure.radius * magnitude(on.rates[k]));
      needed.rate_reach[k] = magnitude(enclosure.radius * magnitude(on.motion.relative[k]));
      holds = holds && positive(enclosure.angle_reach[k] - room * needed.angle_reach[k]) &&
              positive(enclosure.rate_reach[k] - room * needed.rate_reach[k]);
    } else {
      const Margins<ComplexBall>& margins = on.motion.margins[k];
      finite_reach = finite_reach && finite(margins.right) && finite(margins.left);
      needed.margins[k] = {magnitude(margins.right), magnitude(margins.left)};
    }
  }
  enclosure.margins = needed.margins;
  const Ball more(1.2);
  for (std::size_t k = 0; !holds && k < motion.pattern.size(); ++k) {
    enclosure.angle_reach[k] = magnitude(needed.angle_reach[k] * more);
    enclosure.rate_reach[k] = magnitude(needed.rate_reach[k] * more);
  }
  return holds && finite_reach;
}

std::optional<Enclosure> enclosure_on(const Stack& stack, const Motion& motion, const GroundPiece& piece,
                                      const Ball& offset, double radius) {
  const Precision low(disc_bits);
  const std::size_t size = motion.pattern.size();
  Enclosure enclosure{Ball(radius), std::vector<Ball>(size), std::vector<Ball>(size),
                      std::vector<Margins<Ball>>(size)};
  const Point<Ball> ground{acceleration(piece.horizontal, offset), acceleration(piece.vertical, offset)};
  guess_reach(motion, accelerate(stack, motion.pattern, motion.angles, motion.rates, ground).relative,
              enclosure);
  bool finite_reach = true;
  for (int attempt = 0; attempt < 8 && finite_reach; ++attempt)
    if (picard(motion, on_disc(stack, motion, piece, offset, enclosure), enclosure, finite_reach))
      return enclosure;
  return std::nullopt;
}

/// So many that (length/radius)^terms is below rounding.
slong terms_for(const Ball& length, const Ball& radius) {
  const double bits_each = std::log2(approximate(radius) / approximate(length));
  return std::max<slong>(8, static_cast<slong>(static_cast<double>(working_bits) / bits_each) + 6);
}

Ball polynomial(arb_srcptr coefficients, slong terms, const Ball& time) {
  Ball sum;
  for (slong n = terms; n-- > 0;) {
    arb_mul(sum.data(), sum.data(), time.data(), working_bits);
    arb_add(sum.data(), sum.data(), coefficients + n, working_bits);
  }
  return sum;
}

}  // namespace

const char* name(EventKind kind) {
  static constexpr const char* names[] = {"opening", "impact", "accumulation", "topple"};
  return names[static_cast<std::size_t>(kind)];
}

Enclosure enclose(const Stack& stack, const Motion& motion, const GroundPiece& piece, const Ball& offset,
                  double& radius) {
  for (; radius > 1e-9; radius *= 0.8)
    if (const auto found = enclosure_on(stack, motion, piece, offset, radius)) return *found;
  throw Undecided("no disc encloses the motion");
}

Step::Step(const Stack& stack, const Motion& motion, const GroundPiece& piece, const Ball& offset,
           Enclosure enclosure, const Ball& length)
    : start_(motion),
      enclosure_(std::move(enclosure)),
      length_(length),
      tape_(terms_for(length, enclosure_.radius)) {
  const auto given = [&](const Ball& start) {
    const std::size_t index = tape_.add(Tape::Rule::given);
    arb_set(tape_.coefficients(index), start.data());
    return index;
  };
  for (std::size_t k = 0; k < motion.pattern.size(); ++k) {
    angles_.push_back(motion.pattern[k] ? Series(tape_, given(motion.angles[k])) : 0);
    rates_.push_back(motion.pattern[k] ? Series(tape_, given(motion.rates[k])) : 0);
  }
  const Series time(tape_, given(offset));
  arb_one(tape_.coefficients(time.index()) + 1);
  accelerations_ =
      accelerate<Series>(stack, motion.pattern, angles_, rates_,
                         {acceleration(piece.horizontal, time), acceleration(piece.vertical, time)});
  watch_interfaces(stack);
  watch_toppling(stack);
  extend();
}

void Step::extend() {
  for (std::size_t k = 0; k < angles_.size(); ++k) {
    if (!start_.pattern[k]) continue;
    tape_.set_rate(angles_[k].index(), rates_[k].index());
    tape_.set_rate(rates_[k].index(), accelerations_.relative[k].on(tape_));
  }
  for (slong order = 0; order < tape_.terms(); ++order) {
    tape_.extend(order);
    if (order > 0) continue;
    for (std::size_t k = 0; k < angles_.size(); ++k)
      if (start_.zeros[k] == 3) arb_zero(tape_.coefficients(rates_[k].index()) + 1);
  }
}

void Step::watch_interfaces(const Stack& stack) {
  for (std::size_t k = 0; k < stack.size(); ++k) {
    if (const int side = start_.pattern[k]) {
      const Ball bound = magnitude(start_.angles[k]) + enclosure_.angle_reach[k];
      watched_.push_back({EventKind::impact, k, side, angles_[k], side, start_.zeros[k], magnitude(bound)});
    } else {
      const Margins<Series>& margins = accelerations_.margins[k];
      const Margins<Ball>& bounds = enclosure_.margins[k];
      watched_.push_back({EventKind::opening, k, 1, margins.right, 1, 0, bounds.right});
      watched_.push_back({EventKind::opening, k, -1, margins.left, 1, 0, bounds.left});
    }
  }
}

void Step::watch_toppling(const Stack& stack) {
  const std::vector<Series> theta = summed(start_.pattern, angles_);
  Ball bound;
  for (std::size_t k = 0; k < stack.size(); ++k) {
    bound = bound + magnitude(start_.angles[k]) + enclosure_.angle_reach[k];
    for (const int side : {1, -1}) {
      const Series left = Series(stack.toppling_angle[k]) - Series(side) * theta[k];
      if (left.is_constant()) continue;
      watched_.push_back(
          {EventKind::topple, k, side, left, 1, 0, magnitude(bound + stack.toppling_angle[k])});
    }
  }
}

ZeroSearch Step::search(const Watched& watched) const {
  if (watched.series.is_constant()) {
    if (!positive(Ball(watched.sign) * watched.series.constant()))
      throw Undecided("a guard is constant and not positive");
    return {{Ball(), length_}, {}};
  }
  return first_zero({watched.series.tape()->coefficients(watched.series.index()), tape_.terms(),
                     watched.zeros, watched.sign, watched.bound, enclosure_.radius},
                    length_);
}

Motion Step::at(const Ball& time) const {
  Motion result = start_;
  Ball left_out;
  {
    const Precision low(disc_bits);
    const Ball share = length_ / enclosure_.radius;
    left_out = power(share, static_cast<ulong>(tape_.terms())) / (Ball(1) - share);
  }
  const auto value = [&](const Series& series, const Ball& reach) {
    const Ball sum = polynomial(series.tape()->coefficients(series.index()), tape_.terms(), time);
    return sum + within(magnitude(reach * left_out));
  };
  for (std::size_t k = 0; k < angles_.size(); ++k) {
    result.zeros[k] = 0;
    if (!start_.pattern[k]) continue;
    result.angles[k] = value(angles_[k], enclosure_.angle_reach[k]);
    result.rates[k] = value(rates_[k], enclosure_.rate_reach[k]);
  }
  return result;
}

}  // namespace rockstack::proof
