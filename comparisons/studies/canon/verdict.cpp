#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/statistics/fits.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/studies/canon/canon.hpp"

namespace rockstack {
namespace {

constexpr double usual_step = 1e-3;  ///< s
constexpr double vanishing = 1e-9;   ///< a deviation that is less is none, s

/// Largest speed of each block's slips or gaps between samples, m/s; over nothing there is no gap.
double largest_speed(const History& history, const std::vector<double>& ways) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  double most = 0;
  for (std::size_t i = blocks; i < ways.size(); ++i) {
    const double interval = history.times[i / blocks] - history.times[i / blocks - 1];
    const double speed = std::abs(ways[i] - ways[i - blocks]) / interval;
    if (std::isfinite(speed)) most = std::max(most, speed);
  }
  return most;
}

/// What an engine is off by over all samples and blocks, residual(sample, block): the largest, and how
/// successive ones correlate about zero, which is 1 less half of von Neumann's ratio.
template <class Residual>
Deviation deviation(const char* quantity, double speed, const Difference& shape, const Residual& residual) {
  double most = 0, squares = 0, products = 0;
  for (std::size_t block = 0; block < shape.blocks; ++block) {
    double before = 0;
    for (std::size_t sample = 0; sample < shape.times.size(); ++sample) {
      const double off = residual(sample, block);
      most = std::max(most, std::abs(off));
      squares += off * off;
      products += before * off;
      before = off;
    }
  }
  return {most / speed, speed, quantity, squares > 0 ? products / squares : 1};
}

/// Speed of the flattest turn: a corner falls freely for one step, rad/s.
double slowest_turn(const Scene& scene) {
  const Block& widest = *std::ranges::max_element(scene.blocks, {}, &Block::half_width);
  return scene.gravity * usual_step / (2 * widest.half_width);
}

bool follows_law(const std::string& verdict) {
  return verdict == "agrees" || verdict == "converges";
}

/// Deviation of the replicate in the middle, by a quantity.
Deviation middle_of(const CanonErrors& errors, std::size_t quantity) {
  auto replicates = mapped(errors.replicates, [&](const auto& each) { return each.at(quantity); });
  const auto middle = replicates.begin() + static_cast<std::ptrdiff_t>((replicates.size() - 1) / 2);
  std::ranges::nth_element(replicates, middle, {}, &Deviation::time);
  return *middle;
}

/// Verdict and reason, from the fit and what the medians are.
std::pair<std::string, std::string> verdict_by_fit(const std::vector<Deviation>& medians,
                                                   const StepFit& fit) {
  const Deviation &coarsest = medians.front(), &finest = medians.back();
  const Bounded& left = fit.model_error;
  const auto amount = [&](double time) { return quantity_text(time * finest.speed, finest.unit(), 2); };
  // The three finest steps differ by four: under any order from a half on, the error falls by a
  // factor of two or more between them.
  const auto [finest_least, finest_most] =
      std::ranges::minmax_element(std::span(medians).last(3), {}, &Deviation::time);
  const double least = finest_least->time, most = finest_most->time;
  if (most <= canon_resolution)
    return {"agrees", "off by a tenth of a step of 1 ms at most at the three finest steps"};
  if (least > canon_resolution && most <= std::sqrt(2) * least)
    return {"another law",
            fmt::format("{}: {} to {} whatever the step", finest.of, amount(least), amount(most))};
  if (left.low > canon_resolution)
    return {"another law", fmt::format("{}: {} is left at any step ({} to {})", finest.of, amount(left.value),
                                       amount(left.low), amount(left.high))};
  if (std::max(finest.time, medians.end()[-2].time) <= vanishing)
    return {"converges", finest.of + ": nothing is left at the two finest steps"};
  if (!(finest.time <= 0.5 * coarsest.time))
    return {"cannot tell", fmt::format("{}: the errors do not fall with the step, {} at {} and {} at {}",
                                       finest.of, quantity_text(coarsest.amount(), coarsest.unit(), 2),
                                       quantity_text(canon_steps.front(), "s"), amount(finest.time),
                                       quantity_text(canon_steps.back(), "s"))};
  if (fit.points < medians.size() || fit.scatter > std::log(3))
    return {"cannot tell", finest.of + ": " + fit.reason};
  if (left.high > canon_agreement * usual_step)
    return {"cannot tell", fmt::format("{}: up to {} may be left at any step", finest.of, amount(left.high))};
  const char* verdict = finest.time <= canon_agreement * canon_steps.back() ? "agrees" : "converges";
  if (fit.holds())
    return {verdict, fmt::format("{}: fall with order {:.2g} ({:.2g} to {:.2g})", finest.of, fit.order.value,
                                 fit.order.low, fit.order.high)};
  return {verdict,
          fmt::format("{}: fall to {:.2g} steps at the finest", finest.of, finest.time / canon_steps.back())};
}

/// The verdict by the fit, unless what is off at the finest step is scatter.
std::pair<std::string, std::string> verdict_on(const std::vector<Deviation>& medians, const StepFit& fit) {
  auto verdict = verdict_by_fit(medians, fit);
  const Deviation& finest = medians.back();
  if (follows_law(verdict.first) || std::abs(finest.correlation) >= canon_scatter) return verdict;
  return {"scatters",
          fmt::format("{}: {} at the finest step is noise, as successive samples correlate by {:.2f}; a law "
                      "leaves less",
                      finest.of, quantity_text(finest.amount(), finest.unit(), 2), finest.correlation)};
}

}  // namespace

std::vector<Deviation> deviations(const Scene& scene, const History& exact, const History& engine) {
  const double turn = std::max(largest_magnitude(exact.velocities), slowest_turn(scene));
  const Difference angles = difference(exact, engine);
  std::vector<Deviation> all{
      deviation("angles", turn, angles, [&](auto sample, auto block) { return angles.at(sample)[block]; })};
  if (exact.slips.empty() || engine.slips.empty()) return all;
  const auto add = [&](const char* quantity, const std::vector<double> History::*ways, double slowest,
                       const auto& counts) {
    const auto residual = [&](std::size_t sample, std::size_t block) {
      const std::size_t at = sample * angles.blocks + block;
      const double off = (engine.*ways)[at] - (exact.*ways)[at];
      return std::isfinite(off) && counts(sample, block) ? off : 0;
    };
    const double speed = std::max(largest_speed(exact, exact.*ways), slowest);
    all.push_back(deviation(quantity, speed, angles, residual));
  };
  add("slips", &History::slips, scene.gravity * usual_step, [&](std::size_t sample, std::size_t block) {
    return exact.patterns[sample].contacts[block] != Contact::apart;
  });
  add("gaps", &History::gaps, told_sinking * least_height(scene.blocks) / canon_resolution,
      [](std::size_t, std::size_t) { return true; });
  return all;
}

CanonAnswer judge_canon(const std::string& scene, const std::vector<CanonErrors>& errors) {
  const std::vector<std::string> from_best{"agrees", "converges", "cannot tell", "scatters", "another law"};
  const auto off = [&](const CanonAnswer& answer) {
    return std::pair(std::ranges::find(from_best, answer.verdict), answer.deviations.back().time);
  };
  std::vector<CanonAnswer> answers;
  for (std::size_t quantity = 0; quantity < errors.front().replicates.front().size(); ++quantity) {
    CanonAnswer& answer = answers.emplace_back(CanonAnswer{scene, {}, "", ""});
    std::vector<StepError> medians;
    for (const CanonErrors& at : errors) {
      answer.deviations.push_back(middle_of(at, quantity));
      medians.push_back({at.step, answer.deviations.back().time});
    }
    std::tie(answer.verdict, answer.reason) = verdict_on(answer.deviations, fit_steps(medians));
  }
  return *std::ranges::max_element(answers,
                                   [&](const auto& one, const auto& other) { return off(one) < off(other); });
}

bool follows_law(const CanonAnswer& answer) {
  return follows_law(answer.verdict);
}

}  // namespace rockstack
