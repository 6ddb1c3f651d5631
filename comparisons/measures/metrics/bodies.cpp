#include "comparisons/measures/metrics/bodies.hpp"

namespace rockstack {
namespace {

/// Up to what share of the least block height centres have not moved.
constexpr double rest_share = 1e-9;

/// The last tenth of an exact motion's samples. Quantities are vectors at a sample.
struct LastTenth {
  const History& exact;
  std::size_t first, last;

  /// Whether a quantity stays, by what it is measured by.
  template <class Quantity>
  bool rests(const Quantity& quantity, double scale) const {
    const Vector<double> end = quantity(last);
    for (std::size_t i = first; i < last; ++i)
      if ((quantity(i) - end).cwiseAbs().maxCoeff() > rest_share * scale) return false;
    return true;
  }

  /// Whether a part of a quantity has gone one way over the last half, but for a share: what rocks
  /// has not.
  template <class Quantity>
  bool goes_one_way(const Quantity& quantity, Eigen::Index part, int size) const {
    constexpr std::size_t pieces = 20;
    constexpr double share = 0.2;
    const std::size_t length = 5 * (last - first), start = last > length ? last - length : 0;
    const auto at = [&](std::size_t piece) {
      return Vector<double>(quantity(start + piece * (last - start) / pieces).segment(part, size));
    };
    double path = 0;
    for (std::size_t piece = 0; piece < pieces; ++piece) path += (at(piece + 1) - at(piece)).norm();
    return path <= (1 + share) * (at(pieces) - at(0)).norm();
  }

  /// The largest speed at which a part of a quantity, of so many numbers, goes one way in both halves.
  template <class Quantity>
  double largest_drift(const Quantity& quantity, int part) const {
    const std::size_t middle = (first + last) / 2;
    const Vector<double> before = (quantity(middle) - quantity(first)) /
                                  (exact.times[middle] - exact.times[first]),
                         after =
                             (quantity(last) - quantity(middle)) / (exact.times[last] - exact.times[middle]);
    double drift = 0;
    for (Eigen::Index k = 0; k < before.size(); k += part) {
      const auto one = before.segment(k, part), other = after.segment(k, part);
      if (one.dot(other) > 0 && goes_one_way(quantity, k, part))
        drift = std::max(drift, std::min(one.norm(), other.norm()));
    }
    return drift;
  }
};

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

Unrest unrest_of(const Scene& scene, const History& exact, const History& motion,
                 const std::vector<double>& centres, const std::vector<double>& gaps) {
  const std::size_t count = std::min(exact.size(), gaps.size());
  if (count < 20) return {};
  const Stack<double> stack = make_stack<double>(scene);
  const LastTenth tenth{exact, count - count / 10, count - 1};
  const auto exact_angles = [&](std::size_t sample) { return vector_of(exact.angles_at(sample)); };
  const auto exact_places = [&](std::size_t sample) {
    return Vector<double>(centre_places(stack, exact, sample).reshaped());
  };
  const auto angles = [&](std::size_t sample) { return vector_of(motion.angles_at(sample)); };
  const auto places = [&](std::size_t sample) {
    return Vector<double>(Vector<double>::Map(centres.data() + 2 * sample * scene.blocks.size(),
                                              Eigen::Index{2} * stack.size()));
  };
  Unrest unrest;
  if (tenth.rests(exact_angles, 1)) unrest.turn = tenth.largest_drift(angles, 1);
  if (tenth.rests(exact_places, least_height(scene.blocks))) {
    unrest.creep = tenth.largest_drift(places, 2);
    unrest.offset =
        (places(tenth.last) - exact_places(tenth.last)).reshaped(2, stack.size()).colwise().norm().maxCoeff();
  }
  const auto extremes = [&](const std::vector<double>& list) {
    const auto end = list.begin() + static_cast<std::ptrdiff_t>(count);
    const auto [low, high] =
        std::minmax_element(list.begin() + static_cast<std::ptrdiff_t>(tenth.first), end);
    return std::pair(*low, *high);
  };
  if (extremes(largest_gaps(exact)).second == 0) {
    const auto [low, high] = extremes(gaps);
    unrest.hover = high - low < 0.01 * high ? low : 0;
  }
  return unrest;
}

std::vector<double> largest_gaps(const History& history) {
  std::vector<double> list(history.size(), 0);
  const auto blocks = static_cast<std::size_t>(history.blocks);
  for (std::size_t i = 0; i < history.gaps.size(); ++i)
    if (std::isfinite(history.gaps[i])) list[i / blocks] = std::max(list[i / blocks], history.gaps[i]);
  return list;
}

double largest_rise(const History& exact, const std::vector<double>& gaps, double horizon, double lag) {
  std::vector<double> later = largest_gaps(exact);  // the largest from each sample on
  for (std::size_t i = later.size(); i-- > 1;) later[i - 1] = std::max(later[i - 1], later[i]);
  double rise = 0;
  for (std::size_t i = 0, from = 0; i < std::min(later.size(), gaps.size()); ++i) {
    while (exact.times[from] < std::min(exact.times[i], horizon) - lag) ++from;
    rise = std::max(rise, gaps[i] - later[from]);
  }
  return rise;
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
