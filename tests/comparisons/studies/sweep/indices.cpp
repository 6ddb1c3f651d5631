#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/latin_hypercube.hpp"
#include "tests/comparisons/studies/sweep/sweep_folder.hpp"

namespace rockstack {
namespace {

/// A block that is let go at an angle, on ground at rest: it topples where that is beyond its slenderness
/// atan(0.2/1), whatever its mass. Heights, if any, are drawn too.
std::string let_go(const std::string& more, const std::string& head = "samples = 300\nseed = 7\n") {
  return head + R"(title = "A block that is let go"
demands = "none"
[scene]
duration = 5
[[scene.blocks]]
width = 0.2
height = 1
mass = 1000
[scene.initial]
angles = [0.1]
[[vary]]
key = "initial.angles.1"
uniform = [0.15, 0.25]
[[vary]]
key = "blocks.1.mass"
lognormal = {median = 1000, beta = 0.3}
)" + more;
}

const std::string two_outcomes = "[summary]\nindices = [\"toppled\", \"peak_ratio\"]\n";

/// The lines of indices.csv of an outcome, by their keys.
std::map<std::string, std::map<std::string, double>> indices_in(const std::filesystem::path& folder,
                                                                const std::string& outcome) {
  std::map<std::string, std::map<std::string, double>> found;
  for (CsvLine line(folder / "indices.csv"); line.next();)
    if (line.text("outcome") == outcome)
      for (const char* name : {"first", "first_lower", "first_upper", "total", "total_lower", "total_upper",
                               "deviation", "samples", "left_out"})
        found[line.text("key")][name] = line.value(name);
  return found;
}

/// Twice as far as bounds of 95 % reach estimates are off once in 10,000 times.
void expect_one(std::map<std::string, double>& found, const std::string& index) {
  EXPECT_NEAR(found[index], 1, found[index + "_upper"] - found[index + "_lower"]);
  EXPECT_NEAR(found[index], 1, 0.2);
}

TEST(Indices, ASampleIsARowOfSaltellisDesign) {
  const Ensemble ensemble = ensemble_from(let_go(two_outcomes));
  ASSERT_EQ(sample_size(ensemble), 4u);
  ASSERT_EQ(run_count(ensemble), 1200u);
  std::set<double> angles;
  for (std::size_t first = 0; first < 1200; first += 4) {
    std::vector<std::vector<Value>> runs;
    for (std::size_t run = first; run < first + 4; ++run) runs.push_back(values_of(ensemble, run));
    const auto text = [&](std::size_t run, std::size_t input) { return runs[run][input].text; };
    EXPECT_EQ(text(2, 0), text(1, 0));
    EXPECT_EQ(text(2, 1), text(0, 1));
    EXPECT_EQ(text(3, 0), text(0, 0));
    EXPECT_EQ(text(3, 1), text(1, 1));
    for (const std::size_t run : {0U, 1U}) angles.insert(runs[run][0].node.number);
  }
  EXPECT_EQ(angles.size(), 600u) << "A and B are drawn independently";
  EXPECT_EQ(matrix_of(ensemble, 4), "A");
  EXPECT_EQ(matrix_of(ensemble, 9), "B");
  EXPECT_EQ(matrix_of(ensemble, 3), "blocks.1.mass");
}

// A's draws are those of the same ensemble without indices, so that more runs are no other answer.
TEST(Indices, TheDrawsOfAAreThoseWithoutIndices) {
  const Ensemble plain = ensemble_from(let_go("")), design = ensemble_from(let_go(two_outcomes));
  for (std::size_t sample = 0; sample < 300; ++sample)
    for (std::size_t v = 0; v < 2; ++v)
      EXPECT_EQ(values_of(plain, sample)[v].text, values_of(design, 4 * sample)[v].text);
}

TEST(Indices, AnInputThatAloneDecidesHasIndicesOfOne) {
  const TemporaryFolder folder;
  const SweepResult result = sweep_into(folder.path(), ensemble_from(let_go(two_outcomes)));
  auto toppled = indices_in(folder.path(), "toppled");
  ASSERT_EQ(toppled.size(), 2u);
  EXPECT_EQ(toppled["blocks.1.mass"]["total"], 0);
  EXPECT_EQ(toppled["blocks.1.mass"]["total_upper"], 0);
  auto& angle = toppled["initial.angles.1"];
  for (const std::string index : {"first", "total"}) expect_one(angle, index);
  EXPECT_EQ(angle["samples"], 300);
  EXPECT_EQ(angle["left_out"], 0);
  // A share p of topplings deviates by √(p (1 − p)), with p known to 600 draws.
  const double share = (0.25 - std::atan(0.2)) / 0.1;
  EXPECT_NEAR(angle["deviation"], std::sqrt(share * (1 - share)), 0.03);
  ASSERT_EQ(result.headline.size(), 3u);
  EXPECT_EQ(
      result.headline[1].rfind("initial.angles.1 decides most over toppled: its total Sobol index is ", 0),
      0U)
      << result.headline[1];
}

// Whatever stands is let go at its largest angle: peak_ratio is angle over slenderness, linear in what is
// drawn.
TEST(Indices, OfAnOutcomeThatIsLinearInTheInputsAreItsShares) {
  const TemporaryFolder folder;
  const std::string text = let_go(two_outcomes);
  sweep_into(folder.path(), ensemble_from(std::string(text).replace(text.find("0.25]"), 5, "0.17]")));
  auto peaks = indices_in(folder.path(), "peak_ratio");
  EXPECT_NEAR(peaks["initial.angles.1"]["deviation"], 0.02 / std::sqrt(12.0) / std::atan(0.2), 2e-3);
  expect_one(peaks["initial.angles.1"], "total");
  auto toppled = indices_in(folder.path(), "toppled");
  EXPECT_TRUE(std::isnan(toppled["initial.angles.1"]["total"])) << "nothing topples";
}

TEST(Indices, ALatinHypercubeHasOneValueInEachPartOfAAndOfB) {
  const Ensemble ensemble =
      ensemble_from(let_go(two_outcomes, "samples = 50\nseed = 3\nsampling = \"latin hypercube\"\n"));
  for (const std::size_t matrix : {0U, 1U}) {
    std::set<double> angles, masses;
    for (std::size_t sample = 0; sample < 50; ++sample) {
      const std::vector<Value> values = values_of(ensemble, 4 * sample + matrix);
      angles.insert(std::floor((values[0].node.number - 0.15) / 0.1 * 50));
      const double deviations = std::log(values[1].node.number / 1000) / 0.3;
      masses.insert(std::floor(50 * std::erfc(-deviations / std::sqrt(2.0)) / 2));
    }
    EXPECT_EQ(angles.size(), 50u);
    EXPECT_EQ(masses.size(), 50u);
  }
}

TEST(Indices, AreTheSameBytesOnAnyNumberOfThreads) {
  const Ensemble ensemble = ensemble_from(let_go(two_outcomes));
  const TemporaryFolder one, three;
  sweep_into(one.path(), ensemble);
  sweep_into(three.path(), ensemble, {.threads = 3});
  for (const char* name : {"runs.csv", "indices.csv", "sweep.json"})
    EXPECT_EQ(bytes_in(one.path() / name), bytes_in(three.path() / name)) << name;
}

/// Over three amplitudes of a sine, one of two heights and a drawn period.
std::string over_intensities(const std::string& summary) {
  return "samples = 20\nseed = 4\n" + ensemble_of_one_block(R"([[vary]]
key = "ground.horizontal.amplitude"
values = [2.5, 5, 10]
[[vary]]
key = "blocks.1.height"
one_of = [0.9, 1.1]
[[vary]]
key = "ground.horizontal.period"
uniform = [0.4, 0.8]
)") + summary;
}

TEST(Indices, StandBesideTheFragilityCurveAtEachIntensity) {
  const TemporaryFolder folder;
  sweep_into(folder.path(),
             ensemble_from(over_intensities(
                 "[summary]\nintensity = \"ground.horizontal.amplitude\"\nindices = [\"peak_ratio\"]\n")));
  const auto indices = read_columns(folder.path() / "indices.csv", {"intensity", "samples"});
  EXPECT_EQ(indices[0], (std::vector<double>{2.5, 2.5, 5, 5, 10, 10}));
  EXPECT_EQ(indices[1], std::vector<double>(6, 20));
  // Runs that share inputs are no more evidence: A and B alone are counted.
  EXPECT_EQ(read_columns(folder.path() / "fragility.csv", {"runs"})[0], std::vector<double>(3, 40));
  std::map<double, std::size_t> heights;
  for (CsvLine line(folder.path() / "runs.csv"); line.next();) ++heights[line.value("blocks.1.height")];
  ASSERT_EQ(heights.size(), 2u) << "one of two";
  EXPECT_GT(heights[0.9], 60u);
  EXPECT_GT(heights[1.1], 60u);
}

TEST(Indices, RunsThatFailTakeTheirSampleWithThem) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "runs.csv")
      << "run,x,matrix,peak_1,status,toppled\n0,1,A,1,done,0\n1,2,B,1,done,2\n"
         "2,2,x,1,done,1\n3,1,A,1,done,0\n4,-2,B,,failed,\n5,-2,x,,failed,\n";
  SummaryKeys keys;
  keys.indices = {"toppled"};
  const auto indices = input_indices(folder.path(), keys);
  ASSERT_EQ(indices.size(), 1u);
  EXPECT_EQ(indices[0].samples, 1u);
  EXPECT_EQ(indices[0].left_out, 1u);
  EXPECT_EQ(indices[0].deviation, 0.5) << "a block's number counts as one";
}

TEST(Indices, ErrorsSayWhatIsAllowed) {
  const std::string grid = "[[vary]]\nkey = \"gravity\"\nvalues = [9, 10]\n";
  EXPECT_EQ(
      ensemble_error(let_go("[summary]\nindices = [\"onset\"]\n"))
          .rfind("ensemble.toml:20: summary.indices.1 = \"onset\": must be \"peak_1\" or \"peak_ratio\" or ",
                 0),
      0U);
  EXPECT_EQ(ensemble_error(let_go("[summary]\nindices = [\"slip\", \"slip\"]\n")),
            "ensemble.toml:20: summary.indices.2 = \"slip\": must be named once");
  EXPECT_EQ(ensemble_error(let_go(two_outcomes, "samples = 1\nseed = 7\n")),
            "ensemble.toml:20: summary.indices = an array of 2: must be left out where samples is 1");
  EXPECT_EQ(
      ensemble_error(let_go(grid + two_outcomes)),
      "ensemble.toml:23: summary.indices = an array of 2: must be left out where the grid has another direction than "
      "intensity, as ensemble.toml:19 does: one_of draws from such values");
  EXPECT_EQ(ensemble_error(let_go("[summary]\nperiod = \"duration\"\n")),
            "ensemble.toml:20: summary.period = \"duration\": must be a key that is varied over numbers");
  EXPECT_EQ(ensemble_error("sampling = \"random\"\n" + ensemble_of_one_block(grid)),
            "ensemble.toml:1: sampling = \"random\": must be left out where no values are drawn");
  EXPECT_EQ(ensemble_error(ensemble_of_one_block(grid + two_outcomes)),
            "ensemble.toml:16: summary.indices = an array of 2: must be left out where no values are drawn");
  EXPECT_EQ(ensemble_error(let_go("", "samples = 9\nseed = 7\nsampling = \"sobol\"\n")),
            "ensemble.toml:3: sampling = \"sobol\": must be \"random\" or \"latin hypercube\"");
  EXPECT_EQ(ensemble_error(let_go("[[vary]]\nkey = \"blocks.1.height\"\none_of = [1.0, -1.0]\n")),
            "ensemble.toml:21: blocks.1.height = -1: must be a number from 1e-20 to 1e+20");
}

}  // namespace
}  // namespace rockstack
