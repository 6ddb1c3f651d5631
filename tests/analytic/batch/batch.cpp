#include "analytic/solve_batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <sstream>

#include "tests/analytic/solver/stacks.hpp"
#include "tests/stride.hpp"

namespace rockstack::testing {
namespace {

/// All of a history, numbers by their bits.
class Bits {
 public:
  void add(double number) { text_ << std::hex << std::bit_cast<std::uint64_t>(number) << ' '; }
  void add(const std::vector<double>& numbers) {
    for (const double number : numbers) add(number);
    text_ << '\n';
  }
  void add(const std::vector<Demand>& demands) {
    for (const Demand& demand : demands)
      add({demand.least_normal, demand.least_normal_time, demand.friction, demand.friction_time,
           demand.first_pull_time, demand.first_slip_time});
  }
  void add(const History& history) {
    text_ << history.blocks << '\n';
    for (const auto* numbers :
         {&history.times, &history.angles, &history.velocities, &history.peaks, &history.uplifts})
      add(*numbers);
    for (const Pattern& pattern : history.patterns) text_ << name(pattern) << ' ';
    for (const Event& event : history.events) {
      add(event.time);
      text_ << name(event.kind) << ' ' << event.interface << ' ' << name(event.from) << ' ' << name(event.to)
            << ' ' << name(event.consistency) << ' ' << event.count << ' ';
      for (const auto* numbers : {&event.angles, &event.before, &event.after}) add(*numbers);
    }
    for (const BasicGraze<double>& graze : history.grazes) {
      add(graze.time);
      text_ << name(graze.kind) << ' ' << graze.interface << '\n';
    }
    add(history.forces);
    add(history.impulses);
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

std::string bits_of(const History& history) {
  Bits bits;
  bits.add(history);
  return bits.text();
}

/// A history by its bits, or why there is none, and what is known of it then.
std::string answer(const History& history, const std::exception_ptr& failure) {
  if (!failure) return bits_of(history);
  try {
    std::rethrow_exception(failure);
  } catch (const Unfinished& error) {
    return error.what() + bits_of(error.history);
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::string alone(const Scene& scene, const SolveOptions& options) {
  try {
    return answer(solve(scene, options), nullptr);
  } catch (const std::exception&) {
    return answer({}, std::current_exception());
  }
}

std::vector<std::string> together(const std::vector<Scene>& scenes, const SolveOptions& options,
                                  InstructionSet set) {
  std::vector<std::string> answers(scenes.size(), "nothing came out");
  std::size_t given = 0;
  solve_batch(
      [&] { return given < scenes.size() ? std::optional(scenes[given++]) : std::nullopt; }, options,
      [&](const Solved& solved) { answers.at(solved.number) = answer(solved.history, solved.failure); }, set);
  return answers;
}

/// One to three blocks, under records, pulses or none, along both axes, for up to 4 s; some may slip.
std::vector<Scene> mixed_scenes(std::uint64_t seed, int count) {
  Draw draw(seed);
  std::vector<Scene> scenes;
  for (int i = 0; i < count; ++i) {
    Scene scene = random_scene(draw, draw.below(8) == 0 ? 3 : 1 + draw.below(2), false);
    if (draw.below(4) > 0) shake(draw, scene);
    if (draw.below(4) == 0) scene.equations = Equations::linear;
    scene.duration = draw.between(0.05, 4);
    if (i % 12 == 5) {
      scene.equations = Equations::nonlinear;
      scene.law = Law::unilateral;
      scene.friction.assign(scene.blocks.size(), draw.between(0.1, 1));
    }
    scenes.push_back(scene);
  }
  return scenes;
}

class Batch : public ::testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    const auto& sets = instruction_sets();
    if (std::find(sets.begin(), sets.end(), GetParam()) == sets.end())
      GTEST_SKIP() << "this machine or build has no " << name(GetParam());
  }

  static void expect_the_bits_of_each_alone(const std::vector<Scene>& scenes, const SolveOptions& options) {
    const auto answers = together(scenes, options, GetParam());
    for (std::size_t i = 0; i < scenes.size(); ++i)
      ASSERT_EQ(answers[i], alone(scenes[i], options)) << "scene " << i;
  }
};

INSTANTIATE_TEST_SUITE_P(InstructionSets, Batch,
                         ::testing::Values(InstructionSet::scalar, InstructionSet::sse2, InstructionSet::avx2,
                                           InstructionSet::avx512),
                         [](const auto& set) {
                           std::string text = name(set.param);
                           std::erase(text, '-');
                           return text;
                         });

TEST_P(Batch, GivesTheBitsOfEachSceneAlone) {
  std::uint64_t seed = 0;
  for (const double tolerance : {0.0, 1e-9, 1e-6}) {
    for (const bool kept : {true, false}) {
      const SolveOptions options{.events = kept ? EventsKept::summed : EventsKept::all,
                                 .validity = kept,
                                 .peaks = kept,
                                 .resolution = tolerance,
                                 .tolerance = tolerance};
      expect_the_bits_of_each_alone(mixed_scenes(++seed, 150 / stride), options);
    }
  }
}

// Kernels walk along records by themselves.
TEST_P(Batch, GivesTheBitsOfBlocksThatRockUnderARecord) {
  Draw draw(600);
  std::vector<Scene> scenes;
  for (int i = 0; i < 60 / stride; ++i) {
    Scene scene = random_scene(draw, 1 + draw.below(3), false);
    scene.horizontal.interval = draw.between(0.002, 0.02);
    for (int k = 0; k < 200; ++k) scene.horizontal.samples.push_back(draw.between(-4, 4));
    scene.inclination = draw.coin() ? draw.between(-0.02, 0.02) : 0;
    scene.duration = scene.horizontal.end() * (draw.coin() ? 1 : draw.between(0.4, 1.2));
    scenes.push_back(scene);
  }
  const std::function<bool()> cancelled = [] { return false; };
  for (const double tolerance : {0.0, 1e-6})
    for (const bool kept : {true, false})
      expect_the_bits_of_each_alone(scenes, {.events = EventsKept::summed,
                                             .validity = kept,
                                             .peaks = true,
                                             .tolerance = tolerance,
                                             .cancelled = kept ? &cancelled : nullptr});
}

// Impacts on a closed interface, after which the laws may choose other patterns.
TEST_P(Batch, GivesTheBitsOfImpactsOnAClosedInterfaceUnderEitherLaw) {
  Draw draw(700);
  std::vector<Scene> scenes;
  for (int i = 0; i < 300 / stride; ++i) {
    Scene scene = released({block(draw.between(0.3, 2), draw.between(0.3, 3)),
                            block(draw.between(0.3, 2), draw.between(0.3, 3))},
                           {0, 0}, 0.5);
    const bool lower = draw.coin();
    const double angle = draw.between(0.01, 0.1);
    scene.initial.angles = lower ? std::vector{angle, angle} : std::vector{0, angle};
    scene.initial.velocities = lower ? std::vector{-2.0, -2.0} : std::vector{0.0, -2.0};
    scene.law = draw.coin() ? Law::paper : Law::consistent;
    scenes.push_back(scene);
  }
  expect_the_bits_of_each_alone(scenes, {.events = EventsKept::all, .peaks = true, .tolerance = 1e-9});
}

// Squat blocks lean far past one radian before they topple.
TEST_P(Batch, GivesTheBitsOfBlocksThatLeanFar) {
  std::vector<Scene> scenes;
  for (int i = 0; i < 20; ++i) {
    Scene scene = released({block(2, 0.5), block(1.5, 0.5 + 0.1 * i)}, {1.0 + 0.01 * i, 1.0}, 1);
    scene.initial.velocities = {0.1 * i, 0};
    scenes.push_back(scene);
  }
  expect_the_bits_of_each_alone(scenes, {.validity = true, .peaks = true});
}

TEST_P(Batch, TakesAnyNumberOfScenes) {
  for (int count = 0; count < 20; ++count)
    expect_the_bits_of_each_alone(mixed_scenes(100, count),
                                  {.events = EventsKept::summed, .peaks = true, .tolerance = 1e-9});
}

TEST_P(Batch, KeepsWhatNeedsStepsOfItsOwn) {
  const auto scenes = mixed_scenes(200, 6);
  expect_the_bits_of_each_alone(scenes, {.sample_times = {0, 0.01, 0.02}, .peaks = true});
  expect_the_bits_of_each_alone(scenes, {.integrator = Integrator::rk4, .peaks = true});
}

TEST_P(Batch, AFailingSceneCostsItsOwnAnswerAlone) {
  auto scenes = mixed_scenes(300, 24);
  scenes[3].duration = -1;
  scenes[9].blocks.clear();
  // So far apart that the solver goes over to wider numbers.
  scenes[14] = released({block(1, 1), block(1e-7, 1e-7)}, {0.1, 0.05}, 1);
  expect_the_bits_of_each_alone(scenes, {.validity = true, .peaks = true, .tolerance = 1e-6});
  expect_the_bits_of_each_alone(scenes, {.tolerance = -1});
}

TEST_P(Batch, OfAMotionThatCannotGoOnItTellsWhatIsKnown) {
  // Without a resolution a slender block chatters too long.
  const Scene slender = released({block(0.1, 2)}, {1e-6}, 2);
  const SolveOptions options{.peaks = true, .resolution = 1e-100};
  EXPECT_THROW(solve(slender, options), Unfinished);
  Scene pair = released({block(0.1, 1), block(0.1, 1)}, {1e-6, 1e-6}, 2);
  expect_the_bits_of_each_alone({slender, pair, slender}, options);
}

TEST_P(Batch, EndsWhatIsUnwanted) {
  const std::function<bool()> cancelled = [] { return true; };
  for (const std::string& text : together(mixed_scenes(500, 12), {.cancelled = &cancelled}, GetParam()))
    EXPECT_EQ(text, Stopped().what());
}

TEST_P(Batch, WhatItsSourceAndItsTakerThrowGoesThrough) {
  auto scenes = mixed_scenes(400, 20);
  scenes.insert(scenes.begin(),
                released({block(1, 1), block(1e-7, 1e-7)}, {0.1, 0.05}, 1));  // in wider numbers
  std::size_t given = 0;
  const auto next = [&] { return given < scenes.size() ? std::optional(scenes[given++]) : std::nullopt; };
  const auto failing_source = [&]() -> std::optional<Scene> {
    return given < 10 ? next() : throw std::logic_error("no source");
  };
  EXPECT_THROW(solve_batch(
                   failing_source, {}, [](const Solved&) {}, GetParam()),
               std::logic_error);
  given = 0;
  EXPECT_THROW(solve_batch(
                   next, {}, [](const Solved&) { throw std::logic_error("no taker"); }, GetParam()),
               std::logic_error);
}

}  // namespace
}  // namespace rockstack::testing
