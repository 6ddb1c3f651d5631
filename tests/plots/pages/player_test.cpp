#include "plots/pages/sections.hpp"

#include <gtest/gtest.h>

#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

/// What the player's script is given of a made-up motion whose blocks slip, fly and land under a law.
Json data_under(Law law) {
  const std::filesystem::path folder = testing::fresh_folder();
  testing::write_sample(folder, {.engines = {}, .slides = true, .law = law});
  const Comparison comparison = read_comparison(folder);
  const std::string part = player_section(comparison, 0);
  const auto begin = part.find('{', part.find("application/json"));
  return Json::parse(part.substr(begin, part.find("</script>", begin) - begin));
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

}  // namespace
}  // namespace rockstack::plots
