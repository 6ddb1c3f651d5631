#include "comparisons/measures/metrics/difference.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

/// How many samples both have, from the start.
std::size_t common_samples(const History& first, const History& second) {
  const std::size_t count = std::min(first.size(), second.size());
  if (first.blocks != second.blocks ||
      !std::equal(first.times.begin(), first.times.begin() + static_cast<std::ptrdiff_t>(count),
                  second.times.begin())) {
    throw std::invalid_argument("histories can be compared only for the same blocks at the same times");
  }
  return count;
}

/// How many samples there are up to a time, the first one in any case.
std::size_t samples_up_to(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return std::min(times.size(), std::max<std::size_t>(1, static_cast<std::size_t>(after - times.begin())));
}

}  // namespace

Difference difference(const History& first, const History& second) {
  const std::size_t count = common_samples(first, second);
  const auto blocks = static_cast<std::size_t>(first.blocks);
  Difference result{blocks, first.times, std::vector<double>(count * blocks)};
  result.times.resize(count);
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = second.angles[i] - first.angles[i];
  return result;
}

Difference up_to(Difference difference, double time) {
  const std::size_t count = samples_up_to(difference.times, time);
  difference.times.resize(count);
  difference.values.resize(count * difference.blocks);
  return difference;
}

History up_to(History history, double time) {
  const std::size_t count = samples_up_to(history.times, time);
  const auto blocks = static_cast<std::size_t>(history.blocks);
  const auto shorten = [](auto& values, std::size_t size) {
    if (!values.empty()) values.resize(size);
  };
  history.times.resize(count);
  shorten(history.patterns, count);
  for (auto* values : {&history.angles, &history.velocities, &history.slips, &history.gaps})
    shorten(*values, count * blocks);
  for (auto* values : {&history.centres, &history.centre_velocities}) shorten(*values, 2 * count * blocks);
  shorten(history.reactions, count * blocks);
  shorten(history.spring_energies, count * blocks);
  std::erase_if(history.events, [&](const Event& event) { return event.time > time; });
  return history;
}

double largest(const Difference& difference) {
  return largest_magnitude(difference.values);
}

double root_mean_square(const Difference& difference) {
  double sum = 0;
  for (const double angle : difference.values) sum += angle * angle;
  return std::sqrt(sum / static_cast<double>(difference.values.size()));
}

double agreement_time(const Difference& difference, double tolerance) {
  for (std::size_t i = 0; i < difference.values.size(); ++i)
    if (std::abs(difference.values[i]) > tolerance) return difference.times[i / difference.blocks];
  return difference.times.back();
}

std::optional<SlipDifference> slip_difference(const History& first, const History& second) {
  if (first.slips.empty() || second.slips.empty()) return {};
  const std::size_t count = common_samples(first, second);
  SlipDifference result;
  for (std::size_t i = 0; i < count; ++i) {
    const auto one = first.row(first.slips, i), other = second.row(second.slips, i);
    result.last.reset();
    for (std::size_t k = 0; k < one.size(); ++k)
      if (first.patterns[i].contacts[k] != Contact::apart)
        result.last = std::max(result.last.value_or(0), std::abs(other[k] - one[k]));
    result.largest = std::max(result.largest, result.last.value_or(0));
  }
  return result;
}

DifferenceParts difference_parts(const History& exact, const History& rigid, const History& soft,
                                 const History& engine) {
  DifferenceParts parts{difference(exact, rigid), difference(rigid, soft), difference(soft, engine)};
  const std::size_t samples = std::min({exact.size(), rigid.size(), soft.size(), engine.size()});
  for (Difference* part : {&parts.model, &parts.softness, &parts.step})
    *part = up_to(std::move(*part), exact.times[samples - 1]);
  return parts;
}

std::optional<double> share_of(const Difference& part, const Difference& whole) {
  const auto product = [&](const Difference& other) {
    return std::inner_product(other.values.begin(), other.values.end(), whole.values.begin(), 0.0);
  };
  const double squares = product(whole);
  return squares > 0 ? std::optional(product(part) / squares) : std::nullopt;
}

Difference whole_of(const DifferenceParts& parts) {
  Difference whole = parts.model;
  for (std::size_t i = 0; i < whole.values.size(); ++i)
    whole.values[i] += parts.softness.values[i] + parts.step.values[i];
  return whole;
}

MagnitudePhase magnitude_phase(const History& exact, const History& other) {
  const std::size_t count = std::min(exact.angles.size(), other.angles.size());
  double exact_square = 0, other_square = 0;
  for (std::size_t i = 0; i < count; ++i) {
    exact_square += exact.angles[i] * exact.angles[i];
    other_square += other.angles[i] * other.angles[i];
  }
  const double exact_length = std::sqrt(exact_square), other_length = std::sqrt(other_square);
  // The angle by the half sum and half difference of unit vectors: the arc cosine loses small angles.
  double sum = 0, apart = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double one = exact.angles[i] / exact_length, two = other.angles[i] / other_length;
    sum += (one + two) * (one + two);
    apart += (one - two) * (one - two);
  }
  return {other_length / exact_length - 1,
          2 * std::atan2(std::sqrt(apart), std::sqrt(sum)) / std::numbers::pi};
}

}  // namespace rockstack
