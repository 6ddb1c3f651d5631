#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {

/// What a stack does: the response modes of a rigid block on shaken ground, H. W. Shenton 1996, "Criteria for
/// initiation of slide, rock, and slide-rock rigid-body modes", Journal of Engineering Mechanics 122,
/// 690–693; and the two ends.
enum class MotionMode {
  rest,         ///< every interface closed and without slip
  slide,        ///< some interface slips, none opens
  rock,         ///< some interface opens, none slips
  slide_rock,   ///< both
  free_flight,  ///< at some interface blocks are apart
  topple,       ///< a block passes its toppling angle
  fall,         ///< a block leaves what it was over
};

inline constexpr std::array motion_modes{MotionMode::rest,       MotionMode::slide,       MotionMode::rock,
                                         MotionMode::slide_rock, MotionMode::free_flight, MotionMode::topple,
                                         MotionMode::fall};

/// "rest", "slide", "rock", "slide-rock", "free flight", "topple" or "fall".
std::string name(MotionMode mode);

/// The first mode that is not rest, up to free flight.
MotionMode onset_mode(const Scene& scene, const History& history);

/// All of a motion in one word: how it ends where a block topples or falls; else what it ever comes to, free
/// flight before all others, and slide-rock where it slips at one time and rocks at another.
MotionMode whole_mode(const Scene& scene, const History& history);

/// What a motion comes to in numbers; outcome_columns.txt says what each is. SI units. Of each block, or of
/// the interface under it, in lists, which are empty where nothing tells them.
struct RunOutcome {
  std::vector<double> peaks;          ///< largest absolute angle, rad
  std::vector<double> peak_ratios;    ///< of that over the block's slenderness
  std::vector<double> frictions;      ///< largest coefficient needed between impacts
  std::vector<double> slips;          ///< left at the end, to the right, m
  std::vector<double> lifts;          ///< highest, m
  std::vector<double> uplifts;        ///< largest, m
  std::vector<double> largest_slips;  ///< to either side at any time, m
  double peak_ratio = 0;              ///< the largest of these
  int toppled = 0;                    ///< number of the block that toppled or fell off first, from 1; 0: none
  std::optional<double> topple_time;  ///< s, where one has
  int falling = 0;                    ///< falling_block() at the end, from 1; 0: none
  double ground_left = 0;             ///< ground_left() where none has toppled, s
  std::size_t impacts = 0;            ///< with those that end chatter
  std::size_t events = 0;             ///< of any kind
  std::optional<double> last_event_time;                           ///< s, where there is an event
  std::optional<double> rest_time;                                 ///< s, where it ends at rest
  MotionMode onset = MotionMode::rest, motion = MotionMode::rest;  ///< how it begins; all of it
  Demand force;    ///< on whichever interface bears the most, by forces
  Demand impulse;  ///< likewise, by impulses
  /// Under law unilateral: the largest slip that is left at the end, and the highest lift, of any interface,
  /// m.
  std::optional<double> slip, lift;
  double uplift = 0;                   ///< the largest of uplifts, m
  std::optional<double> largest_slip;  ///< the largest of those, under law unilateral, m
};

/// How the runs of a sweep are solved: exactly, or to a tolerance that also ends chatter.
SolveOptions run_options(double tolerance = 0);

/// Sums up a history; of one without events, as an engine's, only `sampled` columns (outcome_columns.hpp)
/// have a meaning.
RunOutcome run_outcome(const Scene& scene, const History& history);

}  // namespace rockstack
