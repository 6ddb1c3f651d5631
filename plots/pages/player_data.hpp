#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/input/json.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack::plots {

// What the player's script reads, for reports and the live page alike. Lists of numbers are as packed().

/// Which samples to keep, every how many-th, so that no more than `most` and the last are left.
inline std::size_t stride_for(std::size_t size, std::size_t most) {
  return std::max<std::size_t>(1, (size + most - 1) / most);
}

/// Every `stride`-th row of `width` numbers and the last, 32-bit floats, lowest byte first, in base 64.
std::string packed(const std::vector<double>& rows, std::size_t width = 1, std::size_t stride = 1);

/// How a track appears.
struct TrackLook {
  std::string label;
  std::string colour;  ///< #rrggbb
  std::string dash;    ///< gnuplot's dash type
  bool shown = true;   ///< at first
  bool exact = false;
};

/// For as many keys as any object of a page has: one that grows copies all that it holds.
void make_room(Json& object);

/// Times, angles, and slips and places where the history has them, of every `stride`-th sample.
Json player_track(const History& history, std::size_t stride);

/// Track under a name.
Json player_track(const History& history, std::size_t stride, const TrackLook& look);

/// An exact motion with its events, whose times lie between samples, among its samples.
History with_events(const History& history);

/// Adds what the interfaces of so many blocks carry at some times, s, to a track: a row a time of normal and
/// tangential forces in N and where they act in m, one of each an interface.
void add_forces(const std::vector<double>& times, const std::vector<double>& rows, int blocks,
                std::size_t stride, Json& track);

/// What the player needs of a scene besides its tracks and the ground. Its "events" are the pattern band and
/// the events of a motion of it where that is exact, "spans" and "stops".
Json player_scene(const Scene& scene, const History& history);

/// Adds the acceleration of the ground at some times, s: to the right and upwards, m/s².
void add_ground(const std::vector<double>& times, const std::vector<double>& right,
                const std::vector<double>& up, Json& stage);

/// Text that ends no element, whatever it holds.
std::string for_script(const Json& data);

// Data of a motion that has just been computed.

/// The scene with its ground at the times of a motion, whose patterns and events it has where that is exact.
/// "blows" are impacts of blocks on pivots but chatter: [time, interface, velocities of centres before,
/// after, impulses of interfaces, sides].
Json stage_of(const Scene& scene, const History& history);

/// Adds what interfaces carry at the samples of an exact motion to its track.
void add_forces(const Scene& scene, const History& history, std::size_t stride, Json& track);

}  // namespace rockstack::plots
