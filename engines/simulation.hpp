#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engines/applied_loads.hpp"

namespace rockstack {

/// A point at which an engine lets two bodies touch, as it was used in the last step. SI units.
struct ContactPoint {
  std::size_t interface = 0;  ///< of the upper of both bodies, from 0, bottom to top
  double along =
      0;  ///< place along the upper body's lower face, from below its centre of mass to the right, m
  double gap_before = 0;  ///< where the step starts and the engine finds the point, m; negative: overlap
  double gap = 0;         ///< where the step ends: the bodies' points moved on, along the same normal, m
  double normal = 0;      ///< impulse of the step that pushes the bodies apart, N·s
  double tangential = 0;  ///< magnitude of the impulse across that, N·s
  double impulse_x = 0, impulse_y = 0;  ///< both on the upper body, to the right and up, N·s
  double stiffness = std::numeric_limits<double>::infinity();  ///< N/m where it is a spring, else infinite
  double damping = 0;  ///< N s/m where a dashpot is beside the spring; without meaning where there is none
};

/// Stiffness of a contact that takes away the share `erp` of its overlap in `dt` s and gives way by `cfm`
/// m/s for 1 N: a spring and a dashpot by implicit Euler (ODE's manual, 3.8.2). N/m; infinite for cfm = 0.
inline double contact_stiffness(double erp, double cfm, double dt) {
  return cfm > 0 ? erp / (dt * cfm) : std::numeric_limits<double>::infinity();
}

/// The damping of the dashpot beside that spring, N s/m; infinite for cfm = 0.
inline double contact_damping(double erp, double cfm) {
  return cfm > 0 ? (1 - erp) / cfm : std::numeric_limits<double>::infinity();
}

/// A scene inside an engine, ready to step. Blocks count from 0, bottom to top.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Advances by one time step; ground motion enters as its mean over the step.
  virtual void step() = 0;

  virtual BodyState body(std::size_t block) const = 0;

  /// Lets contacts() tell what steps from now on make of contacts, at some cost. @return whether it can.
  virtual bool watch_contacts() { return false; }

  /// The contacts of the last step; none before the first, or where they are not watched.
  virtual std::vector<ContactPoint> contacts() const { return {}; }

  /// How often the engine has said that its solver failed in a step that it then went on from.
  virtual std::size_t warnings() const { return 0; }
};

/// What adapters share: each step is told how the ground moves. Ground motion in a setup is either that of a
/// ground that really moves or a body force; once the scene is over nothing changes any more.
class ShakenSimulation : public Simulation {
 public:
  void step() final {
    const std::size_t now = steps_++;
    if (now < setup_.ground.size()) place_ground(setup_.ground[now]);
    if (now < setup_.accelerations.size()) set_gravity(setup_.accelerations[now]);
    if (loads_.any()) apply_loads(now);
    advance();
  }
  bool watch_contacts() override { return watched_ = true; }

 protected:
  /// `mass_factor`: by what the adapter multiplies every mass; no angle depends on it.
  explicit ShakenSimulation(const Setup& setup, double mass_factor = 1)
      : mass_factor_(mass_factor), setup_(setup), loads_(setup) {}

  double dt() const { return setup_.dt; }
  bool watches_contacts() const { return watched_; }
  /// True where the ground really moves.
  bool moves_ground() const { return !setup_.ground.empty(); }
  /// The ground in the next step; null where it rests or the scene is over.
  const GroundStep* next_ground() const {
    return steps_ < setup_.ground.size() ? &setup_.ground[steps_] : nullptr;
  }
  std::size_t steps() const { return steps_; }

  const double mass_factor_;

 private:
  /// Puts a ground that really moves where the step under way starts, where most engines find contacts.
  virtual void place_ground(const GroundStep& /*ground*/) {}
  virtual void set_gravity(const BodyAcceleration& acceleration) = 0;
  /// Has a load, in the adapter's own masses, act over the step under way; engines that have pushes and
  /// restraints get one for every block in each step.
  virtual void apply_load(std::size_t /*block*/, const BodyLoad& /*load*/) {
    throw std::logic_error("no forces can be applied to blocks");
  }
  virtual void advance() = 0;

  void apply_loads(std::size_t step) {
    std::vector<BodyState> blocks;
    blocks.reserve(setup_.blocks.size());
    for (std::size_t k = 0; k < setup_.blocks.size(); ++k) blocks.push_back(body(k));
    const GroundStep ground =
        setup_.ground.empty() ? GroundStep{} : setup_.ground[std::min(step, setup_.ground.size() - 1)];
    const std::vector<BodyLoad> loads = loads_.over_step(step, blocks, ground);
    for (std::size_t k = 0; k < loads.size(); ++k)
      apply_load(k, {mass_factor_ * loads[k].x, mass_factor_ * loads[k].y, mass_factor_ * loads[k].moment});
  }

  Setup setup_;
  AppliedLoads loads_;
  std::size_t steps_ = 0;
  bool watched_ = false;
};

/// The angle that differs from `wrapped` by whole turns and lies next to `last`, rad.
inline double unwrap(double wrapped, double last) {
  return last + std::remainder(wrapped - last, 2 * std::acos(-1.0));
}

}  // namespace rockstack
