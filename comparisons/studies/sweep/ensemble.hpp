#pragma once

#include "analytic/scene/input/json.hpp"
#include "analytic/scene/input/key.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/measures/statistics/draws.hpp"

namespace rockstack {

/// A value of a varied key: as the scene takes it, and as tables show it.
struct Value {
  Node node;
  std::string text;
};

/// Numbers at equal distances, or in equal ratios.
struct EvenValues {
  double from = 0, to = 0;
  std::size_t count = 0;
  bool logarithmic = false;
};

/// What one table [[vary]] changes, and the values it takes.
struct Variation {
  std::vector<std::string> keys;  ///< of the scene, all given the same value; the first names it
  std::vector<Value> values;      ///< in order, or those of which one is drawn
  std::optional<Distribution>
      distribution;        ///< where they are drawn; of the place in `values` where there are some
  std::string group = {};  ///< empty: a direction of its own
  std::string place;       ///< file:line of the table

  const std::string& name() const { return keys.front(); }
  bool is_drawn() const { return distribution.has_value(); }
  bool has(const std::string& key) const { return std::ranges::find(keys, key) != keys.end(); }
};

/// One direction of the grid: variations that take their values in step.
struct Axis {
  std::string group;                    ///< empty: a variation by itself
  std::vector<std::size_t> variations;  ///< indices
  std::size_t length = 0;               ///< number of values of each
};

/// Which summaries a sweep gets, by the names of variations; empty: none.
struct SummaryKeys {
  std::string intensity;  ///< fragility and incremental dynamic analysis
  std::string period;     ///< with `intensity`: overturning spectrum of a pulse
  std::string friction;   ///< with `intensity`: map of the modes of motion
  std::vector<std::string>
      indices;  ///< columns of outcomes, whose Sobol indices tell which drawn values decide
};

/// How values are drawn.
enum class Sampling { random, latin_hypercube };
inline constexpr std::array<const char*, 2> sampling_names{"random", "latin hypercube"};

/// Many runs of one scene with some values changed: a grid of fixed values, and at each of its points
/// `samples` with values drawn anew. A sample is a run, or for Sobol indices a row of Saltelli's design of
/// inputs A and B drawn independently: the runs of A, of B, and for each drawn input of A with that input
/// from B. Runs are numbered from 0; those of a sample go fastest, then samples, then the last axis.
struct Ensemble {
  std::string title;
  SceneDocument base;
  std::vector<Variation> variations;
  std::vector<Axis> axes;
  std::size_t samples = 1;
  std::uint64_t seed = 0;
  Sampling sampling = Sampling::random;
  double tolerance = 0;  ///< of each run: the solver's tolerance and resolution; 0: rounding
  bool demands = true;   ///< whether runs tell what their interfaces demand
  SummaryKeys summary;
};

std::size_t run_count(const Ensemble& ensemble);

/// The number of runs of each sample.
std::size_t sample_size(const Ensemble& ensemble);

/// The column of what a run is in its sample, where there are Sobol indices.
inline const std::string matrix_column = "matrix";

/// "A", "B", or the name of the input from B.
std::string matrix_of(const Ensemble& ensemble, std::size_t run);

/// How many blocks its scenes have.
std::size_t block_count(const Ensemble& ensemble);

/// The value of each variation in a run; it depends on the ensemble and the run's number alone.
std::vector<Value> values_of(const Ensemble& ensemble, std::size_t run);

/// Gives a variation's value to its keys. @throws InputError where the scene has no place for them.
void set_values(SceneDocument& document, const Variation& variation, const Value& value);

/// Reads an ensemble file (TOML) and tries the scene with each value it names. `overrides` go to the base
/// scene. The scene is a path relative to the file, or a table in it; records among the values are relative
/// to the file too.
/// @throws InputError with file:line, key, value and what is allowed.
Ensemble read_ensemble(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       MotionLibrary& library);

/// Makes an ensemble of what stands in such a file; paths are relative to the folder of `file`.
Ensemble make_ensemble(const Node& root, const std::filesystem::path& file,
                       const std::vector<std::string>& overrides, MotionLibrary& library);

/// What one table [[vary]] changes, as results have it.
Json json_of(const Variation& variation);

/// A text that is the same for ensembles whose runs are the same: the base scene, all variations, the
/// contents of the records, and the version, compiler and flags of this program.
std::string identity(const Ensemble& ensemble, MotionLibrary& library);

/// One table [[vary]]; paths of records are relative to `folder`. @throws InputError with place, key, value
/// and range.
Variation read_variation(const Node& table, const std::filesystem::path& folder);

/// The value of a variation at a draw of its distribution.
Value drawn_value(const Variation& variation, double draw);

/// Whether a value is a record's path, by any of the keys.
bool is_record(const Variation& variation, const Value& value);

/// The first value of a variation, or the median where numbers are drawn.
Value typical_value(const Variation& variation);

/// The base scene with the typical value of each variation.
SceneDocument typical_document(const Ensemble& ensemble);

// Every key of an ensemble file. A new one that is a number or a text is a member and a line where its table
// is defined, beside what reads the others.

extern const KeysOf<Ensemble> ensemble_keys;
extern const KeysOf<Variation> vary_keys;
extern const KeysOf<EvenValues> range_keys;
extern const KeysOf<Distribution> normal_keys, lognormal_keys;
extern const KeysOf<Ensemble> summary_keys;

/// All tables of an ensemble file, in the order of a file.
inline constexpr std::initializer_list<const KeyTable*> ensemble_tables{
    &ensemble_keys, &vary_keys, &range_keys, &normal_keys, &lognormal_keys, &summary_keys};

}  // namespace rockstack
