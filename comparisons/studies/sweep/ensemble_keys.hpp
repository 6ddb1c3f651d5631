#pragma once

#include "analytic/scene/input/fields.hpp"

namespace rockstack {

// Every key of an ensemble file. A new one is a line here, and is read where the others of its table are.

inline constexpr KeyTable ensemble_keys{
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

inline constexpr KeyTable vary_keys{
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

inline constexpr KeyTable range_keys{
    "[vary.range]",
    "numbers at equal distances",
    {{"from", "0.5", "the key's", "any number", required_key, "first value"},
     {"to", "1.0", "the key's", "any number", required_key, "last value"},
     {"count", "3", "", "a whole number from 2 to 10⁶", required_key, "number of values"},
     {"spacing", "\"linear\"", "", "\"linear\" or \"log\"", "\"linear\"",
      "equal differences or equal ratios"}}};

inline constexpr KeyTable normal_keys{
    "[vary.normal]",
    "a normal distribution",
    {{"mean", "1.0", "the key's", "any number", required_key, "of the values"},
     {"deviation", "0.1", "the key's", "> 0", required_key, "standard deviation"}}};

inline constexpr KeyTable lognormal_keys{
    "[vary.lognormal]",
    "a lognormal distribution",
    {{"median", "1.0", "the key's", "> 0", required_key, "of the values"},
     {"beta", "0.3", "", "> 0", required_key, "standard deviation of the natural logarithm"}}};

inline constexpr KeyTable summary_keys{
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
