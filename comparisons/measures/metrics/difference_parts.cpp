#include "comparisons/measures/metrics/difference_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rockstack {

DifferenceParts difference_parts(const History& exact, const History& rigid, const History& soft,
                                 const History& engine) {
  DifferenceParts parts{difference(exact, rigid), difference(rigid, soft), difference(soft, engine)};
  const std::size_t samples = std::min({exact.size(), rigid.size(), soft.size(), engine.size()});
  for (Difference* part : {&parts.model, &parts.softness, &parts.step}) {
    part->times.resize(samples);
    part->values.resize(samples * part->blocks);
  }
  return parts;
}

double share_of(const Difference& part, const Difference& whole) {
  const auto product = [&](const Difference& other) {
    return std::inner_product(other.values.begin(), other.values.end(), whole.values.begin(), 0.0);
  };
  const double squares = product(whole);
  return squares > 0 ? product(part) / squares : std::nan("");
}

Difference whole_of(const DifferenceParts& parts) {
  Difference whole = parts.model;
  for (std::size_t i = 0; i < whole.values.size(); ++i)
    whole.values[i] += parts.softness.values[i] + parts.step.values[i];
  return whole;
}

}  // namespace rockstack
