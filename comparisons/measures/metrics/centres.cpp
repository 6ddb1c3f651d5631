#include "comparisons/measures/metrics/centres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rockstack {

Centres centres_at(const Stack<double>& stack, const History& history, std::size_t sample) {
  const int size = stack.size();
  if (!history.centres.empty()) {
    const auto first = static_cast<std::ptrdiff_t>(2 * sample * static_cast<std::size_t>(size));
    return {Points<double>::Map(history.centres.data() + first, 2, size),
            Points<double>::Map(history.centre_velocities.data() + first, 2, size)};
  }
  const Chain<double> chain =
      make_chain(stack, history.patterns[sample],
                 Vector<double>(Vector<double>::Map(history.angles_at(sample).data(), size)));
  return {centres(chain), centre_velocities(chain, Vector<double>(Vector<double>::Map(
                                                       history.velocities_at(sample).data(), size)))};
}

std::vector<double> centres_of(const Scene& scene, const History& history) {
  if (!history.centres.empty()) return history.centres;
  const Stack<double> stack = make_stack<double>(scene);
  std::vector<double> result;
  result.reserve(2 * history.angles.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Points<double> at = centres_at(stack, history, i).at;
    result.insert(result.end(), at.data(), at.data() + at.size());
  }
  return result;
}

Difference position_difference(const std::vector<double>& times, const std::vector<double>& first,
                               const std::vector<double>& second, std::size_t blocks) {
  Difference result{blocks, times, {}};
  result.values.reserve(times.size() * blocks);
  for (std::size_t i = 0; i < 2 * times.size() * blocks; i += 2)
    result.values.push_back(std::hypot(second[i] - first[i], second[i + 1] - first[i + 1]));
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

double least_height(const std::vector<Block>& blocks) {
  double height = std::numeric_limits<double>::infinity();
  for (const Block& block : blocks) height = std::min(height, 2 * block.half_height);
  return height;
}

}  // namespace rockstack
