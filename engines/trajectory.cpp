#include "engines/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/input_error.hpp"

namespace rockstack {
namespace {

/// Relative values of interfaces: what a block has less what the block below has.
std::vector<double> relative_to_below(std::span<const double> values) {
  std::vector<double> list(values.begin(), values.end());
  for (std::size_t k = 1; k < values.size(); ++k) list[k] -= values[k - 1];
  return list;
}

/// Lesser value of the two bodies that meet at each interface; above the ground that of the block.
std::vector<double> lesser(const std::vector<Placement>& blocks, double Placement::*value) {
  std::vector<double> list;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    list.push_back(std::min(blocks[k].*value, blocks[k == 0 ? 0 : k - 1].*value));
  return list;
}

}  // namespace

ContactWatch::ContactWatch(const Setup& setup, double largest_friction)
    : dt_(setup.dt),
      friction_(setup.friction),
      widths_(lesser(setup.blocks, &Placement::width)),
      offsets_(mapped(setup.blocks, &Placement::offset_x)),
      masses_(lesser(setup.blocks, &Placement::mass)),
      last_ends_(setup.blocks.size()) {
  for (double& friction : friction_) friction = std::min(friction, largest_friction);
}

void ContactWatch::observe(const std::vector<ContactPoint>& points, std::span<const double> angles,
                           std::span<const double> velocities) {
  record_.elastic.push_back(elastic_energy(points));
  add_forces(points);
  std::vector<Ends> ends = ends_of(points);
  add_counts(ends);
  std::vector<double> now_velocities = relative_to_below(velocities);
  if (samples_ > 0) add_impacts(ends, now_velocities);
  last_ends_ = std::move(ends);
  std::vector<double> now_angles = relative_to_below(angles);
  angles_before_ = samples_ > 0 ? std::move(angles_) : now_angles;
  angles_ = std::move(now_angles);
  velocities_ = std::move(now_velocities);
  ++samples_;
}

double ContactWatch::elastic_energy(const std::vector<ContactPoint>& points) const {
  double energy = 0;
  for (const ContactPoint& point : points) {
    const bool followed = point.stiffness * dt_ * dt_ <= masses_[point.interface];
    if (followed && point.gap < 0) energy += 0.5 * point.stiffness * point.gap * point.gap;
  }
  return energy;
}

void ContactWatch::add_forces(const std::vector<ContactPoint>& points) {
  for (const ContactPoint& point : points) {
    const double push = std::max(0.0, point.normal);
    excess_ += std::max(0.0, point.tangential - friction_[point.interface] * push);
    if (push == 0) continue;
    record_.complementarity = std::max(record_.complementarity, point.gap * push / dt_);
    pushed_ += push;
    rigid_ |= std::isinf(point.stiffness) || std::isinf(point.damping);
    given_ += point.normal / point.stiffness;
    damped_ += point.normal * point.damping;
  }
  record_.friction_excess = pushed_ > 0 ? excess_ / pushed_ : 0;
  const bool soft = !rigid_ && given_ != 0;
  record_.stiffness = soft ? pushed_ / given_ : std::numeric_limits<double>::infinity();
  record_.damping = soft ? damped_ / pushed_ : 0;
}

void ContactWatch::add_counts(const std::vector<Ends>& ends) {
  for (const Ends& both : ends)
    for (const End& end : both) {
      counted_ += end.impulse * end.points;
      borne_ += end.impulse;
    }
  record_.points = borne_ > 0 ? counted_ / borne_ : 1;
}

std::vector<ContactWatch::Ends> ContactWatch::ends_of(const std::vector<ContactPoint>& points) const {
  std::vector<Ends> ends(widths_.size());
  for (const ContactPoint& point : points) {
    if (point.normal <= 0) continue;
    End& end = ends[point.interface][point.along + offsets_[point.interface] < 0 ? 0 : 1];
    end.gap = end.impulse > 0 ? std::min(end.gap, point.gap_before) : point.gap_before;
    end.impulse += point.normal;
    ++end.points;
  }
  return ends;
}

void ContactWatch::add_impacts(const std::vector<Ends>& ends, const std::vector<double>& velocities) {
  const double start = static_cast<double>(samples_ - 1) * dt_;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    for (const int side : {-1, 1}) {
      const std::size_t end = side < 0 ? 0 : 1;
      const double speed = side * velocities_[k];
      // An engine that finds contacts by overlap answers a step late.
      const bool was_off = side * angles_before_[k] < 0;
      if (ends[k][end].impulse <= 0 || last_ends_[k][end].impulse > 0 || speed <= 0 || !was_off) continue;
      const double touching = start + ends[k][end].gap / (widths_[k] * speed);
      const double time = std::clamp(touching, 0.0, static_cast<double>(samples_) * dt_);
      record_.impacts.push_back({time, static_cast<int>(k) + 1, speed, velocities[k]});
    }
  }
}

std::vector<Reaction> step_reactions(const Setup& setup, const std::vector<ContactPoint>& points,
                                     std::span<const double> angles) {
  const std::size_t blocks = setup.blocks.size();
  std::vector<Reaction> list(blocks);
  std::vector<double> pushed(blocks), moments(blocks);
  for (const ContactPoint& point : points) {
    const std::size_t k = point.interface;
    const bool on_upper = k > 0 && setup.blocks[k].width > setup.blocks[k - 1].width;
    const double angle = on_upper ? angles[k] : k > 0 ? angles[k - 1] : 0;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    list[k].normal += (point.impulse_x * sine + point.impulse_y * cosine) / setup.dt;
    list[k].tangential += (point.impulse_x * cosine - point.impulse_y * sine) / setup.dt;
    pushed[k] += point.normal;
    moments[k] += point.normal * point.along;
  }
  for (std::size_t k = 0; k < blocks; ++k)
    list[k].centre = pushed[k] > 0 ? moments[k] / pushed[k] + setup.blocks[k].offset_x
                                   : std::numeric_limits<double>::quiet_NaN();
  return list;
}

bool has_ended(const Setup& setup, const Trajectory& trajectory) {
  const auto last = trajectory.angles.end() - static_cast<std::ptrdiff_t>(setup.blocks.size());
  return !std::equal(last, trajectory.angles.end(), setup.toppling_angles.begin(),
                     [](double angle, double most) { return std::abs(angle) <= most; });
}

void require_finite(const Trajectory& trajectory, std::size_t blocks, double dt) {
  const auto require = [&](double value, const char* quantity, std::size_t i) {
    if (std::abs(value) <= largest_number) return;
    const std::size_t sample = i / blocks;
    throw NotFinite(fmt::format("{} of block {} is not finite at t = {} s{}", quantity, i % blocks + 1,
                                static_cast<double>(sample) * dt,
                                std::isfinite(value) ? fmt::format(", or as good as: {}", value) : ""));
  };
  for (std::size_t i = 0; i < trajectory.angles.size(); ++i) {
    require(trajectory.angles[i], "angle", i);
    require(trajectory.velocities[i], "angular velocity", i);
  }
  for (std::size_t i = 0; i < trajectory.bodies.size(); ++i) {
    const BodyState& body = trajectory.bodies[i];
    for (const double value : {body.x, body.y, body.z, body.tilt}) require(value, "place", i);
    for (const double value : {body.velocity_x, body.velocity_y}) require(value, "velocity", i);
  }
}

Trajectory run(const Engine& engine, const Setup& setup, const Parameters& parameters, bool bodies,
               bool reactions) {
  const auto simulation = engine.start(setup, parameters);
  const std::size_t blocks = setup.blocks.size();
  Trajectory trajectory;
  trajectory.angles.reserve((setup.steps + 1) * blocks);
  trajectory.velocities.reserve((setup.steps + 1) * blocks);
  std::optional<ContactWatch> contacts;
  const bool watched = (bodies || reactions) && simulation->watch_contacts();
  if (bodies && watched) contacts.emplace(setup, engine.capabilities.largest_friction);
  const auto observe = [&] {
    for (std::size_t k = 0; k < blocks; ++k) {
      const BodyState body = simulation->body(k);
      trajectory.angles.push_back(body.angle);
      trajectory.velocities.push_back(body.angular_velocity);
      if (bodies) trajectory.bodies.push_back(body);
    }
    if (!contacts) return;
    contacts->observe(simulation->contacts(), std::span(trajectory.angles).last(blocks),
                      std::span(trajectory.velocities).last(blocks));
  };
  observe();
  for (std::size_t step = 1; step <= setup.steps; ++step) {
    const std::size_t before = simulation->warnings();
    simulation->step();
    if (simulation->warnings() > before) ++trajectory.warnings;
    if (reactions && watched) {
      const auto start = std::span(trajectory.angles).last(blocks);
      const std::vector<Reaction> made = step_reactions(setup, simulation->contacts(), start);
      trajectory.reactions.insert(trajectory.reactions.end(), made.begin(), made.end());
    }
    observe();
    if (has_ended(setup, trajectory)) break;
  }
  require_finite(trajectory, blocks, setup.dt);
  if (contacts) trajectory.contacts = contacts->record();
  return trajectory;
}

std::vector<double> time_stepping(const Engine& engine, const Setup& setup, const Parameters& parameters,
                                  std::size_t steps, int repeats) {
  std::vector<double> seconds;
  for (int run = 0; run < repeats; ++run) {
    const auto simulation = engine.start(setup, parameters);
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t step = 0; step < steps; ++step) simulation->step();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return seconds;
}

}  // namespace rockstack
