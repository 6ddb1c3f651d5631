#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analytic/unilateral/bodies.hpp"

namespace rockstack {

/// What changes the contacts of a stack that may slip and lift off.
enum class ContactEventKind : std::uint8_t {
  opening,   ///< a flat contact starts to rock, without impact
  lift_off,  ///< a contact parts, without impact
  slip,      ///< what stuck starts to slide
  stick,     ///< what slid sticks, or slides back
  corner,    ///< a corner passes the end of a face: the contact goes on at another corner, or parts
  impact,    ///< blocks meet
  closure,   ///< the last of ever smaller impacts
  rest,      ///< a closure after which nothing moves
  topple,    ///< a block passes its toppling angle; the motion ends
  fall,      ///< a block leaves the face that it was over; the motion ends
};

std::string name(ContactEventKind kind);

/// What theory has to say on an event: one solution; several, of which the one named by find_mode() follows;
/// or none without an impulse, of which the limit of Moreau's time steps follows.
enum class Solutions : std::uint8_t { one, several, none };

/// One event with the motion on both sides of it. `interface` counts from 1; of topple it is the block.
struct ContactEvent {
  double time = 0;  ///< s
  ContactEventKind kind{};
  int interface = 0;
  std::vector<Joint> from, to;
  std::vector<BodyPlacement> at, before, after;  ///< placements, and their rates
  Solutions solutions = Solutions::one;
};

/// A stack's motion under law `unilateral`.
struct ContactHistory {
  struct Sample {
    double time;  ///< s
    Bodies bodies;
    std::vector<Joint> joints;
    std::vector<double> slips, gaps;  ///< of each interface, m; where apart, the slip that it parted with
  };
  std::vector<Sample> samples;
  std::vector<ContactEvent> events;
  Bodies last;        ///< at the end
  double end_time{};  ///< s
};

/// What the scene does not say. Empty lists: no slip to start with; nothing sampled.
struct ContactOptions {
  std::vector<double> friction = {};  ///< Coulomb's coefficient of each interface, ≥ 0, from the ground up
  std::vector<double> slip_rates =
      {};  ///< at the start, m/s, to the right positive, of interfaces that touch
  std::vector<double> sample_times = {};  ///< s, ascending from ≥ 0
  double resolution = 0;                  ///< chatter ends below it, rad, ≥ 0; 0: the rounding of 1
};

/// The exact motion of rigid blocks that push, rub by Coulomb's law, lift off, fly and land without bounce.
/// The law and the equations of the scene are not asked for: they are unilateral and nonlinear.
/// @throws FieldError for a scene out of range; std::invalid_argument for options out of range;
/// std::runtime_error where events do not come to an end.
ContactHistory solve_unilateral(const Scene& scene, const ContactOptions& options);

/// Kinetic energy and that of weight, J, in the frame of the ground.
double energy(const Scene& scene, const Bodies& bodies);

}  // namespace rockstack
