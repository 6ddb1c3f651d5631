#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <stdexcept>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/suite.hpp"
#include "tests/analytic/scene/ground/records/mutations.hpp"
#include "tests/analytic/scene/input/scene_mutations.hpp"

namespace rockstack {
namespace {

const std::string suite_text = R"(title = "Fuzz"
scenes = ["scene.toml"]
variants = ["linear", "paper"]
tolerance = 0.01
repeats = 2
results = ["angles", "impacts"]
set = ["gravity=9.8"]
time_limit = 10
memory_limit = 512
[perturbations]
runs = 3
size = 1e-6
seed = 7
[[engines]]
name = "ode"
settings = ["default", "tuned"]
dt = [1e-2, 1e-3]
parameters = { cfm = [1e-9, 1e-7] }
)";

const std::string ensemble_text = R"(title = "Fuzz"
scene = "scene.toml"
samples = 4
seed = 1
tolerance = 1e-9
[[vary]]
key = "blocks.1.height"
values = [2.0, 2.5]
[[vary]]
key = ["initial.angles.1"]
range = { from = 0.01, to = 0.1, count = 3, spacing = "log" }
[[vary]]
key = "gravity"
normal = { mean = 9.8, deviation = 0.1 }
[summary]
intensity = "initial.angles.1"
)";

/// Reads mutated texts; each is what it should be, or refused in one line that names a file of the folder.
void expect_read_or_refused(const TemporaryFolder& folder, const std::string& text,
                            const std::function<void(const std::filesystem::path&)>& read) {
  std::mt19937_64 random(1983);
  int refused = 0;
  constexpr int rounds = 1000;
  for (int round = 0; round < rounds; ++round) {
    const std::string wounded = mutated(text, random);
    try {
      read(folder.write("wounded.toml", wounded));
    } catch (const InputError& error) {
      const std::string line = error.what();
      EXPECT_TRUE(line.starts_with(folder.path().string()) || line.starts_with("--set ")) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      ++refused;
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << wounded;
    }
  }
  EXPECT_GT(refused, rounds / 4) << "mutations must do harm";
}

TEST(SuiteMutations, GiveASuiteOrAnInputErrorAndNothingElse) {
  const TemporaryFolder folder;
  folder.write("scene.toml", scenes_with_every_key().front());
  ASSERT_NO_THROW(read_suite(folder.write("suite.toml", suite_text), {}));
  expect_read_or_refused(folder, suite_text, [](const auto& file) { read_suite(file, {}); });
}

TEST(EnsembleMutations, GiveAnEnsembleOrAnInputErrorAndNothingElse) {
  const TemporaryFolder folder;
  folder.write("scene.toml", scenes_with_every_key().front());
  MotionLibrary library;
  ASSERT_NO_THROW(read_ensemble(folder.write("ensemble.toml", ensemble_text), {}, library));
  expect_read_or_refused(folder, ensemble_text, [&](const auto& file) { read_ensemble(file, {}, library); });
}

}  // namespace
}  // namespace rockstack
