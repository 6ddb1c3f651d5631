#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tests/analytic/unilateral/solve_unilateral.hpp"

namespace rockstack::testing {

/// The random stack of a seed: two or three blocks of equal width, with friction of 0.1 … 1, that stand on
/// moving ground, lean, rock, or lean on moving ground.
Scene equal_widths(std::uint64_t seed);

/// The scene with each block wider than the one below by a share where the bit of its interface is set, and
/// else narrower. Masses stay.
Scene widened(Scene scene, unsigned wider, double share);

/// Compares stacks of equal width with those of which each block is wider, or narrower, than the one below by
/// a share ε, in all ways, at 200 times.
///
/// Motions part where a place or an angle differs by more than 30 √ε (m or rad): before a pair of corners
/// that slides off a face is on the other one it goes εb with that face's friction, for a time that goes with
/// √ε. What limits agree on is the answer; and where they part, an event has told that there are several
/// motions.
struct LimitTally {
  std::size_t agree = 0, part = 0;  ///< scenes

  /// @returns a line where that is not so, or nothing.
  std::string add(std::uint64_t seed, double share);
};

/// What makes time steps end elsewhere than the exact motion.
enum class Reason { agree, coarse, several, unexplained };
constexpr std::size_t reasons = 4;
const char* name(Reason reason);

/// Compares ends of motions with those of time_stepped(), which judges pairs of corners by the same rule, but
/// by impulses of one contact after another. They agree within 5 m or rad times a step in s. Else steps of a
/// 4th, 16th or 64th do, which tell apart what comes within microseconds; or an event told that there are
/// several motions, and steps follow another one, that of a width that differs by 10⁻⁹: they leave out some
/// micrometres of places, too many for corners to meet.
struct StepTally {
  std::array<std::size_t, reasons> scenes{};

  /// @returns a line where they end elsewhere for no known reason, or nothing.
  std::string add(std::uint64_t seed, double step);
  std::string summary() const;
};

}  // namespace rockstack::testing
