#include "tests/analytic/reference/random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/analytic/solver/stacks.hpp"

namespace rockstack::testing {
namespace {

/// A history, or the words with which the model could not go on.
template <class Real>
struct Attempt {
  BasicHistory<Real> history;
  std::string failure;
};

template <class Real, class Solve>
Attempt<Real> attempt(const Solve& solve_scene) {
  try {
    return {solve_scene(), {}};
  } catch (const std::runtime_error& error) {
    return {{}, error.what()};
  }
}

std::string words(const auto& history, std::size_t event) {
  std::ostringstream text;
  text.precision(20);
  if (event >= history.events.size()) return "the end";
  const auto& found = history.events[event];
  text << found.time << " s " << name(found.kind) << " at " << found.interface << ' ' << name(found.from)
       << "->" << name(found.to) << ' ' << name(found.consistency);
  return text.str();
}

// A solver rounds more than once, and not one number alone.
constexpr int several = 16;
constexpr int draws = 8;

/// Why two histories part, counted in a tally.
const char* explain(const Scene& scene, const History& found, const QuadHistory& expected,
                    const Agreement& response, std::size_t event, Tally& tally) {
  if (parts_at_resolution(found, expected, event)) {
    ++tally.at_resolution;
    return ": at the resolution of chatter";
  }
  if (parts_within_an_instant(found, expected, event)) {
    ++tally.within_instant;
    return ": impacts at one instant, together or one by one";
  }
  if (parts_at_decision(scene, found, event)) {
    ++tally.at_decision;
    return ": at the resolution of decisions";
  }
  if (response.parts && *response.parts <= event) {
    ++tally.sensitive_input;
    return " and part too";
  }
  if (parts_from_itself(scene, found, event, several, draws)) {
    ++tally.sensitive_arithmetic;
    return "; roundings of its operations part it from itself";
  }
  ++tally.unexplained;
  return "; UNEXPLAINED";
}

}  // namespace

Scene drawn_scene(std::uint64_t seed, Equations equations) {
  Draw draw(seed);
  const int size = 1 + draw.below(4);
  const int motion = draw.below(3);
  Scene scene = random_scene(draw, size, motion == 1);
  scene.equations = equations;
  if (motion == 2) shake(draw, scene);
  return scene;
}

Scene rubbing_scene_of(std::uint64_t seed) {
  Scene scene = drawn_scene(seed, Equations::nonlinear);
  scene.law = Law::unilateral;
  Draw draw(seed + 50000);
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) scene.friction.push_back(draw.between(0.1, 0.9));
  return scene;
}

std::string Tally::add(std::uint64_t seed, const Scene& scene) {
  const auto found = attempt<double>([&] { return solve(scene); });
  const auto expected = attempt<Quad>([&] { return reference(scene); });
  ++scenes;
  std::ostringstream text;
  text << "seed " << seed << ", " << scene.blocks.size() << " blocks: ";
  if (!found.failure.empty() || !expected.failure.empty()) {
    ++stuck;
    if (found.failure == expected.failure) return {};
    ++parted;
    ++unexplained;
    text << "found \"" << found.failure << "\", expected \"" << expected.failure << '"';
    return text.str();
  }
  events += expected.history.events.size();
  const Agreement agreement = compare(found.history, expected.history);
  Deviation largest;
  std::size_t matched = 0;
  constexpr double small = 1e-10;
  std::optional<Agreement> response;
  for (; matched < agreement.events.size(); ++matched) {
    const Deviation& deviation = agreement.events[matched];
    if (std::abs(deviation.time) > small || deviation.state > small) {
      if (!response) response = response_to_rounding(scene, expected.history, several, draws, agreement);
      if (matched >= response->events.size()) break;
      const Deviation& own = response->events[matched];
      amplified = std::max({amplified, std::abs(deviation.time) / own.time, deviation.state / own.state});
    }
    largest.time = std::max(largest.time, std::abs(deviation.time));
    largest.state = std::max(largest.state, deviation.state);
  }
  worst.time = std::max(worst.time, largest.time);
  worst.state = std::max(worst.state, largest.state);
  if (response) ++sensitive;
  if (!agreement.parts) return {};
  ++parted;
  const std::size_t event = *agreement.parts;
  if (!response) response = response_to_rounding(scene, expected.history, several, draws, agreement);
  const char* reason = explain(scene, found.history, expected.history, *response, event, *this);
  text << "event " << event << " of " << expected.history.events.size() << ": found "
       << words(found.history, event) << ", expected " << words(expected.history, event)
       << "; before it off by " << largest.time << " s, roundings of the input make "
       << (response->events.empty() ? 0.0 : response->events.back().time) << " s" << reason;
  return text.str();
}

std::string Tally::summary() const {
  std::ostringstream text;
  text << scenes << " scenes, " << events << " events; in " << stuck << " scenes the model cannot go on; "
       << parted << " part from the reference: " << at_resolution << " at the resolution of chatter, "
       << within_instant << " within an instant, " << at_decision << " at that of decisions, "
       << sensitive_input << " as by roundings of the input, " << sensitive_arithmetic
       << " as by roundings of operations, " << unexplained << " unexplained; worst event time off by "
       << worst.time << " s, worst state by " << worst.state << "; " << sensitive
       << " scenes are off by more than 1e-10 somewhere, by at most " << amplified
       << " times what 16 roundings of their input make";
  return text.str();
}

}  // namespace rockstack::testing
