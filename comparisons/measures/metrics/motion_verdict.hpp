#pragma once

#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// The largest angle of each block, rad; of samples where the history does not keep it.
std::vector<double> peak_angles(const History& history);

/// A motion in one line: whether it stands, rests or topples, which block comes nearest to its slenderness
/// angle, and, of a history that was solved with SolveOptions::validity, the friction that it needs; from
/// when on it is one of several motions that obey the laws of contact. Motion within a thousandth of the
/// slenderness angles and without events counts as rest. Precondition: samples.
std::string motion_verdict(const Scene& scene, const History& history);

}  // namespace rockstack
