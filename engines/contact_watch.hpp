#pragma once

#include <array>
#include <span>
#include <vector>

#include "engines/contact_point.hpp"
#include "engines/contact_record.hpp"
#include "engines/setup.hpp"

namespace rockstack {

/// Makes a ContactRecord while a simulation steps.
class ContactWatch {
 public:
  /// `largest_friction`: the coefficient that acts where a scene asks for more.
  ContactWatch(const Setup& setup, double largest_friction);

  /// To be called once at t = 0 and once after every step, with the contacts of that step and the state that
  /// it led to.
  void observe(const std::vector<ContactPoint>& points, std::span<const double> angles,
               std::span<const double> velocities);

  const ContactRecord& record() const { return record_; }

 private:
  /// What an end of an interface bears in one step.
  struct End {
    double impulse = 0;  ///< N·s
    double gap = 0;      ///< least one of the points that bear, where the step starts, m
    int points = 0;      ///< that bear
  };
  using Ends = std::array<End, 2>;  ///< left, right

  /// ½kd² of the points that overlap by d and are springs which steps follow. One that makes the lighter body
  /// move to and fro within a step, k dt² above its mass, is found overlapped by far more than any motion
  /// could press it, and counts as rigid.
  double elastic_energy(const std::vector<ContactPoint>& points) const;
  void add_forces(const std::vector<ContactPoint>& points);
  void add_counts(const std::vector<Ends>& ends);
  void add_impacts(const std::vector<Ends>& ends, const std::vector<double>& velocities);
  std::vector<Ends> ends_of(const std::vector<ContactPoint>& points) const;

  double dt_;
  std::vector<double> friction_;
  std::vector<double> widths_;  ///< of the faces' overlap at each interface, m
  std::vector<double> masses_;  ///< of the lighter body at each interface, kg
  ContactRecord record_;
  std::size_t samples_ = 0;
  double pushed_ = 0, excess_ = 0;  ///< impulses so far: normal, and outside the cone, N·s
  double given_ = 0, damped_ = 0;  ///< sums of normal impulse over stiffness, m·s, and times damping, N²s²/m
  double counted_ = 0, borne_ = 0;  ///< sums over ends that bear: impulse times points, and impulse, N·s
  bool rigid_ = false;              ///< whether a point that pushed was no spring
  std::vector<Ends> last_ends_;
  /// Of each interface at the last sample; the angles of the one before as well.
  std::vector<double> angles_, angles_before_, velocities_;
};

}  // namespace rockstack
