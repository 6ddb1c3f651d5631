// Adapters broken on purpose: the checks must see it, or they say nothing about the adapters that pass. The
// worker whose engines are taken is named by the variable ROCKSTACK_WORKER; ROCKSTACK_MISTAKES may name some
// mistakes, with ':' between them, where all would take too long: its first engine makes those.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engines/conformance/check.hpp"
#include "engines/worker/worker_engine.hpp"

namespace rockstack {
namespace {

/// What an adapter makes of a question that it gets wrong, and of an answer.
struct Mistake {
  const char* name = "none";
  const char* seen_by = "";  ///< the check
  std::function<void(Setup&)> question = {};
  std::function<void(Trajectory&)> answer = {};
  Parameters settings = {};  ///< of these, those that the engine has
  bool coefficient = false;  ///< of friction: not to be seen in an engine that takes it for something else
  bool forces = false;       ///< of them: not to be seen in an engine that tells none
};

/// As convex hulls in Bullet are by their collision margin, which comes on top of the given size.
void fat(Setup& setup) {
  for (Placement& block : setup.blocks) {
    block.width += 0.08;
    block.height += 0.08;
  }
}

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> list{
      {.name = "FrictionOfThreeTenths",
       .seen_by = "SlidingBlockStops",
       .question = [](Setup& setup) { setup.friction.assign(setup.friction.size(), 0.3); },
       .coefficient = true},
      {.name = "FrictionWhereThereIsNone",
       .seen_by = "WithoutFrictionBlocksSlideOn",
       .question = [](Setup& setup) { setup.friction.assign(setup.friction.size(), 0.3); }},
      {.name = "OneCoefficientForAllInterfaces",
       .seen_by = "EachInterfaceHasItsFriction",
       .question = [](Setup& setup) { setup.friction.assign(setup.friction.size(), setup.friction.front()); },
       .coefficient = true},
      {.name = "RestitutionOfOneFifth",
       .seen_by = "FlatLandingDoesNotBounce",
       .settings = {{"restitution", 0.2},
                    {"restitutionVelocityThreshold", 0},
                    {"restitutionThreshold", 0},
                    {"bounce", 0.2},
                    {"elasticity", 0.2},
                    {"en", 0.2},
                    // A velocity of about 1 m/s is lost by a third then.
                    {"dissipation", 1},
                    {"RestitutionCoeff", 0.2}}},
      // A block placed as before that ends a tenth of a millimetre above what it stands on.
      {.name = "ContactsATenthOfAMillimetreLate",
       .seen_by = "StackKeepsItsHeight",
       .question =
           [](Setup& setup) {
             for (Placement& block : setup.blocks) block.height -= 2e-4;
           }},
      {.name = "MarginOfFourCentimetres", .seen_by = "QuarterPeriodIsHousners", .question = fat},
      {.name = "MassWrongByOnePercent",
       .seen_by = "PairKeepsItsMomentum",
       .question =
           [](Setup& setup) {
             setup.blocks.back().mass *= 1.01;
             setup.blocks.back().inertia *= 1.01;
           }},
      {.name = "InertiaOfOneBlockWrongByATenth",
       .seen_by = "QuarterPeriodIsHousners",
       .question = [](Setup& setup) { setup.blocks.back().inertia *= 1.1; }},
      {.name = "GravityWrongByOnePercent",
       .seen_by = "QuarterPeriodIsHousners",
       .question = [](Setup& setup) { setup.gravity.y *= 1.01; }},
      {.name = "GroundMotionAStepLate",
       .seen_by = "FreeFallIsTheSchemes",
       .question =
           [](Setup& setup) {
             setup.accelerations.insert(setup.accelerations.begin(), setup.gravity);
             setup.accelerations.pop_back();
           }},
      {.name = "GroundMotionThePositiveWay",
       .seen_by = "StrongPushRocks",
       .question =
           [](Setup& setup) {
             for (BodyAcceleration& pull : setup.accelerations) pull.x *= -1;
           }},
      {.name = "GroundThreeCentimetresLow",
       .seen_by = "PairMeetsTheGroundInTime",
       .question =
           [](Setup& setup) {
             for (Placement& block : setup.blocks) block.y += 0.03;
           }},
      {.name = "FrictionOnTheLowerBody",
       .seen_by = "BlockOnASlopePressesByItsTilt",
       .answer =
           [](Trajectory& trajectory) {
             for (Reaction& reaction : trajectory.reactions) reaction.tangential *= -1;
           },
       .forces = true},
      {.name = "ForcesAStepLate",
       .seen_by = "ForcesAreWhatMovesTheBlocks",
       .answer =
           [](Trajectory& trajectory) {
             auto& reactions = trajectory.reactions;
             std::rotate(reactions.begin(), reactions.end() - 2, reactions.end());
           },
       .forces = true},
      {.name = "CentreOfMassOnTheOtherSide",
       .seen_by = "EccentricBlockRocksBothWays",
       .question =
           [](Setup& setup) {
             for (Placement& block : setup.blocks) block.offset_x *= -1;
           }},
      {.name = "CentreOfMassInTheMiddle",
       .seen_by = "EccentricBlockLandsInTime",
       .question =
           [](Setup& setup) {
             for (Placement& block : setup.blocks) block.offset_x = block.offset_y = 0;
           }},
      {.name = "PlacesOfTheMiddle",
       .seen_by = "EccentricBlockFallsAsItTurns",
       .answer =
           [](Trajectory& trajectory) {
             for (std::size_t i = 0; i < trajectory.bodies.size(); ++i)
               trajectory.bodies[i].x += 0.1 * std::sin(trajectory.angles[i]);
           }},
      {.name = "CentreFromTheCentreOfMass",
       .seen_by = "EccentricBlockBearsOffItsMiddle",
       .answer =
           [](Trajectory& trajectory) {
             for (Reaction& reaction : trajectory.reactions) reaction.centre -= 0.06;
           },
       .forces = true},
      {.name = "PushThroughTheCentreOfMass",
       .seen_by = "PushMovesAndTurnsABlock",
       .question =
           [](Setup& setup) {
             for (AppliedPush& push : setup.pushes) push.point.y = 0;
           }},
      {.name = "PushesAStepLate",
       .seen_by = "PushMovesAndTurnsABlock",
       .question =
           [](Setup& setup) {
             for (AppliedPush& push : setup.pushes) push.forces.insert(push.forces.begin(), 0);
           }},
      {.name = "OneTendonWithoutPrestress",
       .seen_by = "BlockSwingsOnTendons",
       .question =
           [](Setup& setup) {
             if (!setup.restraints.empty()) setup.restraints.front().prestress = 0;
           }},
      {.name = "DampingWrongByATwentieth",
       .seen_by = "DamperSlowsABlock",
       .question =
           [](Setup& setup) {
             for (AppliedRestraint& restraint : setup.restraints) restraint.damping *= 1.05;
           }},
      {.name = "TendonsThatDoNotYield",
       .seen_by = "TendonYieldsAndGoesSlack",
       .question =
           [](Setup& setup) {
             for (AppliedRestraint& restraint : setup.restraints) restraint.yield *= 100;
           }},
      {.name = "AnglesCounterClockwise",
       .seen_by = "StrongPushRocks",
       .answer =
           [](Trajectory& trajectory) {
             for (double& angle : trajectory.angles) angle *= -1;
           }},
  };
  return list;
}

/// A run that ends with an error is seen as well.
Judgement judge(const Check& check, const Adapter& adapter) {
  try {
    return check.judge(adapter);
  } catch (const std::exception& error) {
    return {HUGE_VAL, 0, "the run fails"};
  }
}

/// The engine with its tuned set, as `mistake` has it, if any.
Adapter adapter_of(const WorkerEngine& engine, const Mistake& mistake) {
  const Capabilities& able = engine.capabilities;
  return {able.single_precision,
          able.center_of_mass,
          able.applied_forces,
          able.tuned_lead,
          engine.tuned_parameters(),
          [&](Setup setup, Parameters parameters) {
            if (mistake.question) mistake.question(setup);
            for (const auto& [name, value] : mistake.settings) {
              if (parameters.count(name) != 0) parameters[name] = value;
            }
            Trajectory trajectory = run(engine, setup, parameters, true, {}, 0, true);
            if (mistake.answer) mistake.answer(trajectory);
            return trajectory;
          }};
}

bool is_asked_for(const Mistake& mistake) {
  const char* asked = std::getenv("ROCKSTACK_MISTAKES");
  return asked == nullptr ||
         (":" + std::string(asked) + ":").find(":" + std::string(mistake.name) + ":") != std::string::npos;
}

bool may_be_made(const Mistake& mistake, const WorkerEngine& engine) {
  const Parameters parameters = engine.tuned_parameters();
  if (mistake.coefficient && !known_limit(engine.name, engine.solver, "tuned", mistake.seen_by).empty())
    return false;
  return mistake.settings.empty() ||
         std::any_of(mistake.settings.begin(), mistake.settings.end(),
                     [&](const auto& setting) { return parameters.count(setting.first) != 0; });
}

/// A check that holds must fail then. One that the engine cannot pass must find another number: one that
/// differs by more than it may be at most.
bool sees(const Judgement& before, const Judgement& after) {
  return before.holds() ? !after.holds() : std::abs(after.value - before.value) > after.limit;
}

std::vector<WorkerEngine> asked_engines(const char* worker) {
  std::vector<WorkerEngine> engines = engines_of(worker);
  if (std::getenv("ROCKSTACK_MISTAKES") != nullptr) engines.erase(engines.begin() + 1, engines.end());
  return engines;
}

TEST(Mutants, AreSeen) {
  const char* worker = std::getenv("ROCKSTACK_WORKER");
  if (worker == nullptr) GTEST_SKIP() << "no worker is named";
  const Mistake none;
  for (const WorkerEngine& engine : asked_engines(worker)) {
    std::map<std::string, Judgement> unbroken;
    for (const Mistake& mistake : mistakes()) {
      if (!is_asked_for(mistake) || !may_be_made(mistake, engine)) continue;
      SCOPED_TRACE(engine.full_name() + " " + mistake.name);
      const Check& check = *std::find_if(checks().begin(), checks().end(),
                                         [&](const Check& one) { return one.name == mistake.seen_by; });
      if (unbroken.count(check.name) == 0) unbroken[check.name] = check.judge(adapter_of(engine, none));
      const Judgement& before = unbroken[check.name];
      if (mistake.forces && before.what == tells_no_forces) continue;
      const bool limited = !known_limit(engine.name, engine.solver, "tuned", check.name).empty();
      EXPECT_NE(before.holds(), limited)
          << before.value << " against " << before.limit << ", " << before.what;
      const Judgement after = judge(check, adapter_of(engine, mistake));
      EXPECT_TRUE(sees(before, after)) << after.value << " against " << after.limit << ", " << after.what;
    }
  }
}

}  // namespace
}  // namespace rockstack
