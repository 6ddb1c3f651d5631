// What masses do to engines: claims that depend on kilograms, shown by changing kilograms and nothing else.

#include <gtest/gtest.h>

#include <cmath>

#include "engines/worker/registry.hpp"
#include "tests/engines/bare.hpp"
#include "tests/engines/findings/draws.hpp"
#include "tests/free_rocking.hpp"

namespace rockstack {
namespace {

/// The paper's two blocks with the given masses, kg.
Scene two_blocks(double base, double top) {
  Scene scene = free_rocking(1.5);
  scale_mass(scene.blocks[0], base / scene.blocks[0].mass);
  scale_mass(scene.blocks[1], top / scene.blocks[1].mass);
  return scene;
}

/// Off by a tenth of the slenderness at most: nothing is thrown about.
bool holds(double error) {
  return error < 0.02;
}

TEST(Masses, NncgFailsByKilogramsNotByTheirRatio) {
  const Engine* engine = linked("bullet:nncg");
  if (engine == nullptr) GTEST_SKIP() << "built without Bullet";
  const Parameters parameters = gentle(*engine);
  for (const double ratio : {1.0, 0.01}) {
    for (const double error : errors(*engine, replicates(two_blocks(1e3, ratio * 1e3), 1e-3), parameters))
      EXPECT_TRUE(holds(error)) << "tonnes, ratio " << ratio << ": " << error << " rad";
    for (const double error : errors(*engine, replicates(two_blocks(1e-3, ratio * 1e-3), 1e-3), parameters))
      EXPECT_FALSE(holds(error)) << "grams, ratio " << ratio << ": " << error << " rad";
  }
}

/// The cause: the same solver with rows that return what they applied holds at grams as at tonnes. The bare
/// program of the library's own solver fails as the adapter does.
TEST(Masses, NncgHoldsAtGramsOnceItsRowsReturnImpulses) {
  if (linked("bullet:nncg") == nullptr) GTEST_SKIP() << "built without Bullet";
  const WorkerEngine& engine = find_engine("bullet:nncg");
  for (const Draw& draw : replicates(two_blocks(1e-3, 1e-5), 1e-3)) {
    const std::string text = bare_question(engine, draw.scene, draw.dt, gentle(engine));
    EXPECT_FALSE(holds(error_of(draw, bare_angles("bullet", text))));
    const std::string solver = "solver nncg";
    EXPECT_TRUE(
        holds(error_of(draw, bare_angles("bullet", solver + "-of-impulses" + text.substr(solver.size())))));
  }
}

/// So it does in a stack that is given a thousand tonnes.
TEST(Masses, NncgHoldsAtGramsWithUnitMassOfAThousandTonnes) {
  const Engine* engine = linked("bullet:nncg");
  if (engine == nullptr) GTEST_SKIP() << "built without Bullet";
  const Parameters parameters = with(gentle(*engine), {{"unitMass", 1e6}});
  for (const double error : errors(*engine, replicates(two_blocks(1e-3, 1e-5), 1e-3), parameters))
    EXPECT_TRUE(holds(error)) << error << " rad";
}

/// Every number in sequential impulse scales with the masses, so that a factor of 2ⁿ changes no bit.
TEST(Masses, SequentialImpulseKnowsNoKilograms) {
  const Engine* engine = linked("bullet:sequential-impulse");
  if (engine == nullptr) GTEST_SKIP() << "built without Bullet";
  const double factor = std::ldexp(1, -20);
  for (const Draw& draw : replicates(two_blocks(1e3, 10), 1e-3, 3)) {
    Scene grams = draw.scene;
    for (Block& block : grams.blocks) scale_mass(block, factor);
    EXPECT_EQ(simulate(*engine, draw.scene, draw.dt, gentle(*engine)).history.angles,
              simulate(*engine, grams, draw.dt, gentle(*engine)).history.angles);
  }
}

/// cfm times mass is what counts: with masses a million times larger and cfm as much smaller, errors are what
/// they were; either alone changes them.
TEST(Masses, OdesCfmIsANumberOfOneOverKilograms) {
  const Engine* engine = linked("ode:step");
  if (engine == nullptr) GTEST_SKIP() << "built without ODE";
  const Parameters parameters = with(gentle(*engine), {{"cfm", 1e-10}});
  const Parameters divided = with(parameters, {{"cfm", 1e-16}});
  const auto light = replicates(free_rocking(1.5), 1e-3);
  auto heavy = light;
  for (Draw& draw : heavy) {
    for (Block& block : draw.scene.blocks) scale_mass(block, 1e6);
  }
  const Quartiles usual = quartiles(errors(*engine, light, parameters));
  // Rounding alone moves a median over this many draws by less than the quartiles are apart.
  const double median = quartiles(errors(*engine, heavy, divided)).median;
  EXPECT_GT(median, usual.lower);
  EXPECT_LT(median, usual.upper);
  EXPECT_GT(quartiles(errors(*engine, heavy, parameters)).lower, 10 * usual.upper);
  EXPECT_GT(quartiles(errors(*engine, light, divided)).lower, usual.upper);
}

/// A cfm that suits the base's 4 tonnes is a soft spring under 4 million. Friction limits from normal forces
/// found without friction let the light base slip whatever the cfm: both have to change.
TEST(Masses, OdeCarriesAMillionTimesHeavierTopWithASmallerCfmAndForceLimits) {
  const Engine* engine = linked("ode:step");
  if (engine == nullptr) GTEST_SKIP() << "built without ODE";
  const auto runs = replicates(two_blocks(3906.25, 3906.25e6), 1e-2);
  const Parameters both = with(gentle(*engine), {{"cfm", 1e-14}, {"contactApprox1", 0}});
  for (const double error : errors(*engine, runs, both)) EXPECT_TRUE(holds(error)) << error;
  for (const double error : errors(*engine, runs, with(both, {{"cfm", 1e-10}}))) EXPECT_FALSE(holds(error));
  for (const double error : errors(*engine, runs, with(both, {{"contactApprox1", 1}})))
    EXPECT_FALSE(holds(error));
}

}  // namespace
}  // namespace rockstack
