#pragma once

#include "comparisons/runs/compare.hpp"
#include "comparisons/studies/diff/changes.hpp"
#include "comparisons/suites/compare_choice.hpp"

namespace CLI {
class App;
}

namespace rockstack {

/// What every command takes.
struct Common {
  std::vector<std::string> overrides;  ///< key=value, of scenes
  bool quiet = false;                  ///< print nothing but errors
  bool json = false;                   ///< print the result as JSON
  bool replace = false;                ///< results of another scene in the folder for results
  std::string workers;                 ///< folders of more engines
  std::string command;                 ///< the whole command line, for the results

  /// Whether tables and sentences are printed.
  bool prints_text() const { return !quiet && !json; }
};

// Each command returns the program's exit code: 0, or 1 where a run failed. Bad input is thrown as
// InputError. Scenes, suites and ensembles are files, or names that `list` shows.

struct SolveArguments {
  std::string scene;
  std::filesystem::path out;
  std::string integrator = "taylor";  ///< or "rk4"
  double step = 2e-4;                 ///< of rk4, s
  double interval = 1e-3;             ///< of samples, s
  bool plots = true;                  ///< figures and a page
  double tolerance = 0;  ///< of taylor: share of the velocity that a step may leave out; 0: rounding
  std::vector<std::string> histories;  ///< kinds_of_histories() to write
  bool branches = false;               ///< follow all motions where contact leaves several
  std::size_t most_branches = 16;
};
int solve_command(const SolveArguments& arguments, const Common& common);

struct SimulateArguments {
  std::string scene;
  std::filesystem::path out;
  std::string engine;
  std::string settings = "tuned";
  std::vector<std::string> parameters;  ///< name=value, changes of those settings
  double dt = 0;                        ///< s
  bool plots = true;                    ///< figures and a page
};
int simulate_command(const SimulateArguments& arguments, const Common& common);

struct CompareArguments {
  std::vector<std::string> inputs;    ///< scenes or suites
  std::optional<std::string> record;  ///< in the place of made-up motions
  std::filesystem::path out;
  std::size_t jobs = 1;  ///< runs at a time; without effect under mpirun
  CompareChoice choice;
};
int compare_command(const CompareArguments& arguments, const Common& common);

int plot_command(const std::filesystem::path& results, const Common& common);

struct AdviseArguments {
  std::string scene;
  std::filesystem::path out;
  double error = 1e-3;     ///< rad, and of the least block height
  double within = 60;      ///< of the whole search, s
  double time_limit = 60;  ///< of each run, s
  std::vector<std::string> engines = {};
};
int advise_command(const AdviseArguments& arguments, const Common& common);

struct FitArguments {
  std::string scene;
  std::filesystem::path out;
  std::vector<std::string> vary;  ///< fit_parameter() of each
};
int fit_command(const FitArguments& arguments, const Common& common);

struct DiffArguments {
  std::filesystem::path old_results, new_results;
  std::filesystem::path out;  ///< empty: nothing is written
  ChangeOptions options;
};
/// 1 where something got worse, else 3 where of some row nothing can be said.
int diff_command(const DiffArguments& arguments, const Common& common);

struct RecordArguments {
  std::string file;  ///< may name a channel, see read_record()
  std::filesystem::path out;
  std::string base_line = "none";  ///< or "fitted", taken off before anything is measured
};
int record_command(const RecordArguments& arguments, const Common& common);

struct SweepArguments {
  std::string ensemble;
  std::filesystem::path out;
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once; without effect under mpirun
};
int sweep_command(const SweepArguments& arguments, const Common& common);

struct TeachArguments {
  std::string lesson;  ///< empty or "list": list them; "all": the whole course
  std::filesystem::path out;
  std::optional<std::uint64_t> sheet;  ///< a problem sheet of that seed, in the place of the lesson
  bool pdf = false;                    ///< slides as PDF too
};
int teach_command(const TeachArguments& arguments, const Common& common);

struct LiveArguments {
  std::string input = "spanos-free-rocking";   ///< scene, lesson, folder of lessons, or a page's link
  std::vector<std::filesystem::path> records;  ///< that the page may choose
  int port = 0;                                ///< 0: any that is free
  bool browser = true;                         ///< is opened where there is one
};
int live_command(const LiveArguments& arguments, const Common& common);  ///< serves until it is ended

struct KindArguments {
  std::string kind;  ///< of what is listed, or of the files whose keys are explained; empty: all
};
int list_command(const KindArguments& arguments, const Common& common);
int keys_command(const KindArguments& arguments, const Common& common);

struct CheckEngineArguments {
  std::string engine;
  std::vector<std::string> settings{"default", "tuned"};
  std::vector<std::string> checks;  ///< their names; empty: all
};
int check_engine_command(const CheckEngineArguments& arguments, const Common& common);

struct CanonArguments {
  std::vector<std::string> engines;  ///< empty: all
  std::vector<std::string> settings{"default", "tuned"};
  std::filesystem::path out;
};
int canon_command(const CanonArguments& arguments, const Common& common);

struct NewArguments {
  std::string kind = "scene";         ///< or "suite", "ensemble"
  std::optional<std::string> record;  ///< of a scene
  std::filesystem::path out;          ///< a file that is not there; empty: standard output
};
int new_command(const NewArguments& arguments, const Common& common);

// What several commands share.

/// All solvers of an engine: of a worker program named by its path, or of a name that `list engines` shows;
/// or one, named with its solver. @throws InputError as find_engine().
std::vector<const WorkerEngine*> engines_named(const std::string& name);

/// Engines of several names; where there is none, those of `otherwise`.
std::vector<const WorkerEngine*> engines_named(const std::vector<std::string>& names,
                                               EngineList (*otherwise)());

/// @throws InputError, with the command that takes it, where a file is none of those kinds; `wanted`: what it
/// must be.
void require_kind(const std::string& input, const std::filesystem::path& file, const char* wanted,
                  const std::vector<InputKind>& kinds);

/// @throws InputError also where the input names a suite or an ensemble.
NamedScene read_one_scene(const std::string& input, const Common& common);

/// What results of an input say they are of: its name, without folder and ending.
std::string subject_of(const std::filesystem::path& input);

/// Says on standard error of which blocks the sizes seem to be in mm.
void warn_of_sizes(const Scene& scene, const Common& common);

/// @throws InputError with the reason where there are overrides.
void refuse_overrides(const Common& common, const char* reason);

/// The ranks that mpirun has started, or that many threads.
std::unique_ptr<Executor> make_executor(std::size_t threads);

// What the program says on standard output; progress goes to standard error, and only to a terminal.

/// Prints a result where it is wanted as JSON. Returns whether it is wanted in words.
bool print_json(const Json& result, const Common& common);

/// A word as a shell reads it back.
std::string shell_word(const std::string& word);

/// Whether there is a terminal to show it on, and somebody who wants it.
bool shows_progress(const Common& common);

/// A time to be waited for, in the largest unit that fits.
std::string waiting_time(double seconds);

/// A line that counts runs, names the one that is made and says how long the rest may take.
std::function<void(const Progress&)> progress(const Common& common);

/// Takes that line away, so that something else can be printed there.
void clear_progress(const Common& common);

/// Says on standard error how many runs failed, which file says why, and why the first did. Returns the exit
/// code.
int exit_code(std::size_t failed, std::size_t runs, const char* file, const std::string& reason);

/// Where figures and report are.
void print_report(const std::filesystem::path& folder, const Common& common);

/// Draws the figures and the report of a folder, as far as this build can, and says where they are.
void show_report(const std::filesystem::path& folder, const Common& common);

// The table of a comparison on standard output; nothing where it is not wanted.

/// What the columns mean, and how many runs there will be.
void print_legend(const std::vector<Suite>& suites, const Common& common);

/// Has rows printed as they are told. `common` must outlive the options.
void print_rows(const std::vector<Suite>& suites, const Common& common, CompareOptions& options);

/// Adds every subcommand with its options to the program, which must outlive what is returned: what each does
/// once its options are read.
std::map<const CLI::App*, std::function<int()>> add_commands(CLI::App& app, const Common& common);

}  // namespace rockstack
