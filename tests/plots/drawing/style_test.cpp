#include "plots/drawing/style.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

namespace rockstack::plots {
namespace {

plots::Run run_of(const std::string& engine, const std::string& solver, const std::string& settings) {
  plots::Run run;
  run.engine = engine;
  run.solver = solver;
  run.settings = settings;
  return run;
}

std::vector<plots::Run> shipped_solvers(const std::string& settings) {
  std::vector<plots::Run> runs{run_of("ode", "step", settings),
                               run_of("ode", "quickstep", settings),
                               run_of("box2d", "sequential-impulse", settings),
                               run_of("chipmunk", "sequential-impulse", settings),
                               run_of("siconos", "nsgs", settings),
                               run_of("simbody", "compliant", settings)};
  for (const char* solver : {"dantzig", "pgs"}) runs.push_back(run_of("dart", solver, settings));
  for (const char* solver : {"newton", "cg", "pgs"}) runs.push_back(run_of("mujoco", solver, settings));
  for (const char* engine : {"bullet", "bullet-single"})
    for (const char* solver : {"sequential-impulse", "nncg", "mlcp-dantzig", "mlcp-lemke", "mlcp-pgs"})
      runs.push_back(run_of(engine, solver, settings));
  return runs;
}

/// Two digits of a colour as a share of light (WCAG 2.1, relative luminance).
double light(const std::string& colour, std::size_t at) {
  const double share = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

TEST(Style, ColourAndMarkBelongToOneSeriesAlone) {
  std::set<std::pair<std::string, int>> seen;
  for (const char* settings : {"default", "tuned"})
    for (const plots::Run& run : shipped_solvers(settings)) {
      const Style style = style_of(run);
      EXPECT_TRUE(seen.emplace(style.colour, style.mark).second) << run.solver_name() << ", " << settings;
    }
}

TEST(Style, NeitherTheStepNorTheSceneCounts) {
  plots::Run one = run_of("newton", "dynamics", "tuned+a=1");
  plots::Run other = one;
  other.dt = 1e-3;
  other.scene = "another";
  other.run = "another.run";
  const Style style = style_of(one), same = style_of(other);
  EXPECT_EQ(std::tie(style.colour, style.mark, style.dash), std::tie(same.colour, same.mark, same.dash));
}

// The contrast that words need by WCAG 2.1 is 4.5.
TEST(Style, WordsInAnyColourCanBeReadOnWhite) {
  for (const plots::Run& run : shipped_solvers("tuned")) {
    const std::string colour = style_of(run).colour;
    const double luminance =
        0.2126 * light(colour, 1) + 0.7152 * light(colour, 3) + 0.0722 * light(colour, 5);
    EXPECT_GE(1.05 / (luminance + 0.05), 4.5) << run.solver_name() << " " << colour;
  }
}

TEST(Style, CoefficientsOfFrictionAreToldApartWhateverTheirDigits) {
  std::set<std::string> colours;
  for (const char* friction : {"friction=1", "friction=0.5", "friction=0.3", "friction=0.2", "friction=0.1"})
    colours.insert(style_of(run_of(friction, "taylor", "")).colour);
  EXPECT_EQ(colours.size(), 5u);
}

TEST(Style, SetsOfOneSuiteAreToldApart) {
  const std::vector<std::vector<std::string>> suites{
      {"default", "tuned", "tuned+contactApprox1=0", "tuned+contactApprox1=1"},
      {"tuned", "tuned+shaking=force", "tuned+shaking=ground"}};
  for (const auto& suite : suites) {
    std::set<std::pair<int, std::string>> looks;
    for (const std::string& settings : suite) {
      const Style style = style_of(run_of("ode", "step", settings));
      EXPECT_TRUE(looks.emplace(style.mark, style.dash).second) << settings;
    }
  }
}

}  // namespace
}  // namespace rockstack::plots
