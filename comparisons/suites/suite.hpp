#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/scene.hpp"
#include "comparisons/suites/engine_series.hpp"
#include "comparisons/suites/perturbations.hpp"

namespace rockstack {

/// A scene with the name and text that its results go by.
struct NamedScene {
  std::string name;  ///< of the file, without folder and ending, as folder_name()
  std::string text;  ///< the file as it was read
  Scene scene;
  std::string duration_place = {};  ///< where its duration is given: file and line, or the override
};

/// The exact solver with one choice changed, to be compared as if it were another engine: linear against
/// nonlinear equations, one law of contact against another, friction, or Runge–Kutta steps in place of
/// series.
struct Variant {
  enum class Choice { linear, nonlinear, paper, consistent, unilateral, friction, rk4 };

  Choice choice;
  double step = 0;      ///< of rk4, s
  double friction = 0;  ///< of friction: law `unilateral` with this coefficient at every interface

  bool operator==(const Variant&) const = default;

  /// "linear", "friction=0.5", …
  std::string name() const;

  /// The scene with that choice made.
  Scene apply(Scene scene) const;
};

/// The names of the scenes that stand for the paper's two numerical examples.
struct PaperScenes {
  std::string free;    ///< Figs. 18 to 20
  std::string shaken;  ///< Figs. 21 and 22
};

/// Which results a suite asks for of each run; what is not asked for is not computed.
struct Wanted {
  bool angles = true;     ///< differences of angles, and how still a stack at rest is
  bool impacts = true;    ///< impacts and settlings side by side; impacts.csv
  bool patterns = true;   ///< shares of time; patterns.csv
  bool bodies = true;     ///< what the engine's bodies do: energy, penetration, slip, …; energy.csv
  bool histories = true;  ///< history.csv and difference.csv: every sample of every run
};

/// The names of those that are wanted, as suite files have them.
std::vector<std::string> names_of(const Wanted& wanted);

/// What `compare` runs: every scene on the exact solver, on its variants and on every series.
struct Suite {
  std::string title;
  std::vector<NamedScene> scenes;
  std::vector<Variant> variants;
  std::vector<EngineSeries> series;
  std::optional<PaperScenes> statements;  ///< where the suite is held against what the paper says
  double tolerance = 0.01;                ///< up to which histories agree, rad
  Wanted wanted;
  Perturbations perturbations;     ///< none unless asked for
  Draws draws;                     ///< behind each number of an engine
  int repeats = 5;                 ///< timed runs after the warm-up
  bool softness = false;           ///< whether differences are split into model, softness and step
  double history_interval = 1e-3;  ///< least time between samples that files keep, s; 0: all are kept
  Limits limits;                   ///< of each engine run
};

/// The scene of that name. Precondition: it is there.
const NamedScene& find_scene(const std::vector<NamedScene>& scenes, const std::string& name);

/// Reads a scene and keeps its text. @throws InputError as read_scene().
NamedScene read_named_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// What a file is that `compare` takes.
enum class InputKind {
  scene,
  suite,            ///< has a key that only suites have
  stability_study,  ///< has the key `study`, "stability"
  impact_law_study  ///< or another
};

/// @throws InputError for a file that is not TOML.
InputKind kind_of(const std::filesystem::path& file);

/// Reads a suite file; paths in it are relative to it, `overrides` go to each of its scenes. Engines that
/// this build leaves out are passed over (engines_left_out() names them).
/// @throws InputError with file:line, key, value and what is allowed.
Suite read_suite(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// Puts a record, scaled to the same peak, in the place of the horizontal motion of every scene of a suite
/// that is shaken by samples: a record, or a synthetic motion. @throws InputError as read_record(), or where
/// no scene is.
void replace_motion(std::vector<Suite>& suites, const std::filesystem::path& record);

/// What a comparison of a single scene runs.
struct SceneChoice {
  std::vector<std::string> engines = {};  ///< "ode", "bullet:nncg"; none: the first solver of Bullet and ODE
  std::vector<double> steps = {};         ///< s; none: default_steps(), or of a quick one the first two
  bool quick = false;                     ///< fewer draws, one timed run, 2000 samples of each history
  bool softness = false;                  ///< as in a suite
};

/// The suite for a single scene: each engine with its default and its tuned parameters.
/// @throws InputError for an engine that is not there.
Suite suite_for(NamedScene scene, const SceneChoice& choice = {});

}  // namespace rockstack
