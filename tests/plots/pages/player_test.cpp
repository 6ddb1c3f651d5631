#include "plots/pages/sections.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

Json data_of_player(const Comparison& comparison) {
  const std::string part = player_section(comparison, 0);
  const auto begin = part.find('{', part.find("application/json"));
  return Json::parse(part.substr(begin, part.find("</script>", begin) - begin));
}

/// What the player's script is given of a made-up motion whose blocks slip, fly and land under a law.
Json data_under(Law law) {
  const std::filesystem::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.engines = {}, .slides = true, .law = law});
  return data_of_player(read_comparison(folder));
}

std::vector<std::string> words(const Json& data) {
  std::vector<std::string> kinds;
  for (const Json& stop : data["events"]["stops"]) kinds.push_back(stop[5]);
  return kinds;
}

TEST(PlayerData, HasFrictionConesAndEveryEventInWordsUnderEachLawThatSlips) {
  const Json rigid = data_under(Law::unilateral);
  const Json soft = data_under(Law::compliant);
  EXPECT_EQ(rigid["friction"], Json({0.5, 0.5}));
  EXPECT_EQ(soft["friction"], Json({0.5, 0.5}));
  EXPECT_EQ(words(rigid),
            (std::vector<std::string>{"slip", "lift-off", "impact", "stick", "corner", "fall"}));
  EXPECT_EQ(words(soft), (std::vector<std::string>{"slip", "part", "touch", "stick", "corner", "fall"}));
}

// A block rests until 0.3 s and leans by up to 5 mrad then.
TEST(PlayerData, OfOneMotionBeginsWithItAndEnlargesItsAngles) {
  const std::filesystem::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.blocks = 1, .engines = {}});
  Comparison comparison = read_comparison(folder);
  EXPECT_FALSE(data_of_player(comparison).contains("start"));
  comparison.scenes.front().alone = true;
  comparison.runs.front().files = nullptr;
  std::ofstream(comparison.runs.front().folder / "history.csv")
      << "time,theta_1,omega_1,pattern\n0,0,0,C\n0.1,0,0,C\n0.2,1e-6,0,C\n0.3,-1e-3,0,L\n0.4,-5e-3,0,L\n0.5,0,0,C\n";
  const Json start = data_of_player(comparison).at("start");
  EXPECT_EQ(start.at("time"), 0.2);
  EXPECT_NEAR(start.at("gain").get<double>(), 30, 1e-9);
}

}  // namespace
}  // namespace rockstack::plots
