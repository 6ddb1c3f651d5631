#pragma once

#include "analytic/scene/ground/records/record.hpp"
#include "comparisons/suites/measurement.hpp"
#include "comparisons/suites/trajectory_file.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {

/// One engine with one set of parameters, at several time steps.
struct EngineSeries {
  const WorkerEngine* engine = nullptr;
  std::string settings;  ///< "default" or "tuned", and what is changed of it: "tuned+erp=0.2"
  Parameters parameters;
  std::vector<double> steps;  ///< s
  /// Runs that another program has written, in the place of those of `engine`, which is that program; else
  /// none.
  std::shared_ptr<const TrajectoryFiles> files = {};
};

/// An engine with its "default" or "tuned" parameters, some of them changed.
/// @throws std::invalid_argument for a changed parameter that the engine does not have or take.
EngineSeries make_series(const WorkerEngine& engine, const std::string& settings, std::vector<double> steps,
                         const Parameters& changes = {});

/// Changed parameters as a command line has them, "erp=0.05" or "shaking=ground".
/// @throws InputError for a text that is not of that form, an unknown parameter, with those that there are,
/// or a value out of range.
Parameters read_parameters(const std::vector<std::string>& texts, const WorkerEngine& engine);

/// The time steps of a series that names none, s.
inline constexpr std::initializer_list<double> default_steps{1e-2, 1e-3, 1e-4};

/// What the tables [[engines]] of a suite or study ask for.
struct AskedEngines {
  std::vector<EngineSeries> series;
  std::vector<std::string> left_out;  ///< names that this build leaves out
};

/// Reads them; paths of workers start from `folder`. @throws InputError with file:line, key, value and what
/// is allowed.
AskedEngines read_engines(const Node& root, const std::filesystem::path& folder);

/// Many scenes that hardly differ from a given one: where histories part by nature, only their distributions
/// can be compared.
struct Perturbations {
  int runs = 0;        ///< 0: none asked for
  double size = 1e-6;  ///< the largest relative change, > 0
  std::uint64_t seed = 1;
};

/// The runs that an engine's number is drawn from: one run is chance, since the phase between impacts and
/// time steps and the last digits of a scene each change it by factors.
struct Replicates {
  int runs = 1;  ///< with the one at the nominal step and scene; ≥ 1
  /// That they may take together: fewer runs are made where steps are many, one at least. 0: any number.
  double most_steps = 0;
  double steps = 0.03;  ///< the largest relative change of the time step, 0 to 0.5
  double scene = 1e-6;  ///< likewise of the scene, as Perturbations::size
  std::uint64_t seed = 1;
};

inline constexpr int most_replicates = 10'000;  ///< that may be asked for

/// As many however many steps they take.
inline void set_runs(Replicates& replicates, int runs) {
  replicates.runs = runs;
  replicates.most_steps = 0;
}

/// The scene of one run (from 0): each block's width and height, all initial angles and velocities together,
/// and each ground motion are multiplied by 1 + size · u, u uniform between −1 and 1. Blocks that start in
/// flight, which nothing holds, have each of their start values changed by size · u of the scene's own scale
/// as well: the slenderness angle, the block's height, and these times √(g/H). Masses stay, and so does what
/// is closed. The same on every call.
Scene perturbed(const Scene& scene, const Perturbations& perturbations, int run);

/// The scene of one replicate; that of replicate 0 is the scene itself.
Scene replicate_scene(const Scene& scene, const Replicates& replicates, int replicate);

/// The time step of one replicate, s: dt itself for replicate 0; the others are spread evenly over dt (1 ±
/// steps).
double replicate_step(double dt, const Replicates& replicates, int replicate);

/// The tables [perturbations] and [draws] of a suite or study. @throws InputError with file:line, key, value
/// and what is allowed.
Perturbations read_perturbations(const Node& table);
Replicates read_replicates(const Node& table);

/// A scene with the name and text that its results go by.
struct NamedScene {
  std::string name;  ///< of the file, without folder and ending, as folder_name()
  std::string text;  ///< the file as it was read, or as overrides leave it
  Scene scene;
  std::string duration_place = {};           ///< where its duration is given: file and line, or the override
  std::optional<Measurement> measured = {};  ///< by a test
  Node document = {};                        ///< what the scene was made of; empty where no file says it
};

/// The exact solver with one choice changed, to be compared as if it were another engine: linear against
/// nonlinear equations, one law of contact against another, friction, or Runge–Kutta steps in place of
/// series; or, in its place, what a test of the scene has measured.
struct Variant {
  enum class Choice { linear, nonlinear, paper, consistent, unilateral, friction, rk4, measured };

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
struct ResultSelection {
  bool angles = true;     ///< differences of angles, and how still a stack at rest is
  bool impacts = true;    ///< impacts and settlings side by side; impacts.csv
  bool patterns = true;   ///< shares of time; patterns.csv
  bool bodies = true;     ///< what the engine's bodies do: energy, penetration, slip, …; energy.csv
  bool histories = true;  ///< history.csv and difference.csv: every sample of every run
  bool forces = false;    ///< what interfaces bear, where engines tell it; reactions.csv and impulses.csv
};

/// The names of those that are wanted, as suite files have them.
std::vector<std::string> names_of(const ResultSelection& wanted);

/// What `compare` runs: every scene on the exact solver, on its variants and on every series.
struct Suite {
  std::string title;
  std::vector<NamedScene> scenes;
  std::vector<Variant> variants;
  std::vector<EngineSeries> series;
  std::vector<std::string> left_out;      ///< engines that it asks for and this build leaves out
  std::optional<PaperScenes> statements;  ///< where the suite is held against what the paper says
  double tolerance = 0.01;                ///< up to which histories agree, rad
  ResultSelection wanted;
  Perturbations perturbations;     ///< none unless asked for
  std::string print;               ///< of figures for print, as style_text(); empty: none
  Replicates replicates;           ///< behind each number of an engine
  int repeats = 5;                 ///< timed runs after the warm-up
  bool softness = false;           ///< whether differences are split into model, softness and step
  double history_interval = 1e-3;  ///< least time between samples that files keep, s; 0: all are kept
  Limits limits;                   ///< of each engine run
};

/// Reads a scene and keeps its text. @throws InputError as read_scene().
NamedScene read_named_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// What a file is.
enum class InputKind {
  ensemble,  ///< has a key that only ensembles have
  scene,
  suite,            ///< has a key that only suites have
  stability_study,  ///< has the key `study`, "stability"
  impact_law_study  ///< or another
};

/// @throws InputError for a file that is not TOML.
InputKind kind_of(const std::filesystem::path& file);

/// Reads a suite file; paths in it are relative to it, `overrides` go to each of its scenes. Engines that
/// this build leaves out are passed over, and named in `left_out`.
/// @throws InputError with file:line, key, value and what is allowed.
Suite read_suite(const std::filesystem::path& file, const std::vector<std::string>& overrides);

/// Engines that any of some suites asks for and this build leaves out.
std::vector<std::string> engines_left_out(const std::vector<Suite>& suites);

/// Puts a record, scaled to the same peak, in the place of the horizontal motion of every scene of a suite
/// that is shaken by samples: a record, or a synthetic motion. A scene lasts to the record's end at least.
/// @throws InputError as read_record(), or where no scene is.
void replace_motion(std::vector<Suite>& suites, const std::filesystem::path& record,
                    RecordLimits limits = RecordLimits::usual);

/// A program that is told by files of motion: the name that its rows go by, and a file a run.
struct NamedTrajectory {
  std::string name;
  std::vector<std::filesystem::path> files;
};

/// The series of a program's runs of a scene. `place`: what names it in errors.
/// @throws InputError for a name that is taken or none, and as read_trajectory().
EngineSeries trajectory_series(const NamedTrajectory& named, const NamedScene& scene,
                               const std::string& place);

/// Trajectories as a command line has them, NAME=FILE.csv; a name that comes again has one more run.
/// @throws InputError for a text of another form.
std::vector<NamedTrajectory> named_trajectories(const std::vector<std::string>& texts);

/// What a comparison of a single scene runs.
struct SceneChoice {
  std::vector<std::string> engines = {};  ///< "ode", "bullet:nncg"; none: the first solver of Bullet and ODE
  std::vector<double> steps = {};         ///< s; none: default_steps, or of a quick one the first two
  bool quick = false;                     ///< one timed run, 2000 samples of each history
  bool softness = false;                  ///< as in a suite
  std::vector<NamedTrajectory> trajectories = {};  ///< of other programs, beside the engines
  bool forces = false;                             ///< whether these are among its results
};

/// The suite for a single scene: each engine with its default and its tuned parameters.
/// @throws InputError for an engine that is not there, or as trajectory_series().
Suite suite_for(NamedScene scene, const SceneChoice& choice = {});

}  // namespace rockstack
