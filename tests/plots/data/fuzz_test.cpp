// Damaged results are refused in one line that names their file; nothing else comes of them.

#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/data/run_files.hpp"
#include "plots/data/selection.hpp"
#include "tests/analytic/scene/ground/records/mutations.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// All that pages and figures take from the results before they draw.
void read_all(const fs::path& folder) {
  const Comparison comparison = read_comparison(folder);
  for (const ComparedScene& scene : comparison.scenes) {
    for (const StepLine& line : step_lines(comparison, scene.name)) line_label(line);
    const RunSelection shown = shown_runs(comparison, scene.name);
    for (const std::vector<Run>& runs : {shown.exact, shown.engines})
      for (const Run& run : runs) {
        EXPECT_EQ(run.folder.parent_path(), folder / "runs");
        read_json(run.folder / "summary.json", facts_of);
        history_of(run);
      }
  }
}

void expect_read_or_refused(const fs::path& folder, const fs::path& file) {
  const std::string whole = testing::bytes_of(file);
  std::mt19937_64 random(1983);
  int refused = 0;
  constexpr int rounds = 300;
  for (int round = 0; round < rounds; ++round) {
    const std::string wounded = mutated(whole, random);
    std::ofstream(file, std::ios::binary) << wounded;
    try {
      read_all(folder);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(folder.string()), 0U) << error.what();
      ++refused;
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << wounded;
    }
  }
  EXPECT_GT(refused, rounds / 20) << file << ": mutations must do harm";
  std::ofstream(file, std::ios::binary) << whole;
}

TEST(ResultsMutations, GiveResultsOrAnInputErrorAndNothingElse) {
  const fs::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.impacts = 2, .steps = {1e-2}});
  ASSERT_NO_THROW(read_all(folder));
  expect_read_or_refused(folder, folder / "comparison.json");
  for (const auto& run : fs::directory_iterator(folder / "runs"))
    for (const char* name : {"summary.json", "history.csv", "events.csv"})
      if (fs::exists(run.path() / name)) expect_read_or_refused(folder, run.path() / name);
}

TEST(ResultsMutations, StacksOfNoBlocksAndOfTooManyAreRefused) {
  const fs::path folder = testing::fresh_folder();
  for (const int blocks : {0, max_blocks + 1}) {
    testing::write_sample(folder, {.impacts = 0});
    auto json = Json::parse(testing::bytes_of(folder / "comparison.json"));
    Json page = Json::parse(json["scenes"][0]["page"].get<std::string>());
    page["blocks"] = std::vector(static_cast<std::size_t>(blocks), page["blocks"][0]);
    json["scenes"][0]["page"] = page.dump();
    std::ofstream(folder / "comparison.json") << json;
    EXPECT_THROW(read_comparison(folder), InputError) << blocks;
  }
}

TEST(ResultsMutations, NamesThatAreNoNamesAreRefused) {
  const fs::path folder = testing::fresh_folder();
  for (const std::string name : {"../../x", "/x", "..", ""}) {
    testing::write_sample(folder, {});
    std::string text = testing::bytes_of(folder / "comparison.json");
    const std::string key = "\"name\": \"sample\"";
    ASSERT_NE(text.find(key), std::string::npos);
    text.replace(text.find(key), key.size(), "\"name\": \"" + name + "\"");
    std::ofstream(folder / "comparison.json") << text;
    EXPECT_THROW(read_comparison(folder), InputError) << name;
  }
}

}  // namespace
}  // namespace rockstack::plots
