#include "tests/analytic/unilateral/equal_widths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "analytic/solve.hpp"
#include "tests/analytic/unilateral/scenes.hpp"
#include "tests/analytic/unilateral/time_stepping.hpp"

namespace rockstack::testing {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double distance(const Bodies<>& one, const Bodies<>& other) {
  double largest = 0;
  for (std::size_t k = 0; k < one.pose.size(); ++k) {
    largest = std::max({largest, std::abs(one.pose[k].x - other.pose[k].x),
                        std::abs(one.pose[k].y - other.pose[k].y),
                        std::abs(one.pose[k].angle - other.pose[k].angle)});
  }
  return largest;
}

/// The first sample at which motions differ by more, s.
double parting(const History& one, const History& other, double largest) {
  const std::size_t size = std::min(one.size(), other.size());
  for (std::size_t i = 0; i < size; ++i)
    if (distance(bodies_at(one, i), bodies_at(other, i)) > largest) return one.times[i];
  if (one.size() == other.size()) return never;
  return (one.size() == size ? one : other).events.back().time;
}

double first_of_several(const History& history) {
  for (const Event& event : history.events)
    if (event.consistency != Consistency::consistent) return event.time;
  return never;
}

/// Calls `work` for all ways of widths.
template <class Do>
void for_all_ways(const Scene& scene, const Do& work) {
  for (unsigned wider = 0; wider < 1U << (scene.blocks.size() - 1); ++wider) work(wider);
}

Reason judged(const Scene& scene, const History& exact, double step) {
  const double bound = 5 * step;
  const auto off = [&](double length) {
    return distance(bodies_at_end(exact), time_stepped(scene, length, 1e-10));
  };
  if (off(step) < bound) return Reason::agree;
  for (const double part : {4.0, 16.0, 64.0})
    if (off(step / part) < bound / 4) return Reason::coarse;
  if (first_of_several(exact) == never) return Reason::unexplained;
  const Bodies<> stepped = time_stepped(scene, step / 4, 1e-10);
  double nearest = never;
  for_all_ways(scene, [&](unsigned wider) {
    nearest =
        std::min(nearest, distance(stepped, bodies_at_end(solve_unilateral(widened(scene, wider, 1e-9)))));
  });
  return nearest < bound ? Reason::several : Reason::unexplained;
}

void lean(Draw& draw, Scene& scene) {
  double below = 0;
  for (double& angle : scene.initial.angles) angle = below = draw.coin() ? draw.between(-0.3, 0.3) : below;
}

void give_rates(Draw& draw, Scene& scene) {
  std::vector<double>& rates = scene.initial.velocities;
  for (double& rate : rates) rate = draw.between(-1, 1);
  for (std::size_t k = 1; k < rates.size(); ++k)
    if (scene.initial.angles[k] == scene.initial.angles[k - 1]) rates[k] = rates[k - 1];
}

void move_ground(Draw& draw, Scene& scene) {
  const double g = scene.gravity;
  const double side = draw.coin() ? 1 : -1;
  scene.horizontal = pulse_of(PulseShape::sine, side * draw.between(0.2, 1.2) * g, draw.between(0.2, 0.8),
                              draw.between(0, 0.1));
  if (draw.below(3) == 0)
    scene.vertical = pulse_of(PulseShape::half_sine, draw.between(-1.5, 1) * g, draw.between(0.1, 0.3),
                              draw.between(0, 0.1));
}

}  // namespace

Scene equal_widths(std::uint64_t seed) {
  Draw draw(7000 + seed);
  const std::size_t size = draw.below(2) == 0 ? 2 : 3;
  const double width = draw.between(0.5, 1.5);
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < size; ++k) blocks.push_back(block(width, draw.between(0.4, 2)));
  Scene scene =
      with_friction(released(std::move(blocks), std::vector<double>(size, 0), draw.between(0.2, 0.6)), 0);
  for (double& friction : scene.friction) friction = draw.between(0.1, 1);
  const int kind = draw.below(4);
  if (kind != 0) lean(draw, scene);
  if (kind == 2) give_rates(draw, scene);
  if (kind == 0 || kind == 3) move_ground(draw, scene);
  return scene;
}

Scene widened(Scene scene, unsigned wider, double share) {
  double factor = 1;
  for (std::size_t k = 1; k < scene.blocks.size(); ++k) {
    factor *= 1 + ((wider >> (k - 1) & 1U) != 0 ? share : -share);
    scene.blocks[k].half_width *= factor;
  }
  return scene;
}

std::string LimitTally::add(std::uint64_t seed, double share) {
  const Scene scene = equal_widths(seed);
  const SolveOptions options{.sample_times = regular_times(scene.duration / 200, scene.duration)};
  const History equal = solve_unilateral(scene, options);
  std::vector<History> limits;
  for_all_ways(scene, [&](unsigned wider) {
    limits.push_back(solve_unilateral(widened(scene, wider, share), options));
  });
  const double largest = 30 * std::sqrt(share);
  double limits_part = never;
  double equal_parts = never;
  for (const History& limit : limits) {
    limits_part = std::min(limits_part, parting(limits.front(), limit, largest));
    equal_parts = std::min(equal_parts, parting(equal, limit, largest));
  }
  ++(limits_part == never ? agree : part);
  const double told = first_of_several(equal);
  if (std::min(limits_part, equal_parts) >= told || (limits_part == never && equal_parts == never)) return {};
  std::ostringstream text;
  text << "seed " << seed << ": other widths part from each other at " << limits_part
       << " s, equal ones from them at " << equal_parts << " s, several motions are told at " << told << " s";
  return text.str();
}

const char* name(Reason reason) {
  constexpr const char* names[] = {"agree", "finer steps agree", "another of several motions", "UNEXPLAINED"};
  return names[static_cast<std::size_t>(reason)];
}

std::string StepTally::add(std::uint64_t seed, double step) {
  const Scene scene = equal_widths(seed);
  const Reason found = judged(scene, solve_unilateral(scene), step);
  ++scenes[static_cast<std::size_t>(found)];
  if (found == Reason::agree) return {};
  return "seed " + std::to_string(seed) + ": " + name(found);
}

std::string StepTally::summary() const {
  std::ostringstream text;
  for (std::size_t i = 0; i < reasons; ++i) text << name(static_cast<Reason>(i)) << ": " << scenes[i] << '\n';
  return text.str();
}

}  // namespace rockstack::testing
