#pragma once

#include <functional>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Reads the tables [[push]] of a scene whose blocks are known; `read_motion` what tells a force over time as
/// it tells the ground's acceleration. @throws InputError.
void read_pushes(const Node& root, const std::function<GroundMotion(const Node&)>& read_motion, Scene& scene);

/// Reads the tables [[restraint]]. @throws InputError.
void read_restraints(const Node& root, Scene& scene);

/// Checks pushes of a scene whose blocks are valid. @throws FieldError with the keys of a file.
void validate_pushes(const Scene& scene);

/// Checks restraints likewise. @throws FieldError.
void validate_restraints(const Scene& scene);

}  // namespace rockstack
