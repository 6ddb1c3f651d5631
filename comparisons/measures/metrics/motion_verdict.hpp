#pragma once

#include "comparisons/measures/metrics/leans.hpp"
#include "comparisons/measures/metrics/toppling.hpp"

namespace rockstack {

/// The angle of a block (from 0) at any time, by the straight line between samples, rad; past the end, that
/// line goes on. Precondition: at least two samples.
double angle_at(const History& history, std::size_t block, double time);

/// How blocks end on what they stand on, as an engine's bodies tell.
struct SupportLoss {
  double sinking = 0;       ///< how deep one has sunk in, m
  std::string fallen = {};  ///< "block 2 at 1.5 s" of the first that fell off what it stood on, or nothing
};

/// From the depth of the deepest overlap at each sample, m, of which the least over the last tenth is how far
/// a block has sunk in, whatever impacts pressed it in for a moment; and from since when each block has had
/// nothing below it, s (infinite where it has).
SupportLoss support_of(const std::vector<double>& penetration, const std::vector<double>& unsupported_since);

/// Why a motion need not be the one that follows, after "it is": other motions obey as well, an impulse stops
/// it, or, of a history that was solved with SolveOptions::validity under laws of pivots, blocks would part
/// or slip where these hold them. Empty where none is so.
std::string doubt_of(const Scene& scene, const History& history);

/// A motion in one line: what doubt_of() tells; whether it stands, rests, topples, or what goes on at its
/// end, and whether its ground moves on then; how near it comes to balance; and, of a history that was solved
/// with SolveOptions::validity, the friction that it needs. Motion within a thousandth of the slenderness
/// angles and without events counts as rest. Blocks that have sunk in or fallen off are told. Precondition:
/// samples.
std::string motion_verdict(const Scene& scene, const History& history, const SupportLoss& support = {});

}  // namespace rockstack
