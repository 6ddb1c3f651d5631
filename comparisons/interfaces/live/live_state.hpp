#pragma once

#include "analytic/scene/ground/motion_library.hpp"
#include "analytic/scene/input/json.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack::live {

// What a page may ask for.
inline constexpr std::size_t most_blocks = 8;
inline constexpr double longest_duration = 120;  // s
inline constexpr double most_steps = 200'000;
inline constexpr std::size_t most_samples = 2000;  // of an answer, after the first
inline constexpr double widest_spread = 0.1;       // as Perturbations::size

/// All that a page shows: a scene, an engine with how it runs, and how far the runs of a cloud lie apart.
struct LiveState {
  Scene scene;
  EngineSeries series;  ///< one step; no engine: the exact solution alone
  double dt = 0;        ///< s, > 0
  double spread = 0;    ///< as Perturbations::size
};

/// Reads {"scene", "engine", "settings", "dt", "parameters", "spread"}; `scene` is as page_scene(), and its
/// records are among `records`. @throws InputError, one line with key, value and what is allowed, as for a
/// scene file; std::invalid_argument for a parameter of the engine.
LiveState read_state(const Json& json, const std::set<std::string>& records, MotionLibrary& library);

/// Number of steps of which an answer keeps one.
std::size_t kept_stride(const LiveState& state);

/// The state's scene file, or its suite, whose scene file is NAME.toml beside it, with `runs` perturbed
/// scenes; 0: none. @throws InputError for a name that is none.
std::string state_scene_text(const Json& json);
std::string state_suite_text(const Json& json, const LiveState& state, const std::string& name, int runs);

}  // namespace rockstack::live
