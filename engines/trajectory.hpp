#pragma once

#include <array>
#include <optional>
#include <span>
#include <stdexcept>

#include "analytic/scene/history.hpp"
#include "engines/engine.hpp"

namespace rockstack {

/// An impact that contacts tell: an end of an interface that was off and bore nothing bears as it closes.
struct ContactImpact {
  double time = 0;    ///< at which both faces touch there, by gap and approach, within the run so far, s
  int interface = 0;  ///< from 1
  double speed = 0;   ///< relative angular speed of closing where the step starts, rad/s
  double after = 0;   ///< relative angular velocity where it ends, rad/s
};

/// What an engine's contacts tell over one run. SI units.
struct ContactRecord {
  /// ½kd² of all contacts that are springs which steps follow and overlap by d, at each sample, J.
  std::vector<double> elastic;
  /// Largest product of gap and force of a contact that pushes across a gap, J; an impulse acts all the step.
  double complementarity = 0;
  /// Impulse across the contacts' normals above what Coulomb's cone allows, over the whole run, as a share of
  /// all that they push; whatever law of friction the engine has.
  double friction_excess = 0;
  /// Stiffness of the spring that a contact point is, N/m: by it all impulses together overlap as much as by
  /// the points' own, the harmonic mean by impulse. Infinite where some are rigid.
  double stiffness = std::numeric_limits<double>::infinity();
  double damping = 0;                  ///< of the dashpot beside it, N s/m: the mean by impulse
  std::vector<ContactImpact> impacts;  ///< in order of steps
  double points = 1;                   ///< that push together at one end of an interface: the mean by impulse
};

/// Makes a ContactRecord while a simulation steps.
class ContactWatch {
 public:
  /// `largest_friction`: the coefficient that acts where a scene asks for more.
  ContactWatch(const Setup& setup, double largest_friction);

  /// To be called at t = 0 and after every step, with the contacts of that step and the state it led to.
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

  /// ½kd² of the points that overlap by d and are springs which steps follow. One with k dt² above the
  /// lighter body's mass is found overlapped by far more than any motion could press it, and counts as rigid.
  double elastic_energy(const std::vector<ContactPoint>& points) const;
  void add_forces(const std::vector<ContactPoint>& points);
  void add_counts(const std::vector<Ends>& ends);
  void add_impacts(const std::vector<Ends>& ends, const std::vector<double>& velocities);
  std::vector<Ends> ends_of(const std::vector<ContactPoint>& points) const;

  double dt_;
  std::vector<double> friction_;
  std::vector<double> widths_;   ///< of the faces' overlap at each interface, m
  std::vector<double> offsets_;  ///< of each block's centre of mass from its middle, to the right, m
  std::vector<double> masses_;   ///< of the lighter body at each interface, kg
  ContactRecord record_;
  std::size_t samples_ = 0;
  double pushed_ = 0, excess_ = 0;  ///< impulses so far: normal, and outside the cone, N·s
  double given_ = 0, damped_ = 0;  ///< sums of normal impulse over stiffness, m·s, and times damping, N²s²/m
  double counted_ = 0, borne_ = 0;  ///< sums over ends that bear: impulse times points, and impulse, N·s
  bool rigid_ = false;              ///< whether a point that pushed was no spring
  std::vector<Ends> last_ends_;
  /// Values of interfaces at the last sample; the angles of the one before as well.
  std::vector<double> angles_, angles_before_, velocities_;
};

/// What each interface bears in one step: the mean of its contact points' forces over it, on the upper body.
/// Its axes are those of the face that corners stand on where the step starts, with blocks at `angles`, rad:
/// of the block below, or of the one above where that is wider. Nothing bears: the centre is no number.
std::vector<Reaction> step_reactions(const Setup& setup, const std::vector<ContactPoint>& points,
                                     std::span<const double> angles);

/// What an engine made of a scene, at t = 0 and after every step; it ends early where a block has toppled.
/// All lists go sample by sample, and in each from the lowest block up.
struct Trajectory {
  std::vector<double> angles;      ///< rad, clockwise positive
  std::vector<double> velocities;  ///< rad/s
  std::vector<BodyState> bodies;   ///< where asked for
  /// What its contacts tell, where asked for and where the engine tells them.
  std::optional<ContactRecord> contacts;
  std::size_t warnings = 0;        ///< steps in which the solver failed and went on
  std::vector<double> times = {};  ///< of samples that come unevenly, s; empty: one after every step
  /// What interfaces bear in each step, a row a step; where asked for and where the engine tells contacts.
  std::vector<Reaction> reactions = {};
};

/// A number of a block's motion stopped being finite, or is beyond all that a scene has (largest_number).
class NotFinite : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a scene to its end in this process; `bodies`: keeps these and the contacts; `reactions`: keeps these.
/// @throws NotFinite with the time at which that happened, or the engine's own error.
Trajectory run(const Engine& engine, const Setup& setup, const Parameters& parameters, bool bodies = false,
               bool reactions = false);

/// True where a block has toppled in the last sample, or an angle there is no number any more.
bool has_ended(const Setup& setup, const Trajectory& trajectory);

/// @throws NotFinite as above, for a trajectory of that many blocks.
void require_finite(const Trajectory& trajectory, std::size_t blocks, double dt);

/// Wall times of that many steps alone, without building or reading, in s: one each of `repeats` runs ≥ 0.
/// Precondition: the scene has been run before, as a warm-up and to know after how many steps it ends.
std::vector<double> time_stepping(const Engine& engine, const Setup& setup, const Parameters& parameters,
                                  std::size_t steps, int repeats);

}  // namespace rockstack
