#pragma once

#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// The largest angle of each block, rad; of samples where the history does not keep it.
std::vector<double> peak_angles(const History& history);

/// How blocks end on what they stand on, as an engine's bodies tell.
struct Support {
  double sinking = 0;       ///< how deep one has sunk in, m
  std::string fallen = {};  ///< fallen_block()
};

/// From the depth of the deepest overlap at each sample, m, of which the least over the last tenth is how far
/// a block has sunk in, whatever impacts pressed it in for a moment; and from since when each block has had
/// nothing below it, s.
Support support_of(const std::vector<double>& penetration, const std::vector<double>& unsupported_since);

/// A motion in one line: whether it stands, rests or topples, which block comes nearest to its slenderness
/// angle, and, of a history that was solved with SolveOptions::validity, the friction that it needs; from
/// when on it is one of several motions that obey the laws of contact. Motion within a thousandth of the
/// slenderness angles and without events counts as rest. Blocks that have sunk in or fallen off are told.
/// Precondition: samples.
std::string motion_verdict(const Scene& scene, const History& history, const Support& support = {});

}  // namespace rockstack
