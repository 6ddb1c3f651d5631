#include "comparisons/measures/metrics/centres.hpp"

namespace rockstack {

Centres centres_at(const Stack<double>& stack, const History& history, std::size_t sample) {
  const int size = stack.size();
  if (!history.places.empty()) {
    const auto first = static_cast<std::ptrdiff_t>(2 * sample * static_cast<std::size_t>(size));
    return {Points<double>::Map(history.places.data() + first, 2, size),
            Points<double>::Map(history.place_rates.data() + first, 2, size)};
  }
  const Chain<double> chain =
      make_chain(stack, history.patterns[sample],
                 Vector<double>(Vector<double>::Map(history.angles_at(sample).data(), size)));
  return {centres(chain), centre_velocities(chain, Vector<double>(Vector<double>::Map(
                                                       history.velocities_at(sample).data(), size)))};
}

}  // namespace rockstack
