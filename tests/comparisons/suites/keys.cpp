#include <gtest/gtest.h>

#include <sstream>

#include "analytic/scene/input/toml_reader.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/suite.hpp"
#include "comparisons/suites/suite_keys.hpp"
#include "tests/analytic/scene/input/key_file.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr const char* key_scene = R"(duration = 0.2
[[blocks]]
width = 0.5
height = 1
density = 2500
[[blocks]]
width = 0.5
height = 1
density = 2500
)";

/// A worker that can say who it is.
constexpr const char* key_worker = R"(#!/bin/sh
echo '{"rockstack": 1, "engines": [{"name": "own", "solver": "own", "version": "1", "licence": "own",
  "settings": [{"name": "erp", "default": 0, "tuned": 0, "least": 0, "most": 1}]}]}' >&3
)";

template <class Read>
std::string key_error(const std::string& text, const Read& read) {
  const TemporaryFolder folder;
  folder.write("scene.toml", key_scene);
  folder.write("isaac.csv", "time,theta_1,theta_2\n0,0,0\n0.2,0,0\n");
  std::filesystem::permissions(folder.write("my_engine.py", key_worker), std::filesystem::perms::owner_all);
  try {
    read(folder.write("input.toml", text));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

std::string read_suite_text(const std::string& text) {
  return key_error(text, [](const std::filesystem::path& file) { read_suite(file, {}); });
}

std::string read_study_text(const std::string& text) {
  return key_error(text, [](const std::filesystem::path& file) {
    if (kind_of(file) == InputKind::stability_study) {
      read_stability_study(file, {});
    } else {
      read_impact_law_study(file);
    }
  });
}

void read_ensemble_file(const std::filesystem::path& file) {
  MotionLibrary library;
  read_ensemble(file, {}, library);
}

/// Where values are drawn, how many and from which seed must be said too.
std::string read_ensemble_text(const std::string& text) {
  const bool draws = std::ranges::any_of(std::array{"uniform", "normal", "one_of"}, [&](const char* way) {
    return text.find(way) != std::string::npos;
  });
  return key_error((draws ? "samples = 2\nseed = 1\n" : "") + text, read_ensemble_file);
}

/// The table [[engines]] without `except`, which is of all engines alone.
KeyTable keys_of_one_engine() {
  KeyTable table = engine_keys;
  std::erase_if(table.keys, [](const InputKey& key) { return std::string_view(key.name) == "except"; });
  return table;
}

TEST(Keys, OfSuitesAreThoseThatAreRead) {
  const KeyTable one_engine = keys_of_one_engine();
  expect_keys_are_those_read(KeyFile({&suite_keys, &one_engine}), one_engine, read_suite_text);
  for (const KeyTable* table : suite_tables) {
    if (table == &engine_keys) continue;
    std::vector<const KeyTable*> tables{&suite_keys, &engine_keys};
    if (table != &suite_keys) tables.push_back(table);
    expect_keys_are_those_read(KeyFile(tables), *table, read_suite_text);
  }
  expect_tables_are_complete(suite_tables);
}

/// What reading a file gives, as text; its scene lies beside it.
using Describe = std::string (*)(const std::filesystem::path& file);

std::string suite_of(const std::filesystem::path& file) {
  const Suite suite = read_suite(file, {});
  std::ostringstream found;
  found << suite.tolerance << ' ' << suite.repeats << ' ' << suite.limits.time << ' ' << suite.limits.memory
        << ' ' << suite.replicates.runs << ' ' << suite.replicates.steps << ' ' << suite.replicates.scene
        << ' ' << suite.replicates.seed << ' ' << suite.perturbations.runs << ' ' << suite.perturbations.size
        << ' ' << suite.perturbations.seed << ' ' << suite.variants.size();
  const PrintStyle print = read_style_text(suite.print, "figures");
  found << ' ' << print.width << ' ' << print.font << ' ' << print.font_size << ' '
        << static_cast<int>(print.unit) << ' ' << print.titles << ' ' << print.figures.size() << ' '
        << print.panels.size() << ' ' << print.from << ' ' << print.to;
  for (const EngineSeries& series : suite.series) {
    found << ' ' << series.settings;
    for (const double step : series.steps) found << ' ' << step;
  }
  return found.str();
}

std::string study_of(const std::filesystem::path& file) {
  const StabilityStudy study = read_stability_study(file, {});
  std::ostringstream found;
  found << study.suite.repeats << ' ' << study.suite.limits.time;
  return found.str();
}

std::string ensemble_of(const std::filesystem::path& file) {
  MotionLibrary library;
  const Ensemble ensemble = read_ensemble(file, {}, library);
  std::ostringstream found;
  found << ensemble.tolerance << ' ' << ensemble.demands;
  for (std::size_t run = 0; run < run_count(ensemble); ++run)
    for (const Value& value : values_of(ensemble, run)) found << ' ' << value.text;
  return found.str();
}

/// Holds every default of a table that is a value to what the reader takes without the key; tells how many.
int expect_defaults_are_those_read(const KeyFile& file, const KeyTable& table, Describe describe) {
  const TemporaryFolder folder;
  folder.write("scene.toml", key_scene);
  const auto read = [&](const KeyFile& one) { return describe(folder.write("input.toml", one.text())); };
  int defaults = 0;
  for (const InputKey& key : table.keys) {
    const bool empty_list = std::string_view(key.default_value) == "[]";  // which `set` refuses
    if (empty_list || !parse_toml_value(key.default_value, Node{})) continue;
    EXPECT_EQ(read(KeyFile(file).set(table, key.name, key.default_value)), read(file)) << key.name;
    ++defaults;
  }
  return defaults;
}

TEST(Keys, OfSuitesHaveTheDefaultsOfTheReader) {
  int defaults = 0;
  for (const KeyTable* table : suite_tables) {
    if (table == &statements_keys) continue;
    std::vector<const KeyTable*> tables{&suite_keys, &engine_keys};
    if (table != &suite_keys && table != &engine_keys) tables.push_back(table);
    defaults += expect_defaults_are_those_read(KeyFile(tables), *table, suite_of);
  }
  EXPECT_GE(defaults, 10);
}

TEST(Keys, OfStudiesAndEnsemblesHaveTheDefaultsOfTheReader) {
  const KeyFile study({&stability_keys, &axis_keys, &engine_keys});
  EXPECT_EQ(expect_defaults_are_those_read(study, stability_keys, study_of), 2);
  KeyFile drawn({&ensemble_keys, &vary_keys});
  drawn.set(ensemble_keys, "samples", "2").set(ensemble_keys, "seed", "1");
  drawn.set(vary_keys, "uniform", "[0.5, 1.0]");
  EXPECT_EQ(expect_defaults_are_those_read(drawn, ensemble_keys, ensemble_of), 3);
  KeyFile ensemble({&ensemble_keys, &vary_keys, &range_keys});
  ensemble.leave_out(vary_keys, "values");
  EXPECT_EQ(expect_defaults_are_those_read(ensemble, range_keys, ensemble_of), 1);
}

TEST(Keys, OfStudiesAreThoseThatAreRead) {
  KeyFile stability({&stability_keys, &axis_keys, &engine_keys});
  expect_keys_are_those_read(stability, stability_keys, read_study_text);
  stability.set(engine_keys, "parameters", "{ erp = [0.1, 0.2] }");
  expect_keys_are_those_read(stability, axis_keys, read_study_text);
  expect_keys_are_those_read(KeyFile({&impact_law_keys, &engine_keys}), impact_law_keys, read_study_text);
}

TEST(Keys, OfEnsemblesAreThoseThatAreRead) {
  expect_keys_are_those_read(KeyFile({&ensemble_keys, &vary_keys}), vary_keys, read_ensemble_text);
  // Intensity and period of a summary are of two keys, the second one drawn as indices need it.
  const KeyTable second = vary_keys;
  KeyFile both({&ensemble_keys, &vary_keys, &second, &summary_keys});
  both.set(second, "key", "\"gravity\"").set(second, "values", "[9.0, 10.0]");
  both.set(vary_keys, "uniform", "[0.1, 0.2]");
  expect_keys_are_those_read(both.set(summary_keys, "intensity", "\"gravity\""), summary_keys,
                             read_ensemble_text);
  KeyFile ranges({&ensemble_keys, &vary_keys, &range_keys});
  expect_keys_are_those_read(ranges.leave_out(vary_keys, "values"), range_keys, read_ensemble_text);
  for (const KeyTable* table : {&normal_keys, &lognormal_keys}) {
    KeyFile drawn({&ensemble_keys, &vary_keys, table});
    expect_keys_are_those_read(drawn.leave_out(vary_keys, "values"), *table, read_ensemble_text);
  }
  // Samples and seed, at the top of the file, go with drawn values.
  KeyFile drawn({&ensemble_keys, &vary_keys});
  drawn.set(vary_keys, "uniform", "[0.5, 1.0]")
      .set(ensemble_keys, "samples", "2")
      .set(ensemble_keys, "seed", "1");
  expect_keys_are_those_read(drawn, ensemble_keys,
                             [](const std::string& text) { return key_error(text, read_ensemble_file); });
  expect_tables_are_complete(ensemble_tables);
}

}  // namespace
}  // namespace rockstack
