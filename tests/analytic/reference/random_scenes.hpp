#pragma once

#include <cstdint>
#include <string>

#include "tests/analytic/reference/agreement.hpp"

namespace rockstack::testing {

/// The scene of a seed: one to four random blocks that move, free, under a record or under a pulse.
Scene drawn_scene(std::uint64_t seed, Equations equations = Equations::nonlinear);

/// Random scene under law unilateral, with friction of 0.1 … 0.9 at each interface.
Scene rubbing_scene_of(std::uint64_t seed);

/// Sums over scenes that were compared with the reference.
struct Tally {
  std::size_t scenes = 0;
  std::size_t events = 0;          ///< of the reference
  std::size_t parted = 0;          ///< scenes whose events are not those of the reference
  std::size_t at_resolution = 0;   ///< of these, those that part in whether a last flight of chatter is one
  std::size_t within_instant = 0;  ///< of the others, those that part in how many impacts an instant has
  std::size_t at_decision = 0;     ///< of the others, those that part in what lasts no longer than a decision
  std::size_t sensitive_input =
      0;  ///< of the others, those that part from themselves by a rounding of the input
  std::size_t sensitive_arithmetic =
      0;  ///< of the others, those whose solution in double does by roundings of its operations
  std::size_t unexplained = 0;  ///< the others
  std::size_t stuck = 0;        ///< scenes in which the model cannot go on, in both
  Deviation worst = {};         ///< of all events that were matched
  std::size_t sensitive = 0;    ///< scenes with a deviation above 1e-10, in s or in shares
  double amplified = 0;         ///< the largest of these over what roundings of the input make

  /// Compares the scene of a seed; a line about it where its events are not those of the reference.
  std::string add(std::uint64_t seed, Equations equations = Equations::nonlinear) {
    return add(seed, drawn_scene(seed, equations));
  }
  std::string add(std::uint64_t seed, const Scene& scene);
  std::string summary() const;
};

}  // namespace rockstack::testing
