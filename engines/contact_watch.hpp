#pragma once

#include <array>
#include <span>
#include <vector>

#include "analytic/scene/scene.hpp"
#include "engines/body_record.hpp"
#include "engines/contact_point.hpp"

namespace rockstack {

/// Adds to a BodyRecord what an engine's contacts tell while a simulation steps.
class ContactWatch {
 public:
  /// `friction`: the coefficient that acts at each interface; dt in s.
  ContactWatch(const Scene& scene, double dt, std::vector<double> friction);

  /// To be called once at t = 0 and once after every step, with the contacts of that step and the state that
  /// it led to.
  void observe(const std::vector<ContactPoint>& points, std::span<const double> angles,
               std::span<const double> velocities, BodyRecord& record);

 private:
  /// What an end of an interface bears in one step.
  struct End {
    double impulse = 0;  ///< N·s
    double gap = 0;      ///< least one of the points that bear, where the step starts, m
  };
  using Ends = std::array<End, 2>;  ///< left, right

  /// ½kd² of the points that overlap by d and are springs which steps follow. One that makes the lighter body
  /// move to and fro within a step, k dt² above its mass, is found overlapped by far more than any motion
  /// could press it, and counts as rigid.
  double elastic_energy(const std::vector<ContactPoint>& points) const;
  void add_forces(const std::vector<ContactPoint>& points, BodyRecord& record);
  void add_impacts(const std::vector<Ends>& ends, const std::vector<double>& velocities,
                   BodyRecord& record) const;
  std::vector<Ends> ends_of(const std::vector<ContactPoint>& points) const;

  double dt_;
  std::vector<double> friction_;
  std::vector<double> widths_;  ///< of the faces' overlap at each interface, m
  std::vector<double> masses_;  ///< of the lighter body at each interface, kg
  std::size_t samples_ = 0;
  double pushed_ = 0, excess_ = 0;  ///< impulses so far: normal, and outside the cone, N·s
  std::vector<Ends> last_ends_;
  /// Of each interface at the last sample; the angles of the one before as well.
  std::vector<double> angles_, angles_before_, velocities_;
};

}  // namespace rockstack
