#include "engines/contact_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rockstack {
namespace {

std::vector<double> overlap_widths(const std::vector<Placement>& blocks) {
  std::vector<double> widths;
  widths.reserve(blocks.size());
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const double above = blocks[k].width;
    widths.push_back(k == 0 ? above : std::min(above, blocks[k - 1].width));
  }
  return widths;
}

/// Of each interface: what its block has less what the block below has.
std::vector<double> relative_to_below(std::span<const double> values) {
  std::vector<double> list(values.begin(), values.end());
  for (std::size_t k = 1; k < values.size(); ++k) list[k] -= values[k - 1];
  return list;
}

/// Of each interface: the lighter of the two bodies that meet there, kg.
std::vector<double> lighter_masses(const std::vector<Placement>& blocks) {
  std::vector<double> masses;
  masses.reserve(blocks.size());
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const double above = blocks[k].mass;
    masses.push_back(k == 0 ? above : std::min(above, blocks[k - 1].mass));
  }
  return masses;
}

}  // namespace

ContactWatch::ContactWatch(const Setup& setup, double largest_friction)
    : dt_(setup.dt),
      friction_(setup.friction),
      widths_(overlap_widths(setup.blocks)),
      masses_(lighter_masses(setup.blocks)),
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
    rigid_ |= std::isinf(point.stiffness);
    given_ += point.normal / point.stiffness;
    damped_ += point.normal * point.damping;
  }
  record_.friction_excess = pushed_ > 0 ? excess_ / pushed_ : 0;
  if (rigid_ || given_ == 0) {
    record_.stiffness = std::numeric_limits<double>::infinity(), record_.damping = 0;
  } else {
    record_.stiffness = pushed_ / given_, record_.damping = damped_ / pushed_;
  }
}

void ContactWatch::add_counts(const std::vector<Ends>& ends) {
  for (const Ends& both : ends) {
    for (const End& end : both) {
      counted_ += end.impulse * end.points;
      borne_ += end.impulse;
    }
  }
  record_.points = borne_ > 0 ? counted_ / borne_ : 1;
}

std::vector<ContactWatch::Ends> ContactWatch::ends_of(const std::vector<ContactPoint>& points) const {
  std::vector<Ends> ends(widths_.size());
  for (const ContactPoint& point : points) {
    if (point.normal <= 0) continue;
    End& end = ends[point.interface][point.along < 0 ? 0 : 1];
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

}  // namespace rockstack
