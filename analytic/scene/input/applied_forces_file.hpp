#pragma once

#include "analytic/scene/input/scene_file.hpp"

namespace rockstack {

/// Reads the tables [[push]] of a scene whose blocks are known. @throws InputError.
void read_pushes(const SceneDocument& document, MotionLibrary& library, Scene& scene);

}  // namespace rockstack
