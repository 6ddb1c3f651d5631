#include "analytic/scene/ground/records/format.hpp"

namespace rockstack::records {
namespace {

/// A row of a symmetric band of three.
struct Row {
  double outer = 0, middle = 0;
};

/// Solves outer x[k−1] + middle x[k] + outer x[k+1] = b[k] in place, with `end` as the first and the last
/// row. Precondition: the middle outweighs what is beside it.
void solve_band(const Row& inner, const Row& end, std::vector<double>& b) {
  std::vector<double> above(b.size());
  for (std::size_t k = 0; k < b.size(); ++k) {
    const Row& row = k == 0 || k + 1 == b.size() ? end : inner;
    const double below = k == 0 ? 0 : row.outer;
    const double pivot = row.middle - (k == 0 ? 0 : below * above[k - 1]);
    above[k] = row.outer / pivot;
    b[k] = (b[k] - (k == 0 ? 0 : below * b[k - 1])) / pivot;
  }
  for (std::size_t k = b.size() - 1; k > 0; --k) b[k - 1] -= above[k - 1] * b[k];
}

}  // namespace

Record acceleration_of_velocity(double interval, const std::vector<double>& velocities) {
  std::vector<double> middles;
  for (std::size_t k = 0; k + 1 < velocities.size(); ++k)
    middles.push_back((velocities[k + 1] - velocities[k]) / interval);
  if (middles.size() > 1) solve_band({1.0 / 8, 6.0 / 8}, {1.0 / 8, 7.0 / 8}, middles);
  Record motion{interval / 2, {middles.front()}, {}};
  for (std::size_t k = 0; k < middles.size(); ++k) {
    motion.samples.push_back(middles[k]);
    motion.samples.push_back(k + 1 < middles.size() ? (middles[k] + middles[k + 1]) / 2 : middles[k]);
  }
  return motion;
}

Record acceleration_of_displacement(double interval, const std::vector<double>& displacements) {
  const std::size_t last = displacements.size() - 1;
  std::vector<double> samples;
  for (std::size_t k = 0; k <= last; ++k) {
    const double before = displacements[k == 0 ? 1 : k - 1], after = displacements[k == last ? k - 1 : k + 1];
    samples.push_back((before - 2 * displacements[k] + after) / (interval * interval));
  }
  solve_band({1.0 / 6, 4.0 / 6}, {2.0 / 6, 4.0 / 6}, samples);
  return {interval, samples, {}};
}

}  // namespace rockstack::records
