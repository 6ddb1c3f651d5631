#include "comparisons/suites/suite.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/stability/study.hpp"
#include "tests/comparisons/block_text.hpp"
#include "tests/native_engines.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// The error of a suite of that text beside "block.toml", without the folder; empty where there is none.
std::string suite_error(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  try {
    read_suite(folder.write("suite.toml", text), {});
  } catch (const InputError& error) {
    std::string line = error.what();
    const std::string before = folder.path().string() + "/";
    if (line.starts_with(before)) line.erase(0, before.size());
    return line;
  }
  return {};
}

TEST(Suites, ShippedOnesAreReadable) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROCKSTACK_SUITES)) {
    if (entry.path().extension() != ".toml") continue;
    const InputKind kind = kind_of(entry.path());
    if (kind == InputKind::stability_study) {
      EXPECT_NO_THROW(read_stability_study(entry.path(), {})) << entry.path();
      continue;
    }
    if (kind == InputKind::impact_law_study) {
      EXPECT_NO_THROW(read_impact_law_study(entry.path())) << entry.path();
      continue;
    }
    EXPECT_EQ(kind, InputKind::suite);
    const Suite suite = read_suite(entry.path(), {});
    EXPECT_FALSE(suite.scenes.empty()) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 0);
}

TEST(Suites, ErrorsNameLineKeyAndWhatIsAllowed) {
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  EXPECT_EQ(suite_error(head), "");
  EXPECT_TRUE(
      suite_error(head + "tolerance = 0\n").starts_with("suite.toml:3: tolerance = 0: must be a number > 0"));
  EXPECT_TRUE(suite_error(head + "repeats = 1.5\n")
                  .starts_with("suite.toml:3: repeats = 1.5: must be a whole number"));
  EXPECT_TRUE(suite_error(head + "colour = 1\n").starts_with("suite.toml:3: colour"));
  EXPECT_TRUE(suite_error(head + "[[engines]]\nname = \"newton\"\n")
                  .starts_with("suite.toml:4: engine = newton: must be one of"));
  EXPECT_TRUE(suite_error(head + "[draws]\nruns = 1\nsteps = 0.1\n")
                  .starts_with("suite.toml:5: draws.steps = 0.1: must be left out where `runs` is 1"));
  EXPECT_EQ(suite_error(head + "set = [\"gravity=9\", \"blocks.1.colour=1\"]\n").substr(0, 24),
            "suite.toml:3: blocks.1.c");
  EXPECT_EQ(suite_error(head + "vary = { gravity = [-1] }\n").substr(0, 26), "suite.toml:3: gravity = -1");
  EXPECT_TRUE(suite_error(head + "time_limit = 1\n")
                  .starts_with("suite.toml:3: time_limit = 1: must be left out where"));
  EXPECT_TRUE(suite_error(head + "results = []\n")
                  .starts_with("suite.toml:3: results = an array of 0: must be an array of at least"));
  EXPECT_TRUE(suite_error(head + "results = [\"angles\", \"angles\"]\n")
                  .starts_with("suite.toml:3: results.2 = \"angles\": must be named once"));
  EXPECT_TRUE(suite_error("title = \"a\"\nscenes = []\n").starts_with("suite.toml:2: scenes"));
}

TEST(Suites, VariantsOfFrictionAreOfLawUnilateral) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  const Suite suite =
      read_suite(folder.write("suite.toml", head + "variants = [\"friction=0\", \"friction=0.5\"]\n"), {});
  ASSERT_EQ(suite.variants.size(), 2U);
  EXPECT_EQ(suite.variants[1].name(), "friction=0.5");
  const Scene changed = suite.variants[1].apply(suite.scenes.front().scene);
  EXPECT_EQ(changed.law, Law::unilateral);
  EXPECT_EQ(friction_of(changed), std::vector<double>{0.5});
  for (const char* wrong : {"friction=", "friction=-1", "friction=1e4", "friction=1x", "friction=nan"})
    EXPECT_TRUE(
        suite_error(head + "variants = [\"" + wrong + "\"]\n")
            .starts_with(std::string("suite.toml:3: variants.1 = \"") + wrong + "\": must be friction="))
        << wrong;
  EXPECT_NE(suite_error(head + "variants = [\"friction=0.5\", \"friction=0.50\"]\n"), "");
}

// An engine of two tables is named once; what nobody asks for is not.
TEST(Suites, NameTheEnginesTheyAskForThatThisBuildLeavesOut) {
  const std::vector<std::string> left_out = engines_left_out();
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  std::string text = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  for (const std::string& name : left_out)
    for (const char* step : {"1e-2", "1e-3"})
      text += "[[engines]]\nname = \"" + name + "\"\ndt = [" + step + "]\n";
  const Suite asked = read_suite(folder.write("suite.toml", text), {});
  EXPECT_EQ(asked.left_out, left_out);
  EXPECT_TRUE(asked.series.empty());
  const Suite other =
      read_suite(folder.write("other.toml", "title = \"a\"\nscenes = [\"block.toml\"]\n"), {});
  EXPECT_TRUE(other.left_out.empty());
  std::vector<std::string> sorted = left_out;
  std::ranges::sort(sorted);
  EXPECT_EQ(engines_left_out({asked, other, asked}), sorted);
}

std::vector<std::string> names_of(const std::vector<EngineSeries>& series) {
  return mapped(series, [](const EngineSeries& one) { return one.engine->full_name() + one.settings; });
}

TEST(Suites, AStarStandsForAllEnginesButThoseThatAreExcepted) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const WorkerEngine& some = native_engines().front();
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  const auto named = [&](const std::string& tables) {
    return names_of(read_suite(folder.write("suite.toml", head + tables), {}).series);
  };
  std::string each, most;
  for (const WorkerEngine& engine : engines()) {
    const std::string table = "[[engines]]\nname = \"" + engine.full_name() + "\"\n";
    each += table;
    if (engine.name != some.name) most += table;
  }
  EXPECT_EQ(named("[[engines]]\nname = \"*\"\n"), named(each));
  EXPECT_EQ(named("[[engines]]\nname = \"*\"\nexcept = [\"" + some.name + "\"]\n"),
            most.empty() ? std::vector<std::string>{} : named(most));
  const std::vector<std::string> but_one =
      named("[[engines]]\nname = \"*\"\nexcept = [\"" + some.full_name() + "\"]\n");
  EXPECT_EQ(but_one.size() + 2, 2 * engines().size());
  EXPECT_EQ(std::ranges::find(but_one, some.full_name() + "tuned"), but_one.end());
}

TEST(Suites, WhatIsOfOneEngineIsRefusedBesideAStar) {
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n[[engines]]\n";
  EXPECT_EQ(
      suite_error(head + "name = \"*\"\nexcept = [\"newton\"]\n"),
      "suite.toml:5: engines.1.except.1 = \"newton\": must be an engine, with or without its solver, of `rockstack "
      "list engines`");
  EXPECT_TRUE(suite_error(head + "name = \"*\"\nparameters = { erp = 0.1 }\n")
                  .starts_with("suite.toml:5: engines.1.parameters"));
  EXPECT_TRUE(suite_error(head + "name = \"*\"\nworker = \"./a.py\"\n")
                  .starts_with(
                      "suite.toml:5: engines.1.worker = \"./a.py\": must be left out beside `name` = \"*\""));
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const std::string engine = native_engines().front().get().name;
  EXPECT_TRUE(suite_error(head + "name = \"" + engine + "\"\nexcept = [\"" + engine + "\"]\n")
                  .starts_with("suite.toml:5: engines.1.except = "));
}

TEST(Suites, OverridesReachEveryScene) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const auto file = folder.write("suite.toml", "title = \"a\"\nscenes = [\"block.toml\"]\n");
  EXPECT_EQ(read_suite(file, {"gravity=1.62"}).scenes.at(0).scene.gravity, 1.62);
}

TEST(Suites, ScenesVaryInEveryCombination) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n[vary]\n";
  const auto file =
      folder.write("suite.toml", head + "gravity = [1, 9.81]\n\"contact.friction\" = [0, 0.5, 1000]\n");
  const std::vector<NamedScene> scenes = read_suite(file, {}).scenes;
  ASSERT_EQ(scenes.size(), 6U);
  EXPECT_EQ(scenes[0].name, "block-friction-0-gravity-1");
  EXPECT_EQ(scenes[4].name, "block-friction-0.5-gravity-9.81");
  EXPECT_TRUE(scenes[4].scene.title.ends_with(", friction 0.5, gravity 9.81"));
  EXPECT_EQ(scenes[4].scene.gravity, 9.81);
  EXPECT_EQ(scenes[4].scene.friction, std::vector<double>{0.5});
  EXPECT_TRUE(
      suite_error(head + "gravity = 1\n").starts_with("suite.toml:4: vary.gravity = 1: must be an array"));
  EXPECT_TRUE(suite_error(head + "mood = [1]\n").starts_with("suite.toml:4: mood: unknown key"));
}

TEST(Suites, ParametersAreChangedOneSeriesEachCombination) {
  if (native_engines().empty()) GTEST_SKIP() << "this build has no engine";
  const WorkerEngine& engine = native_engines().front();
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n[[engines]]\nname = \"" + engine.name +
                           "\"\nsettings = [\"tuned\"]\n[engines.parameters]\n";
  const std::string name = engine.settings.front().name;
  const Suite suite = read_suite(folder.write("suite.toml", head + name + " = [2, 3]\n"), {});
  ASSERT_EQ(suite.series.size(), 2U);
  Parameters expected = engine.tuned_parameters();
  expected[name] = 3;
  EXPECT_EQ(suite.series[1].parameters, expected);
  EXPECT_EQ(suite.series[1].settings, "tuned+" + name + "=3");
  EXPECT_TRUE(suite_error(head + "wishes = 1\n")
                  .starts_with("suite.toml:7: " + engine.name + ": wishes: no such parameter"));
  EXPECT_TRUE(suite_error(head + name + " = -1\n")
                  .starts_with("suite.toml:7: " + engine.name + ": " + name + " = -1: must be"));
}

TEST(Suites, PerturbationsAreRead) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  EXPECT_EQ(read_suite(folder.write("suite.toml", head), {}).perturbations.runs, 0);
  const auto file = folder.write("suite.toml", head + "[perturbations]\nruns = 50\nsize = 1e-4\nseed = 7\n");
  const Perturbations around = read_suite(file, {}).perturbations;
  EXPECT_EQ(around.runs, 50);
  EXPECT_EQ(around.size, 1e-4);
  EXPECT_EQ(around.seed, 7U);
  EXPECT_TRUE(suite_error(head + "[perturbations]\nruns = 1\n")
                  .starts_with("suite.toml:4: perturbations.runs = 1: must be a whole number from 2"));
  EXPECT_TRUE(suite_error(head + "[perturbations]\nruns = 3\nsize = 0.5\n")
                  .starts_with("suite.toml:5: perturbations.size = 0.5: must be"));
}

TEST(Suites, ResultsThatAreAskedForAreRead) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  const ResultSelection all = read_suite(folder.write("suite.toml", head), {}).wanted;
  EXPECT_TRUE(all.angles && all.impacts && all.patterns && all.bodies && all.histories);
  const ResultSelection some =
      read_suite(folder.write("suite.toml", head + "results = [\"impacts\"]\n"), {}).wanted;
  EXPECT_TRUE(some.impacts && !some.angles && !some.patterns && !some.bodies && !some.histories);
  EXPECT_TRUE(suite_error(head + "results = [\"looks\"]\n").starts_with("suite.toml:3: results"));
}

TEST(Suites, ChangesToScenesYieldToThoseOfTheCommandLine) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const auto file = folder.write(
      "suite.toml", "title = \"a\"\nscenes = [\"block.toml\"]\nset = [\"gravity=3\", \"duration=7\"]\n");
  const Scene scene = read_suite(file, {"gravity=1.62"}).scenes.at(0).scene;
  EXPECT_EQ(scene.gravity, 1.62);
  EXPECT_EQ(scene.duration, 7);
}

TEST(Suites, LimitsAreRead) {
  const TemporaryFolder folder;
  folder.write("block.toml", block_text);
  const std::string head = "title = \"a\"\nscenes = [\"block.toml\"]\n";
  const std::string engine = "[[engines]]\nworker = \"" FAULTY_WORKER "\"\n";
  const Suite suite =
      read_suite(folder.write("suite.toml", head + "time_limit = 7.5\nmemory_limit = 512\n" + engine), {});
  EXPECT_EQ(suite.limits.time, 7.5);
  EXPECT_EQ(suite.limits.memory, std::uint64_t{512} << 20);
  EXPECT_TRUE(
      suite_error(head + "memory_limit = 1\n").starts_with("suite.toml:3: memory_limit = 1: must be"));
}

TEST(Suites, ARecordTakesThePlaceOfMotionsBySamplesAtTheirPeak) {
  const TemporaryFolder folder;
  const std::string ground = "[ground.horizontal]\n";
  folder.write("still.toml", block_text);
  folder.write("pulse.toml", block_text + ground + "pulse = \"sine\"\namplitude = 5\nperiod = 0.1\n");
  folder.write("record.toml", block_text + ground + "samples = [0, -6, 0]\ninterval = 0.1\n");
  folder.write("synthetic.toml", block_text + ground + "synthetic = 1\npeak = 4\nduration = 2\n");
  const auto record = folder.write("new.csv", "# units: m/s2\n# dt = 0.02\n1\n-2\n0.5\n");
  const auto suite_of = [&](const std::string& scenes) {
    return read_suite(folder.write("suite.toml", "title = \"s\"\nscenes = [" + scenes + "]\n"), {});
  };
  std::vector<Suite> suites{suite_of(R"("still.toml", "pulse.toml", "record.toml", "synthetic.toml")")};
  replace_motion(suites, record);
  const auto motion = [&](std::size_t scene) { return suites[0].scenes[scene].scene.horizontal; };
  EXPECT_TRUE(motion(0).empty());
  EXPECT_TRUE(motion(1).pulse);
  EXPECT_EQ(motion(2).samples, (std::vector<double>{3, -6, 1.5}));
  EXPECT_EQ(motion(3).samples, (std::vector<double>{2, -4, 1}));
  EXPECT_EQ(motion(3).interval, 0.02);
  EXPECT_FALSE(motion(3).made_up);
  EXPECT_EQ(motion(3).source, "new.csv (text columns, in 1 m/s², steps of 0.02 s by line 2), scaled by 2");
  const double still = suites[0].scenes[0].scene.duration;
  std::string longer = "# units: m/s2\n# dt = 0.5\n-2\n";
  for (int k = 1; k <= 80; ++k) longer += "1\n";
  replace_motion(suites, folder.write("long.csv", longer));
  EXPECT_EQ(suites[0].scenes[2].scene.duration, 40) << "it lasts as long as the record";
  EXPECT_EQ(suites[0].scenes[0].scene.duration, still);
  const auto slow = folder.write("slow.csv", "# units: m/s2\n# dt = 0.6\n1\n-2\n");
  EXPECT_THROW(replace_motion(suites, slow), InputError);
  replace_motion(suites, slow, RecordLimits::none);
  EXPECT_EQ(motion(3).interval, 0.6) << "that is meant";
  std::vector<Suite> unshaken{suite_of(R"("still.toml", "pulse.toml")")};
  EXPECT_THROW(replace_motion(unshaken, record), InputError);
}

}  // namespace
}  // namespace rockstack
