#include "comparisons/measures/metrics/bodies.hpp"

namespace rockstack {
namespace {

/// Up to what share of the least block height centres have not moved.
constexpr double rest_share = 1e-9;

}  // namespace

Points<double> centre_places(const Stack<double>& stack, const History& history, std::size_t sample) {
  const auto first = static_cast<std::ptrdiff_t>(2 * sample * static_cast<std::size_t>(stack.size()));
  if (!history.centres.empty()) return Points<double>::Map(history.centres.data() + first, 2, stack.size());
  const Vector<double> angles = vector_of(history.angles_at(sample));
  const Vector<double> open = relative(angles);
  return centres(make_chain(
      stack, history.patterns.empty() ? pattern_of(open, open) : history.patterns[sample], angles));
}

Centres centres_at(const Stack<double>& stack, const History& history, std::size_t sample) {
  const int size = stack.size();
  if (!history.centres.empty()) {
    const auto first = static_cast<std::ptrdiff_t>(2 * sample * static_cast<std::size_t>(size));
    return {Points<double>::Map(history.centres.data() + first, 2, size),
            Points<double>::Map(history.centre_velocities.data() + first, 2, size)};
  }
  const Chain<double> chain =
      make_chain(stack, history.patterns[sample], vector_of(history.angles_at(sample)));
  return {centres(chain), centre_velocities(chain, vector_of(history.velocities_at(sample)))};
}

Points<double> centre_displacements(const Stack<double>& stack, const History& history, std::size_t sample) {
  const int size = stack.size();
  if (!history.centres.empty()) {
    const Vector<double> upright = Vector<double>::Zero(size);
    return centre_places(stack, history, sample) - centres(make_chain(stack, closed_pattern(size), upright));
  }
  // A chain whose cosines are less by one is that of the differences from the upright one.
  const Vector<double> angles = vector_of(history.angles_at(sample));
  const Vector<double> half = (angles / 2).array().sin();
  const Directions<double> turns{-2 * half.cwiseAbs2(), angles.array().sin()};
  Chain<double> moved = make_chain(stack, history.patterns[sample], turns);
  moved.foot.setZero();
  return centres(moved);
}

std::vector<double> centres_of(const Scene& scene, const History& history) {
  if (!history.centres.empty()) return history.centres;
  const Stack<double> stack = make_stack<double>(scene);
  std::vector<double> result;
  result.reserve(2 * history.angles.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Points<double> at = centre_places(stack, history, i);
    result.insert(result.end(), at.data(), at.data() + at.size());
  }
  return result;
}

double extent_of_motion(const Scene& scene, const History& history, const std::vector<double>& centres) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  double turn = 0, way = 0;
  for (std::size_t i = 0; i < history.angles.size(); ++i)
    turn = std::max(turn, std::abs(history.angles[i] - history.angles[i % blocks]));
  for (std::size_t i = 0; i < 2 * history.angles.size(); i += 2)
    way = std::max(way, std::hypot(centres[i] - centres[i % (2 * blocks)],
                                   centres[i + 1] - centres[i % (2 * blocks) + 1]));
  return std::max(turn, way / least_height(scene.blocks));
}

std::optional<Unrest> unrest_of(const Scene& scene, const History& exact, const std::vector<double>& centres,
                                const std::vector<double>& gaps) {
  const std::size_t count = std::min(exact.size(), gaps.size());
  if (count < 20) return {};
  const Stack<double> stack = make_stack<double>(scene);
  const std::size_t last = count - 1, first = count - count / 10, middle = (first + last) / 2;
  const Points<double> rest = centre_places(stack, exact, last);
  for (std::size_t i = first; i < last; ++i)
    if ((centre_places(stack, exact, i) - rest).cwiseAbs().maxCoeff() >
        rest_share * least_height(scene.blocks))
      return {};
  const auto at = [&](std::size_t sample) {
    return Points<double>::Map(centres.data() + 2 * sample * scene.blocks.size(), 2, stack.size());
  };
  const Points<double> before = (at(middle) - at(first)) / (exact.times[middle] - exact.times[first]),
                       after = (at(last) - at(middle)) / (exact.times[last] - exact.times[middle]);
  Unrest unrest;
  for (int k = 0; k < stack.size(); ++k)
    if (before.col(k).dot(after.col(k)) > 0)
      unrest.creep = std::max(unrest.creep, std::min(before.col(k).norm(), after.col(k).norm()));
  unrest.offset = (at(last) - rest).colwise().norm().maxCoeff();
  const auto shown = std::span(gaps).subspan(first, count - first);
  const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
  if (*high - *low < 0.01 * *high) unrest.hover = *low;
  return unrest;
}

double least_height(const std::vector<Block>& blocks) {
  return 2 * std::ranges::min_element(blocks, {}, &Block::half_height)->half_height;
}

std::vector<double> energies(const Scene& scene, const History& history) {
  const Stack<double> stack = make_stack<double>(scene);
  const Gravity gravity = gravity_of(scene);
  std::vector<double> list;
  list.reserve(history.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Vector<double> velocities = vector_of(history.velocities_at(i));
    const Points<double> speeds = centres_at(stack, history, i).rate;
    const Points<double> moved = centre_displacements(stack, history, i);
    double energy = 0;
    for (int k = 0; k < stack.size(); ++k)
      energy += 0.5 * stack.mass[k] * speeds.col(k).squaredNorm() +
                0.5 * stack.inertia[k] * velocities[k] * velocities[k] +
                stack.mass[k] * (gravity.across * moved(1, k) - gravity.along * moved(0, k));
    list.push_back(energy);
  }
  return list;
}

double energy_scale(const Scene& scene) {
  double sum = 0, height = 0;
  for (const Block& block : scene.blocks) {
    sum += block.mass * scene.gravity * (height + block.half_height + block.offset_y);
    height += 2 * block.half_height;
  }
  return sum;
}

std::vector<double> energy_balance(const std::vector<double>& energy, const std::vector<double>& input,
                                   const std::vector<double>& elastic) {
  std::vector<double> balance;
  balance.reserve(energy.size());
  for (std::size_t i = 0; i < energy.size(); ++i) balance.push_back(energy[i] - input[i] + elastic[i]);
  return balance;
}

double largest_gain(const std::vector<double>& energy) {
  double gain = 0, least = energy.front();
  for (const double now : energy) {
    least = std::min(least, now);
    gain = std::max(gain, now - least);
  }
  return gain;
}

}  // namespace rockstack
