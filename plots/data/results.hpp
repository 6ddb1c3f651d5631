#pragma once

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/measures/results/print_style.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/verdict/verdict.hpp"

namespace rockstack::plots {

namespace fs = std::filesystem;

/// Names and texts in the order of the file.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A text that names a file or folder of results, no path to elsewhere. @throws InputError naming `place`.
std::string file_name(const std::string& text, const std::string& place);

/// Everything that an object says, nested names joined by dots.
Facts facts_of(const Json& object);

/// What was read of files: each is read once and kept while there is room, as a scene's figures share them.
class KeptFiles {
 public:
  /// What `read` makes of a file. A file is always read by the same function.
  template <class Read>
  auto get(const fs::path& file, const Read& read) {
    using Value = std::invoke_result_t<Read, const fs::path&>;
    if (const auto found = kept_.find(file); found != kept_.end())
      return std::static_pointer_cast<const Value>(found->second);
    std::shared_ptr<const Value> value = std::make_shared<const Value>(read(file));
    make_room_for(file);
    kept_[file] = value;
    return value;
  }

 private:
  void make_room_for(const fs::path& file);

  std::map<fs::path, std::shared_ptr<const void>> kept_;
  std::uintmax_t bytes_ = 0;  ///< of the files
};

/// A row of a comparison, and where its files are.
struct Run : RunMetrics {
  fs::path folder = {};
  std::shared_ptr<KeptFiles> files = {};  ///< what was read of them; null: nothing is kept

  /// Where the files of the motion are that stands for the row: the run's own, or a replicate's.
  fs::path shown_folder() const { return shown_replicate.value_or(0) > 0 ? folder / shown_name : folder; }
  bool done() const { return status == RunStatus::done; }
  bool exact() const { return engine == "exact"; }
  /// Whether it is of the exact solver in another way than the scene's: other equations, a coefficient of
  /// friction of its own, or any of both and other laws.
  bool has_other_equations() const { return engine == "linear" || engine == "nonlinear"; }
  bool has_own_friction() const { return engine.starts_with("friction="); }
  bool is_variant() const { return !exact() && solver == "taylor"; }
  /// Whether its history tells slips, gaps and places, as its law leaves pivots.
  bool tells_slips() const {
    return leaves_pivots(static_cast<Law>(std::ranges::find(law_names, law) - law_names.begin()));
  }
  /// The engine with its solver, "bullet:sequential-impulse"; "exact" for the exact solver.
  std::string solver_name() const { return exact() || solver.empty() ? engine : engine + ":" + solver; }
};

/// What a cell of a row holds as a number, NaN where it is empty.
template <class Number>
double value_of(const std::optional<Number>& cell) {
  return cell ? static_cast<double>(*cell) : std::numeric_limits<double>::quiet_NaN();
}

/// A scene as it was compared.
struct ComparedScene : Scene {
  std::string name = {};
  std::string heading = {};                ///< the title, with the law of its exact motion
  std::string ground = {};                 ///< what moves it, in words; empty where nothing does
  std::string toml = {};                   ///< the scene as text
  std::string page = {};                   ///< the scene for pages that solve it, JSON; empty: none
  double predictable_time = std::nan("");  ///< until when histories can be compared, s; NaN: not known
  fs::path ground_motion = {};             ///< its file, empty where nothing moves it
  std::vector<std::string> results = {};   ///< what was computed, by the suite's names
  std::vector<std::string> readings = {};  ///< what a test has measured, by its columns
  std::string reading_unit = {};           ///< "rad" or "m"
  bool both_equations = false;             ///< linear and full equations, side by side
  bool fitted = false;                     ///< whether errors were fitted over the time steps
  bool perturbed = false;                  ///< whether there are distributions over perturbed scenes
  bool slips = false;                      ///< whether a run tells how far blocks have slipped
  bool split = false;                      ///< whether differences are split into parts
  bool frictions = false;                  ///< whether the exact solver ran with other friction too
  bool alone = false;                      ///< one motion by itself: no run stands beside another

  bool has(const std::string& result) const { return std::ranges::find(results, result) != results.end(); }
  int block_count() const { return static_cast<int>(blocks.size()); }
  /// Until when histories can be compared, s.
  double horizon() const { return std::isnan(predictable_time) ? duration : predictable_time; }
};

/// What `rockstack compare` has written.
struct Comparison {
  std::string title, command;
  std::vector<ComparedScene> scenes;
  Facts definitions;          ///< what each column means
  Facts environment;          ///< versions, compiler, processor
  double tolerance = 0;       ///< rad, the difference up to which angles count as agreeing; > 0
  ComparisonVerdict verdict;  ///< what it comes to; of one motion alone nothing
  std::vector<std::string> left_out;
  /// Statements of the paper, where the suite asks for them: source, claim, verdict, criterion, computed.
  std::vector<std::vector<std::string>> statements;
  std::vector<SeriesFit> fits;  ///< of errors over time steps
  std::vector<DistributionDistance> distances;
  std::vector<Run> runs;
  std::optional<PrintStyle> print = {};  ///< of figures for print, where the suite asks for them
};

/// Reads comparison.json. @throws InputError naming what is missing or malformed.
Comparison read_comparison(const fs::path& results);

/// What `rockstack solve` or `simulate` has written: a comparison of one scene with one run, whose files lie
/// in the results folder itself.
struct Motion {
  Comparison comparison;
  std::string verdict;  ///< in one line; why it was given up where it was
  Facts summary;        ///< everything that summary.json says besides
};

/// Reads summary.json. @throws InputError naming the file that is missing or malformed.
Motion read_motion(const fs::path& results);

/// The runs of one scene that are done: the exact one first, engines in the order of the file.
std::vector<Run> done_runs(const Comparison& comparison, const std::string& scene);

/// True where a scene's motion can be shown: histories were asked for, and a run is done.
inline bool has_motion(const Comparison& comparison, const ComparedScene& scene) {
  return scene.has("histories") && !done_runs(comparison, scene.name).empty();
}

}  // namespace rockstack::plots
