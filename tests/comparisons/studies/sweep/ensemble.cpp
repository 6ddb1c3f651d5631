#include "comparisons/studies/sweep/ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparisons/studies/sweep/sweep_folder.hpp"

namespace rockstack {
namespace {

const std::string periods = "[[vary]]\nkey = \"ground.horizontal.period\"\nvalues = [0.3, 0.4, 0.5]\n";
const std::string three_amplitudes =
    "[[vary]]\nkey = \"ground.horizontal.amplitude\"\nrange = {from = 1, to = 16, count = 5}\n";

std::string texts(const Ensemble& ensemble, std::size_t run) {
  std::string joined;
  for (const Value& value : values_of(ensemble, run)) joined += (joined.empty() ? "" : " ") + value.text;
  return joined;
}

TEST(Ensemble, AGridHasEveryCombinationTheLastTableFastest) {
  const Ensemble ensemble = ensemble_from(ensemble_of_one_block(periods + three_amplitudes));
  ASSERT_EQ(run_count(ensemble), 15u);
  EXPECT_EQ(texts(ensemble, 0), "0.3 1");
  EXPECT_EQ(texts(ensemble, 1), "0.3 4.75");
  EXPECT_EQ(texts(ensemble, 4), "0.3 16");
  EXPECT_EQ(texts(ensemble, 5), "0.4 1");
  EXPECT_EQ(texts(ensemble, 14), "0.5 16");
}

TEST(Ensemble, TablesOfAGroupVaryInStep) {
  const std::string zipped = "[[vary]]\nkey = \"blocks.1.width\"\ngroup = \"size\"\nvalues = [0.2, 0.4]\n" +
                             periods +
                             "[[vary]]\nkey = \"blocks.1.height\"\ngroup = \"size\"\nvalues = [1, 2]\n";
  const Ensemble ensemble = ensemble_from(ensemble_of_one_block(zipped));
  ASSERT_EQ(run_count(ensemble), 6u);
  EXPECT_EQ(texts(ensemble, 2), "0.2 0.5 1");
  EXPECT_EQ(texts(ensemble, 3), "0.4 0.3 2");
}

TEST(Ensemble, LogarithmicRangesHaveEqualRatiosAndTheirEndsExactly) {
  const Ensemble ensemble = ensemble_from(ensemble_of_one_block(
      "[[vary]]\nkey = \"duration\"\nrange = {from = 0.1, to = 1.6, count = 5, spacing = \"log\"}\n"));
  const auto& values = ensemble.variations[0].values;
  EXPECT_EQ(values.front().node.number, 0.1);
  EXPECT_EQ(values.back().node.number, 1.6);
  for (std::size_t i = 1; i < values.size(); ++i) {
    // 16^(1/4) = 2, to a few roundings of the power
    EXPECT_NEAR(values[i].node.number / values[i - 1].node.number, 2, 1e-14);
  }
}

TEST(Ensemble, DrawsDependOnSeedRunAndTableAlone) {
  const std::string drawn =
      "[[vary]]\nkey = \"blocks.1.height\"\nlognormal = {median = 1, beta = 0.1}\n"
      "[[vary]]\nkey = \"duration\"\nuniform = [1, 2]\n";
  const std::string sampled = "samples = 4\nseed = 9\n";
  const Ensemble few = ensemble_from(sampled + ensemble_of_one_block(drawn));
  const Ensemble many = ensemble_from(sampled + ensemble_of_one_block(drawn + periods));
  ASSERT_EQ(run_count(few), 4u);
  ASSERT_EQ(run_count(many), 12u);
  for (const std::size_t run : {3u, 0u, 2u}) {
    EXPECT_EQ(values_of(few, run)[0].text, values_of(many, run)[0].text);
    EXPECT_EQ(values_of(few, run)[1].text, values_of(many, run)[1].text);
  }
  EXPECT_NE(values_of(many, 0)[0].text, values_of(many, 4)[0].text) << "drawn anew at each grid point";
}

TEST(Ensemble, OneTableMaySetSeveralKeys) {
  const Ensemble ensemble = ensemble_from(ensemble_of_one_block(
      "[[vary]]\nkey = [\"blocks.1.width\", \"blocks.1.height\"]\nvalues = [0.5, 2]\n"));
  SceneDocument document = ensemble.base;
  MotionLibrary library;
  set_values(document, ensemble.variations[0], values_of(ensemble, 1)[0]);
  const Scene scene = make_scene(document, library);
  EXPECT_EQ(scene.blocks[0].half_width, 1);
  EXPECT_EQ(scene.blocks[0].half_height, 1);
}

TEST(Ensemble, RefusesToSetWhatItVaries) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("ensemble.toml",
                   "title = \"t\"\n[scene]\nduration = 1\n[[scene.blocks]]\nwidth = 1\nheight = 2\nmass = 1\n"
                   "[[vary]]\nkey = [\"gravity\", \"duration\"]\nvalues = [1, 2]\n");
  MotionLibrary library;
  EXPECT_NO_THROW(read_ensemble(file, {"blocks.1.height=3"}, library));
  for (const std::string set : {"duration=3", "gravity = 3"}) {
    try {
      read_ensemble(file, {set}, library);
      FAIL() << "no error";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(),
                "--set " + set + ": must be a key that is not varied, as " + file.string() + ":8 does");
    }
  }
}

TEST(Ensemble, RecordsAreRelativeToTheEnsembleFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "scenes");
  folder.write("scenes/scene.toml",
               "duration = 1\n[[blocks]]\nwidth = 1\nheight = 2\nmass = 1\n[ground.horizontal]\nscale = 2\n");
  folder.write("motion.txt", "# unit: m/s2\n# interval: 0.5 s\n0\n1\n0\n");
  for (const std::string key :
       {"\"ground.horizontal.record\"", "[\"title\", \"ground.horizontal.record\"]"}) {
    const auto file =
        folder.write("ensemble.toml", "title = \"t\"\nscene = \"scenes/scene.toml\"\n[[vary]]\nkey = " + key +
                                          "\nvalues = [\"motion.txt\"]\n");
    MotionLibrary library;
    try {
      const Ensemble ensemble = read_ensemble(file, {}, library);
      EXPECT_EQ(texts(ensemble, 0), "motion.txt");
    } catch (const InputError& error) {
      FAIL() << error.what();
    }
  }
}

TEST(Ensemble, ErrorsNameFileLineKeyValueAndWhatIsAllowed) {
  const auto error = [](const std::string& variations) {
    return ensemble_error(ensemble_of_one_block(variations));
  };
  const std::string table = "[[vary]]\nkey = \"blocks.1.height\"\n";
  EXPECT_EQ(error(""), "ensemble.toml:1: vary: missing, must be at least one table [[vary]]");
  EXPECT_EQ(error("[[vary]]\nvalues = [1]\n"),
            "ensemble.toml:12: vary.1.key: missing, must be a key of the scene");
  EXPECT_EQ(error(table),
            "ensemble.toml:12: vary.1.values: missing, must be given, or range, one_of, uniform, normal "
            "or lognormal in its place");
  EXPECT_EQ(error(table + "values = [1, -2]\n"),
            "ensemble.toml:14: blocks.1.height = -2: must be a number from 1e-20 to 1e+20");
  EXPECT_EQ(error("[[vary]]\nkey = \"blocks.1.colour\"\nvalues = [1]\n"),
            "ensemble.toml:14: blocks.1.colour: unknown key, must be one of width, height, density, mass, "
            "inertia, center_of_mass");
  EXPECT_EQ(error("[[vary]]\nkey = \"blocks.2.height\"\nvalues = [1]\n"),
            "ensemble.toml:14: blocks.2: there is 1 block, must be 1 to 1");
  EXPECT_EQ(error(table + "values = [1]\n" + table + "values = [2]\n"),
            "ensemble.toml:15: key = blocks.1.height: must be varied only once");
  EXPECT_EQ(error(table + "uniform = [2, 1]\n"),
            "ensemble.toml:14: vary.1.uniform.2 = 1: must be a number above the first, 2");
  EXPECT_EQ(error(table + "range = {from = 1, to = 2, count = 1.5}\n"),
            "ensemble.toml:14: vary.1.range.count = 1.5: must be a whole number from 2 to 1000000");
  EXPECT_EQ(error(table + "uniform = [1, 2]\n"),
            "ensemble.toml:1: samples: missing, must be given where values are drawn");
  EXPECT_EQ(
      error(table + "values = [1]\n[summary]\nintensity = \"blocks.1.width\"\n"),
      "ensemble.toml:16: summary.intensity = \"blocks.1.width\": must be a key that is varied over numbers");
}

}  // namespace
}  // namespace rockstack
