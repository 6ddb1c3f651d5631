#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analytic/scene/history.hpp"
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
  std::vector<double> peaks;  ///< largest |θ| of each block at any time, rad; empty unless asked for
  /// What acts at each interface, of the motion and of impacts; empty unless asked for. A least normal force
  /// of zero is that of blocks that part; nothing pulls, and nothing rubs more than its friction, so that
  /// first times are infinite. Of impulses that of chatter, less than a millionth of a fall's, is not told.
  std::vector<Demand> forces, impulses;
  Bodies last;        ///< at the end
  double end_time{};  ///< s
};

/// A motion that could not be followed to its end: why, and what is known of it.
class UnfinishedContacts : public std::runtime_error {
 public:
  UnfinishedContacts(const std::string& reason, ContactHistory known)
      : std::runtime_error(reason), history(std::move(known)) {}
  ContactHistory history;  ///< up to there
};

/// What the scene does not say.
struct ContactOptions {
  std::vector<double> sample_times = {};  ///< s, ascending from ≥ 0; none: events alone
  double resolution = 0;                  ///< chatter ends below it, rad, ≥ 0; 0: the rounding of 1
  bool validity = false;                  ///< whether to keep what acts at each interface
  bool peaks = false;                     ///< whether to keep the largest angle of each block
};

/// The exact motion of rigid blocks that push, rub by Coulomb's law, lift off, fly and land without bounce.
/// The law and the equations of the scene are not asked for: they are unilateral and nonlinear.
/// @throws FieldError for a scene out of range; std::invalid_argument for options out of range;
/// UnfinishedContacts where events do not come to an end.
ContactHistory solve_unilateral(const Scene& scene, const ContactOptions& options = {});

/// Kinetic energy and that of weight, J, in the frame of the ground, from the middle of its interface.
double energy(const Scene& scene, const Bodies& bodies);

}  // namespace rockstack
