// Every key of a suite, a study and an ensemble does something: another value of it changes the results, in a
// file where it matters.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/suite_keys.hpp"
#include "engines/worker/registry.hpp"
#include "tests/analytic/scene/input/key_file.hpp"
#include "tests/comparisons/studies/sweep/sweep_folder.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Settings = std::vector<KeyCase::Setting>;

constexpr const char* shaken_pair = R"(duration = 0.2
[[blocks]]
width = 0.5
height = 2
density = 2500
[[blocks]]
width = 0.5
height = 1
density = 2500
[initial]
angles = [0.05, 0.1]
[ground.horizontal]
pulse = "sine"
amplitude = 4
period = 0.1
)";

/// Names of what is in a folder, and the texts of its tables, but those that hold times of this machine.
std::string tables_of(const fs::path& folder) {
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool times = name == "comparison.csv" || name == "stability.csv" || name == "ranking.csv";
    found.insert(entry.path().extension() == ".csv" && !times ? name + "\n" + bytes_in(entry.path()) : name);
  }
  std::string text;
  for (const std::string& one : found) text += one + "\n";
  return text;
}

/// Members of a file of results.
std::string members_of(const fs::path& file, std::initializer_list<const char*> names) {
  const Json json = Json::parse(bytes_in(file));
  std::string text;
  for (const char* name : names) text += json.value(name, Json()).dump() + "\n";
  return text;
}

/// What rows say, but times of this machine.
std::string text_of(const std::vector<RunMetrics>& rows) {
  std::ostringstream text;
  for (const RunMetrics& row : rows) {
    for (const Column& column : columns())
      if (!column.measured) text << column.cell(row) << ' ';
    text << '\n';
  }
  return text.str();
}

/// A file of those settings beside two scenes and a worker.
fs::path written(KeyFile file, const Settings& settings, const TemporaryFolder& folder) {
  folder.write("scene.toml", shaken_pair);
  folder.write("other.toml", std::string(shaken_pair) + "start = 0.05\n");
  folder.write("isaac.csv", "time,theta_1,theta_2\n0,0.05,0.1\n0.1,0.04,0.08\n0.2,0.03,0.05\n");
  folder.write("other.csv", "time,theta_1,theta_2\n0,0.05,0.1\n0.1,0.05,0.09\n0.2,0.05,0.08\n");
  fs::create_symlink(FAULTY_WORKER, folder.path() / "my_engine.py");
  fs::create_symlink(find_engine("ode").program, folder.path() / "other.py");
  for (const auto& [table, key, value] : settings) file.set(*table, key, value);
  fs::create_directory(folder.path() / "results");
  return folder.write("input.toml", file.text());
}

const KeyCase::Setting once{&suite_keys, "repeats", "1"};
const KeyCase::Setting one_step{&engine_keys, "dt", "[1e-2]"};

std::string suite_outcome(const Settings& settings) {
  std::vector<const KeyTable*> tables{&suite_keys, &engine_keys};
  for (const auto& [table, key, value] : settings)
    if (std::find(tables.begin(), tables.end(), table) == tables.end()) tables.push_back(table);
  KeyFile file(tables);
  if (std::find(tables.begin(), tables.end(), &statements_keys) != tables.end()) {
    for (const char* name : {"free", "shaken"}) file.set(statements_keys, name, "\"scene\"");
  }
  file.set(*once.table, once.key, once.value).set(*one_step.table, one_step.key, one_step.value);
  const TemporaryFolder folder;
  const fs::path input = written(std::move(file), settings, folder);
  const fs::path results = folder.path() / "results";
  const auto rows = compare({read_suite(input, {})}, results, *make_threads(1), {}).rows;
  return text_of(rows) + tables_of(results) +
         members_of(results / "comparison.json", {"title", "statements", "verdict", "figures"});
}

/// An engine that takes half a second of processor time.
const Settings slow{{&engine_keys, "worker", "\"./my_engine.py\""},
                    {&engine_keys, "name", "\"faulty:half-a-second\""}};
const KeyCase::Setting three_draws{&replicates_keys, "runs", "3"};
const KeyCase::Setting papers{&suite_keys, "scenes",
                              "[\"scene.toml\", \"spanos-free-rocking\", \"spanos-synthetic\"]"};
const KeyCase::Setting papers_free{&statements_keys, "free", "\"spanos-free-rocking\""};

const std::vector<KeyCase> suite_cases{
    {&suite_keys, "title", "\"Another\""},
    {&suite_keys, "scenes", "[\"other.toml\"]"},
    {&suite_keys, "set", "[\"gravity=9.0\"]"},
    {&suite_keys, "vary", "{ gravity = [9.0] }"},
    {&suite_keys, "variants", "[\"paper\"]"},
    {&suite_keys, "tolerance", "1e-5"},
    {&suite_keys, "repeats", "1"},
    {&suite_keys, "results", "[\"angles\"]"},
    {&suite_keys, "softness", "\"whole\""},
    {&suite_keys,
     "time_limit",
     "0.2",
     {{&engine_keys, "worker", "\"./my_engine.py\""}, {&engine_keys, "name", "\"faulty:half-a-second\""}}},
    {&suite_keys, "memory_limit", ""},  // Workers.HungerMeetsTheMemoryLimit: sanitized ones have none
    {&engine_keys, "name", "\"bullet\""},
    {&engine_keys, "except", ""},  // Suites.AStarStandsFor*: it is of all engines
    {&engine_keys, "worker", "\"./other.py\""},
    {&engine_keys, "settings", "[\"default\"]"},
    {&engine_keys, "dt", "[2e-3]"},
    {&engine_keys, "parameters", "{ erp = 0.3 }"},
    {&trajectory_keys, "name", "\"genesis\""},
    {&trajectory_keys, "files", "[\"other.csv\"]"},
    {&trajectory_keys, "scene", "\"other\"", {{&suite_keys, "scenes", "[\"scene.toml\", \"other.toml\"]"}}},
    {&replicates_keys, "runs", "3"},
    {&replicates_keys, "most_steps", "1", {three_draws}},
    {&replicates_keys, "steps", "0.3", {three_draws}},
    {&replicates_keys, "scene", "0.01", {three_draws}},
    {&replicates_keys, "seed", "2", {three_draws}},
    {&perturbations_keys, "runs", "10"},
    {&perturbations_keys, "size", "1e-3"},
    {&perturbations_keys, "seed", "2"},
    {&print_keys, "style", ""},  // of which there is one
    {&print_keys, "width", "180.0"},
    {&print_keys, "font", "\"DejaVu Serif\""},
    {&print_keys, "font_size", "7.0"},
    {&print_keys, "unit", "\"mrad\""},
    {&print_keys, "titles", "\"scene\""},
    {&print_keys, "figures", "[\"motion\"]"},
    {&print_keys, "panels", "[\"θ1\"]"},
    {&print_keys, "from", "0.1"},
    {&print_keys, "to", "0.15"},
    {&statements_keys, "free", papers_free.value, {papers}},
    {&statements_keys, "shaken", "\"spanos-synthetic\"", {papers, papers_free}},
};

TEST(KeyEffects, OfSuites) {
  if (engines_called("ode").empty() || engines_called("bullet").empty())
    GTEST_SKIP() << "this build has not both Bullet and ODE";
  expect_keys_have_effects(suite_tables, suite_cases, suite_outcome);
}

TEST(KeyEffects, OfStabilityStudies) {
  if (engines_called("ode").empty() || engines_called("bullet").empty())
    GTEST_SKIP() << "this build has not both Bullet and ODE";
  const auto outcome = [](const Settings& settings) {
    KeyFile file({&stability_keys, &axis_keys, &engine_keys});
    file.set(*one_step.table, one_step.key, one_step.value);
    const TemporaryFolder folder;
    const fs::path input = written(std::move(file), settings, folder);
    const fs::path results = folder.path() / "results";
    std::vector<RunMetrics> rows;
    for (const StabilityRun& run :
         run_stability(read_stability_study(input, {}), results, *make_threads(1), {}))
      rows.push_back(run.row);
    return text_of(rows) + tables_of(results) + members_of(results / "stability.json", {"title", "axis"});
  };
  const KeyCase::Setting values{&engine_keys, "parameters", "{ erp = [0.1, 0.2], cfm = [1e-9, 1e-8] }"};
  const std::vector<KeyCase> cases{
      {&stability_keys, "study", ""},
      {&stability_keys, "title", "\"Another\""},
      {&stability_keys, "scene", "\"other.toml\""},
      {&stability_keys, "set", "[\"gravity=9.0\"]"},
      {&stability_keys, "rk4", "[1e-2]"},
      {&stability_keys, "repeats", "2"},
      {&stability_keys, "time_limit", "0.2", slow},
      {&axis_keys, "name", "\"another\""},
      {&axis_keys, "values", "[3.0, 4.0]"},
      {&axis_keys, "set", "{ \"blocks.1.height\" = [1.0, 3.0] }"},
      {&axis_keys, "parameter", "\"cfm\"", {values}},
  };
  expect_keys_have_effects(stability_tables, cases, outcome);
}

TEST(KeyEffects, OfImpactLawStudies) {
  if (engines_called("ode").empty()) GTEST_SKIP() << "this build has no ODE";
  const auto outcome = [](const Settings& settings) {
    const bool asked = settings.back().key == "least_clearness";
    KeyFile file(asked ? std::vector<const KeyTable*>{&impact_law_keys, &engine_keys}
                       : std::vector<const KeyTable*>{&impact_law_keys});
    file.set(impact_law_keys, "samples", "20").set(impact_law_keys, "cells", "2");
    if (asked) file.set(*one_step.table, one_step.key, one_step.value);
    const TemporaryFolder folder;
    const ImpactLawStudy study = read_impact_law_study(written(std::move(file), settings, folder));
    const fs::path results = folder.path() / "results";
    write_results(study, run_study(study), results, "");
    return tables_of(results) + members_of(results / "impact-laws.json", {"title"});
  };
  const std::vector<KeyCase> cases{
      {&impact_law_keys, "study", ""},
      {&impact_law_keys, "title", "\"Another\""},
      {&impact_law_keys, "seed", "2"},
      {&impact_law_keys, "samples", "30"},
      {&impact_law_keys, "cells", "3"},
      {&impact_law_keys, "blocks", "[2]"},
      {&impact_law_keys, "aspect_ratio", "[0.5, 4.0]"},
      {&impact_law_keys, "mass_ratio", "[0.1, 10.0]"},
      {&impact_law_keys, "base_aspect_ratio", "[0.5, 4.0]"},
      {&impact_law_keys, "width_ratio", "[0.5, 1.0]"},
      {&impact_law_keys, "largest_angle", "0.2"},
      {&impact_law_keys, "speed", "[0.1, 0.2]"},
      {&impact_law_keys, "least_clearness", "0.5"},
  };
  expect_keys_have_effects(impact_law_tables, cases, outcome);
}

TEST(KeyEffects, OfEnsembles) {
  // More directions, beside which groups and summaries matter.
  static const KeyTable second = vary_keys, third = vary_keys;
  const auto outcome = [](const Settings& settings) {
    std::vector<const KeyTable*> tables{&ensemble_keys, &vary_keys};
    for (const auto& [table, key, value] : settings)
      if (std::find(tables.begin(), tables.end(), table) == tables.end()) tables.push_back(table);
    const KeyTable* own = settings.back().table;
    const bool nested = own == &range_keys || own == &normal_keys || own == &lognormal_keys;
    KeyFile file(tables);
    if (nested) file.leave_out(vary_keys, "values");
    const TemporaryFolder folder;
    MotionLibrary library;
    const Ensemble ensemble = read_ensemble(written(std::move(file), settings, folder), {}, library);
    const fs::path results = folder.path() / "results";
    sweep(ensemble, library, *make_threads(1),
          {results, "", [](std::size_t, std::size_t, std::size_t) {}, [] { return false; }});
    return tables_of(results) + members_of(results / "sweep.json", {"title"});
  };
  const KeyCase::Setting many{&ensemble_keys, "samples", "4"};
  const KeyCase::Setting seed{&ensemble_keys, "seed", "1"};
  const KeyCase::Setting drawn{&vary_keys, "uniform", "[0.1, 0.2]"};
  const auto other = [](const char* key, const char* value) { return KeyCase::Setting{&second, key, value}; };
  const Settings directions{other("key", "\"gravity\""),
                            other("values", "[9.0, 10.0]"),
                            {&third, "key", "\"ground.horizontal.period\""},
                            {&third, "values", "[0.2, 0.6]"}};
  Settings with_intensity = directions;
  with_intensity.push_back({&summary_keys, "intensity", "\"gravity\""});
  const std::vector<KeyCase> cases{
      {&ensemble_keys, "title", "\"Another\""},
      {&ensemble_keys, "scene", "\"other.toml\""},
      {&ensemble_keys, "samples", "3", {drawn, seed}},
      {&ensemble_keys, "seed", "2", {drawn, many}},
      {&ensemble_keys, "sampling", "\"latin hypercube\"", {drawn, many, seed}},
      {&ensemble_keys, "tolerance", "1e-3"},
      {&ensemble_keys, "demands", "\"kept\""},
      {&vary_keys, "key", "\"gravity\""},
      {&vary_keys,
       "group",
       "\"b\"",
       {other("key", "\"gravity\""), other("values", "[9.0, 10.0]"), other("group", "\"a\"")}},
      {&vary_keys, "values", "[0.4]"},
      {&vary_keys, "range", "{ from = 0.5, to = 1.0, count = 2 }"},
      {&vary_keys, "one_of", "[0.4, 0.5]", {many, seed}},
      {&vary_keys, "uniform", "[0.1, 0.2]", {many, seed}},
      {&vary_keys, "normal", "{ mean = 0.5, deviation = 0.01 }", {many, seed}},
      {&vary_keys, "lognormal", "{ median = 0.5, beta = 0.1 }", {many, seed}},
      {&range_keys, "from", "0.4"},
      {&range_keys, "to", "0.9"},
      {&range_keys, "count", "2"},
      {&range_keys, "spacing", "\"log\""},
      {&normal_keys, "mean", "0.5", {many, seed}},
      {&normal_keys, "deviation", "0.01", {many, seed}},
      {&lognormal_keys, "median", "0.5", {many, seed}},
      {&lognormal_keys, "beta", "0.1", {many, seed}},
      {&summary_keys, "intensity", "\"gravity\"", directions},
      {&summary_keys, "period", "\"ground.horizontal.period\"", with_intensity},
      {&summary_keys, "friction", "\"ground.horizontal.period\"", with_intensity},
      {&summary_keys, "indices", "[\"peak_1\"]", {drawn, many, seed}},
  };
  expect_keys_have_effects(ensemble_tables, cases, outcome);
}

}  // namespace
}  // namespace rockstack
