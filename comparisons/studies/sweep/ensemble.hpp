#pragma once

#include "analytic/scene/input/fields.hpp"
#include "analytic/scene/input/json.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/measures/statistics/draws.hpp"

namespace rockstack {

/// A value of a varied key: as the scene takes it, and as tables show it.
struct Value {
  Node node;
  std::string text;
};

/// What one table [[vary]] changes, and the values it takes.
struct Variation {
  std::vector<std::string> keys;             ///< of the scene, all given the same value; the first names it
  std::vector<Value> values;                 ///< in order; empty where they are drawn
  std::optional<Distribution> distribution;  ///< where they are drawn
  std::string place;                         ///< file:line of the table

  const std::string& name() const { return keys.front(); }
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
};

/// Many runs of one scene with some values changed: a grid of fixed values, and at each of its points
/// `samples` runs with values drawn anew. Runs are numbered from 0; samples go fastest, then the last axis.
struct Ensemble {
  std::string title;
  SceneDocument base;
  std::vector<Variation> variations;
  std::vector<Axis> axes;
  std::size_t samples = 1;
  std::uint64_t seed = 0;
  double tolerance = 0;  ///< of each run: the solver's tolerance and resolution; 0: rounding
  bool demands = true;   ///< whether runs tell what their interfaces demand
  SummaryKeys summary;
};

std::size_t run_count(const Ensemble& ensemble);

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

/// The first value of a variation, or the median where values are drawn.
Value typical_value(const Variation& variation);

/// The base scene with the typical value of each variation.
SceneDocument typical_document(const Ensemble& ensemble);

// Every key of an ensemble file. A new one is a line here, and is read where the others of its table are.

inline const KeyTable ensemble_keys{
    "",
    "an ensemble: one scene many times, some of its keys varied",
    {{"title", "\"Fragility\"", "", "a text", required_key, "heads figures"},
     {"scene", "\"scene.toml\"", "",
      "a file beside the ensemble, or a table [scene] with the keys of a scene", required_key, "what is run"},
     {"samples", "100", "", "a whole number from 1", "required where values are drawn",
      "runs at each point of the grid, each with values drawn anew"},
     {"seed", "1", "", "a whole number from 0 to 2⁵³", "required where values are drawn", "of drawn values"},
     {"tolerance", "1e-9", "", "0 to 1e-3", "0", "of the solver; 0 is rounding, more is faster"},
     {"demands", "\"none\"", "", "\"kept\" or \"none\"", "\"kept\"",
      "least normal forces and friction needed, of each run; none is faster"},
     {"vary", "", "", "tables [[vary]]", required_key, "what differs from run to run"},
     {"summary", "", "", "a table [summary]", no_default, "which figures and tables are made"}}};

inline const KeyTable vary_keys{
    "[[vary]]",
    "values of a key: each table is a direction of the grid, or is drawn",
    {{"key", "\"duration\"", "", "a key of the scene, or an array of keys that get the same value",
      required_key, "as --set has it, e.g. \"blocks.2.height\""},
     {"group", "\"a\"", "", "a text", "none: a direction of its own",
      "tables of one group take their values in step"},
     {"values", "[0.5, 1.0]", "the key's", "numbers or texts", required_key, "one after the other"},
     {"range", "{ from = 0.5, to = 1.0, count = 3 }", "the key's", "a table, see below", "instead of values",
      "numbers at equal distances"},
     {"uniform", "[0.5, 1.0]", "the key's", "two numbers, the second larger", "instead of values",
      "drawn between the two"},
     {"normal", "{ mean = 1.0, deviation = 0.1 }", "the key's", "a table, see below", "instead of values",
      "drawn from a normal distribution"},
     {"lognormal", "{ median = 1.0, beta = 0.3 }", "the key's", "a table, see below", "instead of values",
      "drawn from a lognormal distribution"}}};

inline const KeyTable range_keys{
    "[vary.range]",
    "numbers at equal distances",
    {{"from", "0.5", "the key's", "any number", required_key, "first value"},
     {"to", "1.0", "the key's", "any number", required_key, "last value"},
     {"count", "3", "", "a whole number from 2 to 10⁶", required_key, "number of values"},
     {"spacing", "\"linear\"", "", "\"linear\" or \"log\"", "\"linear\"",
      "equal differences or equal ratios"}}};

inline const KeyTable normal_keys{
    "[vary.normal]",
    "a normal distribution",
    {{"mean", "1.0", "the key's", "any number", required_key, "of the values"},
     {"deviation", "0.1", "the key's", "> 0", required_key, "standard deviation"}}};

inline const KeyTable lognormal_keys{
    "[vary.lognormal]",
    "a lognormal distribution",
    {{"median", "1.0", "the key's", "> 0", required_key, "of the values"},
     {"beta", "0.3", "", "> 0", required_key, "standard deviation of the natural logarithm"}}};

inline const KeyTable summary_keys{
    "[summary]",
    "figures and tables of the whole sweep",
    {{"intensity", "\"duration\"", "", "a key that is varied over numbers", required_key,
      "fragility and incremental dynamic analysis over it"},
     {"period", "\"duration\"", "", "a key that is varied over numbers", no_default,
      "with intensity: the overturning spectrum of a pulse"},
     {"friction", "\"duration\"", "", "a key that is varied over numbers, without period", no_default,
      "with intensity: the map of rest, slide, rock, slide-rock and free flight"}}};

/// All tables of an ensemble file, in the order of a file.
inline constexpr std::initializer_list<const KeyTable*> ensemble_tables{
    &ensemble_keys, &vary_keys, &range_keys, &normal_keys, &lognormal_keys, &summary_keys};

}  // namespace rockstack
