#include "tests/analytic/proof/ground.hpp"

#include <algorithm>

namespace rockstack::proof {
namespace {

using Shape = ExactMotion::Shape;

void add_cuts(const ExactMotion& motion, std::vector<Rational>& cuts) {
  for (std::size_t sample = 0; sample < motion.samples.size(); ++sample)
    cuts.push_back(Rational(static_cast<slong>(sample)) * motion.interval);
  if (motion.period.sign() > 0) {
    cuts.push_back(motion.start);
    cuts.push_back(motion.start + motion.length());
  }
}

/// The largest whole number that is not above. Precondition: ≥ 0.
std::size_t whole(const Rational& number) {
  fmpz_t quotient;
  fmpz_init(quotient);
  fmpz_fdiv_q(quotient, fmpq_numref(number.data()), fmpq_denref(number.data()));
  const auto result = static_cast<std::size_t>(fmpz_get_ui(quotient));
  fmpz_clear(quotient);
  return result;
}

GroundLine sample_line(const ExactMotion& motion, const Rational& start) {
  const std::size_t sample = whole(start / motion.interval);
  if (sample + 1 >= motion.samples.size()) return {};
  const Rational slope = (motion.samples[sample + 1] - motion.samples[sample]) / motion.interval;
  const Rational since = start - Rational(static_cast<slong>(sample)) * motion.interval;
  return {motion.samples[sample] + slope * since, slope, {}};
}

/// The near-fault pulse as three waves: the product of its envelope and carrier, by the sines of their sum
/// and difference.
std::vector<Wave> near_fault_waves(const ExactMotion& pulse, const Ball& turn, const Rational& elapsed) {
  const Ball cycles(pulse.cycles);
  const Ball centred(elapsed - pulse.length() / 2);
  const Ball envelope = turn / cycles;
  const Ball carrier_phase = turn * centred + Ball(pulse.phase);
  const Ball envelope_phase = envelope * centred;
  const Ball half = -Ball(pulse.amplitude) / 2;
  return {{half, turn, carrier_phase},
          {half * (Ball(1) + Ball(1) / cycles) / 2, turn + envelope, carrier_phase + envelope_phase},
          {half * (Ball(1) - Ball(1) / cycles) / 2, turn - envelope, carrier_phase - envelope_phase}};
}

GroundLine pulse_line(const ExactMotion& pulse, const Rational& start) {
  const Rational elapsed = start - pulse.start;
  if (elapsed.sign() < 0 || !(elapsed < pulse.length())) return {};
  if (pulse.shape == Shape::rectangle) return {pulse.amplitude, 0, {}};
  const Ball turn = half_turn() * 2 / Ball(pulse.period);
  if (pulse.shape == Shape::mavroeidis_papageorgiou) return {0, 0, near_fault_waves(pulse, turn, elapsed)};
  const Ball ahead = pulse.shape == Shape::cosine ? half_turn() / 2 : Ball();
  return {0, 0, {{pulse.amplitude, turn, turn * Ball(elapsed) + ahead}}};
}

GroundLine line(const ExactMotion& motion, const Rational& start) {
  if (motion.shape == Shape::none) return {};
  return motion.shape == Shape::samples ? sample_line(motion, start) : pulse_line(motion, start);
}

}  // namespace

std::vector<GroundPiece> ground_pieces(const ExactScene& scene) {
  std::vector<Rational> cuts{0, scene.duration};
  add_cuts(scene.horizontal, cuts);
  add_cuts(scene.vertical, cuts);
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<GroundPiece> pieces;
  for (std::size_t cut = 0; cut + 1 < cuts.size() && cuts[cut] < scene.duration; ++cut)
    pieces.push_back(
        {cuts[cut], cuts[cut + 1], line(scene.horizontal, cuts[cut]), line(scene.vertical, cuts[cut])});
  return pieces;
}

}  // namespace rockstack::proof
