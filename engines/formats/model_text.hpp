#pragma once

#include "engines/formats/formats.hpp"

namespace rockstack {

// What the writers of formats share.

/// Coefficient of each body's surface, the ground's first: of two that meet the lesser is the interface's,
/// unless both neighbours of an interface have more.
std::vector<double> surface_friction(const std::vector<double>& interfaces);

/// Interfaces, from 1, that have another coefficient by those of the surfaces.
std::vector<std::size_t> wrong_interfaces(const std::vector<double>& interfaces);

/// Where the middle of a block's box is in its body, whose origin is the centre of mass: "x 0 z".
std::string middle_text(const Placement& block);

/// True where the scene has a block that moves at the start.
bool starts_in_motion(const Setup& setup);

/// What no format here holds: the ground's motion, a second coefficient of friction, pushes, restraints and,
/// unless `bounces`, restitution.
std::vector<std::string> left_out_everywhere(const ModelScene& scene, bool bounces);

/// A comment at the head of a file: what the scene is, its axes, how to run it, how to come back, and what is
/// left out. `lines`: of the format.
std::string head_comment(const ModelScene& scene, const std::string& lines,
                         const std::vector<std::string>& left_out);

/// Steps of the scene.
std::string steps_text(const ModelScene& scene);

}  // namespace rockstack
