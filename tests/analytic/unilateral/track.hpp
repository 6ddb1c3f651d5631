#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

constexpr double never = std::numeric_limits<double>::infinity();

/// Why a motion under law `unilateral` leaves that under law `consistent`, as the latter reports of itself.
enum class Parting : std::uint8_t {
  none,             ///< it does not
  friction,         ///< an interface needs more friction than it has
  impact_friction,  ///< an impact does
  pull,             ///< an interface has to pull
  no_pattern,       ///< no pattern is consistent after an impact
  jump,             ///< a jump of the ground would, in a pattern that lasts no time as an interface opens
  chatter,          ///< chatter ends at the resolution for one of them and goes on for the other
  rounding,         ///< the motion also leaves itself when its scene's numbers change by some roundings
  unfinished,       ///< the motion under law `consistent` has no end
  unexplained,      ///< none of these
};
constexpr std::size_t partings = 10;
const char* name(Parting parting);

/// What is compared of an event, of a sample, or of the end of a motion that both laws share.
struct Moment {
  std::string kind;
  int interface = 0;
  std::string pattern;
  double time = 0;
  std::vector<double> angles, rates;
  double speed = never;  ///< at which the slowest of the interfaces that change closes, rad/s
};

/// A motion up to where it is no longer that of the other law.
struct Track {
  std::vector<Moment> events, samples;
  double end = never;  ///< s
  Parting reason = Parting::none;
  bool opens = false;  ///< at its end an interface opens, so that what is told of it lasts no time
};

/// The motion under law `consistent` with what it reports; nothing where it has no end.
std::optional<Track> consistent_track(Scene scene, const std::vector<double>& times);

/// The motion under law `unilateral`, as far as it can be followed.
Track joint_track(const Scene& scene, const std::vector<double>& times);

/// The time by which deviations are measured, √(H/g), s.
double unit_time(const Scene& scene);

bool same(const Moment& one, const Moment& other);

/// How far two motions are from each other, moment by moment, up to where one parts from the other.
struct Deviations {
  std::vector<double> events, samples;
};
Deviations compare(const Scene& scene, const Track& one, const Track& other);

}  // namespace rockstack::testing
