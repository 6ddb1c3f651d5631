// Every engine, solver, precision and parameter set beside every law.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <string>
#include <tuple>

#include "engines/conformance/check.hpp"
#include "engines/conformance/known_limits.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack {

void PrintTo(const Check& check, std::ostream* out) {
  *out << check.name;
}

namespace {

struct Judged {
  const Engine* engine;
  std::string settings;
};

void PrintTo(const Judged& setup, std::ostream* out) {
  *out << setup.engine->name() << ":" << setup.engine->solver() << " " << setup.settings;
}

std::vector<Judged> setups() {
  std::vector<Judged> list;
  for (const auto& engine : linked_engines()) {
    for (const char* settings : {"default", "tuned"}) list.push_back({engine.get(), settings});
  }
  return list;
}

std::string words(const std::tuple<Judged, Check>& both) {
  const auto& [setup, check] = both;
  std::string name =
      setup.engine->name() + "_" + setup.engine->solver() + "_" + setup.settings + "_" + check.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
}

class Conformance : public testing::TestWithParam<std::tuple<Judged, Check>> {};

TEST_P(Conformance, Holds) {
  const auto& [setup, check] = GetParam();
  const std::string limit =
      known_limit(setup.engine->name(), setup.engine->solver(), setup.settings, check.name);
  if (!limit.empty()) GTEST_SKIP() << limit;
  const bool tuned = setup.settings == "tuned";
  const Judgement verdict = check.judge(adapter_of(
      *setup.engine, tuned ? setup.engine->tuned_parameters() : setup.engine->default_parameters()));
  RecordProperty("value", std::to_string(verdict.value));
  EXPECT_LE(verdict.value, verdict.limit) << verdict.what;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Conformance);
INSTANTIATE_TEST_SUITE_P(Engines, Conformance,
                         testing::Combine(testing::ValuesIn(setups()), testing::ValuesIn(checks())),
                         [](const auto& both) { return words(both.param); });

}  // namespace
}  // namespace rockstack
