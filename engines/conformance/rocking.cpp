#include "engines/conformance/rocking.hpp"

namespace rockstack {

double quarter_period(const Housner& block, double start) {
  // Simpson's rule with θ = start − u², which takes the root's singularity away; 200 pieces err by < 1e-9 s.
  const auto integrand = [&](double u) {
    const double lean = block.slenderness - start;
    // (cos(lean) − cos(lean + u²)) / u², by the product of sines, with its limit at u = 0
    const double half = 0.5 * u * u;
    const double ratio = half > 0 ? std::sin(half) / half : 1;
    return 2 / (block.frequency * std::sqrt(2 * std::sin(lean + half) * ratio));
  };
  const int pieces = 200;
  const double width = std::sqrt(start) / pieces;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    sum += integrand(i * width) + 4 * integrand((i + 0.5) * width) + integrand((i + 1) * width);
  return sum * width / 6;
}

double first_ground_impact(const History& history) {
  const double side = history.angles_at(0)[0] < 0 ? -1 : 1;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const double before = history.angles_at(i - 1)[0], after = history.angles_at(i)[0];
    if (side * after > 0) continue;
    return history.times[i - 1] + (history.times[i] - history.times[i - 1]) * before / (before - after);
  }
  return std::nan("");
}

double pushed_angle(const Housner& block, double share, double time) {
  const double squared = block.frequency * block.frequency;
  const double start = squared * (share * std::cos(block.slenderness) - std::sin(block.slenderness));
  const double growth = squared * (std::cos(block.slenderness) + share * std::sin(block.slenderness));
  return start / growth * (std::cosh(std::sqrt(growth) * time) - 1);
}

}  // namespace rockstack
