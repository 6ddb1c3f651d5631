#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "plots/data/facts.hpp"

namespace rockstack::plots {

/// One row of a comparison. SI units; NaN where the file has no value.
struct Run {
  std::string name, scene, engine, solver, settings, status, reason;
  double dt = 0;                            ///< s
  double steps = 0;                         ///< number of steps made
  double stepping_time = 0;                 ///< smallest wall time of all steps together, s
  double largest_angle_difference = 0;      ///< rad
  double rms_angle_difference = 0;          ///< rad
  double first_impact_time_difference = 0;  ///< s
  /// Quartiles of the same over draws, where there are some; else NaN.
  double rms_angle_difference_lower = 0, rms_angle_difference_upper = 0;
  double slip_error = 0;  ///< largest, m; law `unilateral` alone, else NaN
  double draws = 0;       ///< how many runs the numbers are medians of; NaN: one
  double impacts_matched = 0, impacts_missed = 0, impacts_extra = 0;
  /// Of the exact motion read from samples at the same steps.
  double impacts_matched_null = 0, impacts_missed_null = 0, impacts_extra_null = 0;
  double impacts_matched_random = 0, impacts_matched_shifted = 0;  ///< by chance
  double agreement_time = 0;                                       ///< s
  std::string toppled;
  /// RMS of the parts of the angle difference, rad; NaN where it is not split.
  double model_difference = 0, softness_difference = 0, step_difference = 0;
  double model_share = 0, softness_share = 0, step_share = 0;  ///< of the difference, sum 1
  double contact_stiffness = 0, contact_damping_ratio = 0,
         contact_restitution = 0;  ///< of the engine's points, N/m
  double spring_factor = 0;        ///< by which a spring is softer for the softness part
  double energy_gain = 0;          ///< share of weight times height
  double penetration = 0;          ///< largest, m
  double residual_motion = 0;      ///< RMS angular velocity where the exact one is zero, rad/s
  std::vector<std::string> cells;  ///< the whole row as text, for Comparison::columns
  std::filesystem::path folder;    ///< where its files are

  bool done() const { return status == "done"; }
  bool exact() const { return engine == "exact"; }
};

/// One block as it was run. SI units.
struct StackBlock {
  double width = 0, height = 0, mass = 0, inertia = 0;
  double offset_x = 0, offset_y = 0;  ///< of the centre of mass from the middle
};

struct ComparedScene {
  std::string name, title;
  int blocks = 0;
  std::string toml;                          ///< the scene as text
  std::string ground;                        ///< what moves the ground, empty where nothing does
  std::string law = {};                      ///< of the exact motion; empty where the results do not say
  double predictable_time = 0;               ///< until when histories can be compared, s; NaN: not known
  std::vector<StackBlock> stack = {};        ///< bottom to top; empty where the results do not say
  double gravity = 0;                        ///< m/s²
  double duration = std::nan("");            ///< s; NaN where the results do not say
  double chatter_speed = 0;                  ///< relative speed under which impacts are not compared, rad/s
  std::filesystem::path ground_motion = {};  ///< its file, empty where nothing moves it
  std::vector<std::string> results = {};     ///< what was computed, by the suite's names
  bool both_equations = false;               ///< linear and full equations, side by side
  bool fitted = false;                       ///< whether errors were fitted over the time steps

  bool perturbed = false;  ///< whether there are distributions over perturbed scenes

  std::vector<double> friction = {};  ///< of each interface; none where the results do not say
  bool slips = false;                 ///< whether a run tells how far blocks have slipped
  bool split = false;                 ///< whether differences are split into parts
  bool frictions = false;             ///< whether the exact solver ran with other friction too

  std::vector<std::string> sentences = {};  ///< what its rows come to; none where the results do not say

  bool has(const std::string& result) const;
};

/// The errors of one series over its time steps, fitted by model error + coefficient · dt^order. NaN where no
/// number was found.
struct Fit {
  std::string scene, engine, solver, settings;
  std::string quantity;                                               ///< the column of the errors
  double model_error = 0, model_error_low = 0, model_error_high = 0;  ///< in the unit of the errors
  double order = 0, order_low = 0, order_high = 0;
  double coefficient = 0;  ///< likewise, at a step of 1 s
  bool holds = false;
  std::string reason;  ///< why it does not
};

/// How far apart a run's distribution of a quantity over perturbed scenes is from the exact one.
struct Distance {
  std::string scene, run, quantity;
  double distance = 0, critical = 0;  ///< of Kolmogorov and Smirnov; the one with a chance of 5 %
  double exact_runs = 0;              ///< how many scenes the exact distribution is of; NaN: not in the file
  double exact_mean = 0, mean = 0;    ///< of "toppled": the shares of scenes that topple; NaN likewise
};

/// A statement of the paper beside what was computed.
struct PaperStatement {
  std::string source, claim, verdict, criterion, computed;
};

/// What `rockstack compare` has written.
struct Comparison {
  std::string title, command;
  std::vector<ComparedScene> scenes;
  Facts definitions;                  ///< what each column means
  Facts environment;                  ///< versions, compiler, processor
  double tolerance = 0;               ///< rad, the difference up to which angles count as agreeing; > 0
  std::vector<std::string> headline;  ///< what the comparison comes to, in sentences
  std::vector<std::string> left_out;
  std::vector<PaperStatement> statements;  ///< none where the suite does not ask for them
  std::vector<Fit> fits;
  std::vector<Distance> distances;
  std::vector<std::string> columns;
  std::vector<Run> runs;
};

/// A scene's title with the law of its exact motion.
std::string heading(const ComparedScene& scene);

/// Reads comparison.json and comparison.csv.
/// @throws InputError naming the file (and line) that is missing or malformed.
Comparison read_comparison(const std::filesystem::path& results);

/// Everything that a run's summary.json says, nested names joined by dots.
/// @throws InputError naming the file that is missing or malformed.
Facts read_summary(const Run& run);

/// Whether a run's history has a column. False where there is no history.
bool has_column(const Run& run, const std::string& column);

/// The runs of one scene that are done: the exact one first, engines in the order of the file.
std::vector<Run> done_runs(const Comparison& comparison, const std::string& scene);

/// True where a scene's motion can be shown: the results say how large its blocks are, and a run is done.
bool has_motion(const Comparison& comparison, const ComparedScene& scene);

/// True for a run of the exact solver with the other kind of equations than the scene's.
bool has_other_equations(const Run& run);

/// True for a run of the exact solver with a coefficient of friction of its own.
bool has_own_friction(const Run& run);

/// True for a run of the exact solver in another way than the scene's: other equations, friction or law.
bool is_variant(const Run& run);

/// The engine with its solver, "bullet:sequential-impulse"; "exact" for the exact solver.
std::string solver_name(const Run& run);

}  // namespace rockstack::plots
