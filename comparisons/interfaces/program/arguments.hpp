#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/studies/diff/changes.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

/// What every command takes.
struct Common {
  std::vector<std::string> overrides;  ///< key=value, of scenes
  bool quiet = false;                  ///< print nothing but errors
  bool json = false;                   ///< print the result as JSON
  std::string workers;                 ///< folders of more engines
  std::string command;                 ///< the whole command line, for the results
};

struct SolveArguments {
  std::string scene;
  std::filesystem::path out;
  std::string integrator = "taylor";  ///< or "rk4"
  double step = 2e-4;                 ///< of rk4, s
  double interval = 1e-3;             ///< of samples, s
  bool plots = true;                  ///< figures and a page
  double tolerance = 0;  ///< of taylor: share of the velocity that a step may leave out; 0: rounding
  std::vector<std::string> histories;  ///< kinds_of_histories() to write
};

struct SimulateArguments {
  std::string scene;
  std::filesystem::path out;
  std::string engine;
  std::string settings = "tuned";
  std::vector<std::string> parameters;  ///< name=value, changes of those settings
  double dt = 0;                        ///< s
  bool plots = true;                    ///< figures and a page
};

struct CompareArguments {
  std::vector<std::string> inputs;    ///< scenes or suites
  std::optional<std::string> record;  ///< in the place of made-up motions
  std::filesystem::path out;
  std::size_t jobs = 1;                    ///< runs at a time; without effect under mpirun
  int draws = 0;                           ///< behind each number of an engine; 0: as many as the suites say
  SceneChoice choice;                      ///< of scenes; suites say their own
  std::optional<double> history_interval;  ///< in the place of that of the suites, s
};

struct CheckEngineArguments {
  std::string engine;
  std::vector<std::string> settings;  ///< empty: both
  std::vector<std::string> checks;    ///< their names; empty: all
};

struct CanonArguments {
  std::vector<std::string> engines;   ///< empty: all
  std::vector<std::string> settings;  ///< empty: both
  std::filesystem::path out;
};

struct KeysArguments {
  std::string kind;  ///< "scene", "suite" or "ensemble"; empty: all
};

struct NewArguments {
  std::string kind = "scene";         ///< or "suite", "ensemble"
  std::optional<std::string> record;  ///< of a scene
  std::filesystem::path out;          ///< a file that is not there; empty: standard output
};

struct PlotArguments {
  std::filesystem::path results;
  bool animate = false;  ///< films of the motions too
};

struct AdviseArguments {
  std::string scene;
  std::filesystem::path out;
  double error = 1e-3;     ///< rad, and of the least block height
  double within = 60;      ///< of the whole search, s
  double time_limit = 60;  ///< of each run, s
  std::vector<std::string> engines = {};
};

struct RecordArguments {
  std::string file;  ///< may name a channel, see read_record()
  std::filesystem::path out;
  std::string base_line = "none";  ///< or "fitted", taken off before anything is measured
};

struct DiffArguments {
  std::filesystem::path old_results, new_results;
  std::filesystem::path out;  ///< empty: nothing is written
  ChangeOptions options;
};

struct TeachArguments {
  std::string lesson;  ///< empty or "list": list them; "all": the whole course
  std::filesystem::path out;
  std::optional<std::uint64_t> sheet;  ///< a problem sheet of that seed, in the place of the lesson
  bool pdf = false;                    ///< slides as PDF too
};

struct LiveArguments {
  std::string input = "spanos-free-rocking";   ///< scene, lesson, folder of lessons, or a page's link
  std::vector<std::filesystem::path> records;  ///< that the page may choose
  int port = 0;                                ///< 0: any that is free
  bool browser = true;                         ///< is opened where there is one
};

struct SweepArguments {
  std::string ensemble;
  std::filesystem::path out;
  std::size_t threads = 0;  ///< 0: as many as the machine runs at once; without effect under mpirun
};

}  // namespace rockstack
