#include "engines/contact_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rockstack {
namespace {

std::vector<double> overlap_widths(const Scene& scene) {
  std::vector<double> widths;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double above = scene.blocks[k].half_width;
    widths.push_back(2 * (k == 0 ? above : std::min(above, scene.blocks[k - 1].half_width)));
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
std::vector<double> lighter_masses(const Scene& scene) {
  std::vector<double> masses;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double above = scene.blocks[k].mass;
    masses.push_back(k == 0 ? above : std::min(above, scene.blocks[k - 1].mass));
  }
  return masses;
}

}  // namespace

ContactWatch::ContactWatch(const Scene& scene, double dt, std::vector<double> friction)
    : dt_(dt),
      friction_(std::move(friction)),
      widths_(overlap_widths(scene)),
      masses_(lighter_masses(scene)),
      last_ends_(scene.blocks.size()) {}

void ContactWatch::observe(const std::vector<ContactPoint>& points, std::span<const double> angles,
                           std::span<const double> velocities, BodyRecord& record) {
  record.elastic.push_back(elastic_energy(points));
  add_forces(points, record);
  std::vector<Ends> ends = ends_of(points);
  std::vector<double> now_velocities = relative_to_below(velocities);
  if (samples_ > 0) add_impacts(ends, now_velocities, record);
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

void ContactWatch::add_forces(const std::vector<ContactPoint>& points, BodyRecord& record) {
  double across = record.complementarity.value_or(0);
  for (const ContactPoint& point : points) {
    across = std::max(across, point.gap * point.normal / dt_);
    pushed_ += point.normal;
    excess_ += std::max(0.0, point.tangential - friction_[point.interface] * point.normal);
  }
  record.complementarity = across;
  record.friction_excess = pushed_ > 0 ? excess_ / pushed_ : 0;
}

std::vector<ContactWatch::Ends> ContactWatch::ends_of(const std::vector<ContactPoint>& points) const {
  std::vector<Ends> ends(widths_.size());
  for (const ContactPoint& point : points) {
    if (point.normal <= 0) continue;
    End& end = ends[point.interface][point.along < 0 ? 0 : 1];
    end.gap = end.impulse > 0 ? std::min(end.gap, point.gap_before) : point.gap_before;
    end.impulse += point.normal;
  }
  return ends;
}

void ContactWatch::add_impacts(const std::vector<Ends>& ends, const std::vector<double>& velocities,
                               BodyRecord& record) const {
  const double start = static_cast<double>(samples_ - 1) * dt_;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    for (const int side : {-1, 1}) {
      const std::size_t end = side < 0 ? 0 : 1;
      const double speed = side * velocities_[k];
      // An engine that finds contacts by overlap answers a step late.
      const bool was_off = side * angles_before_[k] < 0;
      if (ends[k][end].impulse <= 0 || last_ends_[k][end].impulse > 0 || speed <= 0 || !was_off) continue;
      const double time = start + ends[k][end].gap / (widths_[k] * speed);
      record.impacts.push_back({time, static_cast<int>(k) + 1, speed, velocities[k]});
    }
  }
}

}  // namespace rockstack
