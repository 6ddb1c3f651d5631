#pragma once

#include "analytic/scene/input/json.hpp"
#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// What a results folder says about the program that made it: versions of program, compiler, libraries and
/// these engines, compiler flags, processor.
std::map<std::string, std::string> environment(const std::vector<const WorkerEngine*>& engines);

/// What results say of a scene as it was run, overrides included: title, blocks, gravity, duration, what
/// moves the ground, the law, and the speed and time below which impacts are chatter. SI units.
Json scene_json(const Scene& scene);

/// What figures and pages need of that. SI units.
struct RecordedScene {
  std::string title;
  std::vector<Block> stack;      ///< bottom to top
  double gravity = 0;            ///< m/s²
  double duration = 0;           ///< s
  std::string ground;            ///< what moves it; empty where nothing does
  double chatter_speed = 0;      ///< relative speed under which impacts are chatter, rad/s
  std::string law;               ///< of the exact motion
  std::vector<double> friction;  ///< of each interface

  int blocks() const { return static_cast<int>(stack.size()); }
};

/// The scene that scene_json() has told. @throws std::invalid_argument where it is none, or JSON's own
/// exception.
RecordedScene recorded_scene(const Json& json);

}  // namespace rockstack
