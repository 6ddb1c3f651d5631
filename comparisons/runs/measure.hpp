#pragma once

#include "analytic/branches.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/sampled_patterns.hpp"
#include "comparisons/runs/job.hpp"

namespace rockstack {

/// A motion that is compared with the exact one of a scene.
struct CandidateMotion {
  const History& history;
  double interval = 0;                    ///< between its samples, s
  std::vector<ImpactTime> impacts;        ///< at the chatter speed or more
  bool topples = false;                   ///< within the scene
  std::optional<BodyRecord> bodies = {};  ///< of an engine
  std::vector<double> friction = {};      ///< that acts in an engine, of each interface
};

/// Sets a candidate beside the exact solution at its own times: fills in the columns that the suite wants, of
/// histories up to `horizon` s (job.hpp), and adds history.csv, difference.csv, impacts.csv,
/// contact_impacts.csv, patterns.csv, energy.csv, reactions.csv, impulses.csv and parts.csv as far as it
/// wants them, patterns.csv and impulses.csv up to the horizon and the others whole.
/// @throws std::runtime_error where the scene cannot be solved.
void compare_with_exact(const Scene& scene, const Suite& suite, const CandidateMotion& candidate,
                        double horizon, RunMetrics& row, RunFiles& files);

/// Sets a motion beside what a test of the job's scene has measured, where one has: fills in the difference
/// up to the horizon and adds readings.csv, where the suite wants histories. The motion is linear between its
/// samples. `bodies`: where an engine has its centres.
void compare_with_test(const Job& job, const Scene& scene, const History& history,
                       const std::optional<BodyRecord>& bodies, RunMetrics& row, RunFiles& files);

/// The springs that contacts of an engine are, all points of a corner together.
CornerSpring corner_of(const ContactRecord& contacts);

/// The scene's exact motion on springs.
struct SoftMotion {
  History history;    ///< of an extrapolation angles alone
  double factor = 1;  ///< by which springs are softer than asked for, spring_factor()
};

/// Where that motion would take more than about `most_steps`, angles are extrapolated from springs softer by
/// that factor and by twice as much, as if in proportion to it.
/// @throws as solve().
SoftMotion soft_motion(const Scene& scene, const std::vector<double>& friction, CornerSpring spring,
                       const std::vector<double>& times, double most_steps = 1e5);

/// Splits the difference of an engine's motion from the exact one, at its own times, into contact model,
/// softness and step: solves the scene on rigid contacts and on springs as well. Fills in the columns of the
/// split, up to `horizon` s, and, where `histories`, parts.csv. Where a motion cannot be solved the row says
/// why.
void add_parts(const Scene& scene, const History& exact, const CandidateMotion& candidate, double horizon,
               bool histories, RunMetrics& row, RunFiles& files);

/// Makes one run of a comparison: for the exact solution its history and events, up to where it was
/// given up if it was; for others what compare_with_exact() adds; and its summary.json. A failure ends up in
/// the summary. `runs_at_a_time`: how many share the machine with it, itself included.
RunFiles measure(const Job& job, const std::string& command, std::size_t runs_at_a_time);

/// Makes one run of a job's series, replicate 0 its nominal one, and sets it beside the exact solution of its
/// scene; `repeats`: how often its stepping is timed. The motion is left in `motion` where that is asked for.
/// @throws std::runtime_error where the scene cannot be solved or the worker not be started.
RunMetrics engine_metrics(const Job& job, int replicate, int repeats, RunFiles& files,
                          History* motion = nullptr);

/// A scene to be solved by itself.
struct SolveJob {
  const NamedScene& scene;
  const SolveOptions& options;
  const std::vector<std::string>& histories;  ///< kinds to be kept (results/tables.hpp)
  const std::filesystem::path& folder;
  const std::string& command;
};

/// Solves it and writes history.csv, events.csv, its `histories` and summary.json into its folder. Where the
/// motion could not be followed to its end, the files hold it up to there, and the summary's status is
/// "failed". @throws as solve(), with the files written.
History solve_into(const SolveJob& job);

/// Solves and writes all branches: the first into the folder, others into folder/branches/2 and so on; and
/// branches.csv, branches_json() as a table. @throws as solve_branches().
BranchTree solve_branches_into(const SolveJob& job, std::size_t most);

/// Runs one engine and writes the same files, with patterns as its angles tell them (sampled_patterns());
/// an engine reports no events, so events.csv has its header alone. Returns how its blocks end on what they
/// stand on as well.
std::pair<History, SupportLoss> simulate_into(const NamedScene& scene, const EngineSeries& series, double dt,
                                              const std::filesystem::path& folder, const std::string& command,
                                              const std::vector<std::string>& histories = {});

}  // namespace rockstack
