#pragma once

#include "analytic/scene/input/json.hpp"
#include "analytic/scene/scene.hpp"
#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// What a results folder says about the program that made it: versions of program, compiler, libraries and
/// these engines, compiler flags, processor.
std::map<std::string, std::string> environment(const std::vector<const WorkerEngine*>& engines);

/// All of a scene that a run's results may depend on, by its members; numbers as JSON has them, which is to
/// the bit.
Json scene_fields(const Scene& scene);

/// What moves the ground of a scene, in words; empty where nothing does.
std::string ground_words(const Scene& scene);

/// The scene that results hold as "page", as page_text() has it. Older ones may have its file's text alone,
/// and "title": it is read without its ground then, whose records may be gone. @throws InputError that begins
/// with `place`.
Scene recorded_scene(const Json& json, const std::string& text, const std::string& place);

}  // namespace rockstack
