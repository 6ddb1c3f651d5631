#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "analytic/mechanics/impact.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"
#include "tests/free_rocking.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr double roundings = 1e-12;  // of a few dozen operations on numbers of like size

TEST(Landing, PutRightIsTheProjectionThatTheSolverMakes) {
  const Scene scene = free_rocking(2);
  const Model<double> model = make_model<double>(scene);
  Impact<double> impact{{closed_pattern(2), Vector<double>::Zero(2), Vector<double>::Zero(2)}, {}};
  impact.before.pattern[0] = Contact::right;
  impact.before.velocities[0] = -1;
  impact.impacting.set(0);
  Pattern after = closed_pattern(2);
  after[0] = after[1] = Contact::left;
  const Vector<double> rates = absolute(velocities_after(model, impact, after).relative);
  const Landing landing = land(scene, {});
  EXPECT_NEAR(landing.base, -rates[0], roundings);
  EXPECT_NEAR(landing.top, -rates[1], roundings);
}

TEST(Landing, AsPrintedItGainsEnergyAndPutRightItLosesSome) {
  // The numbers are those of analytic/paper-audit.md, to its three decimals.
  const Scene scene = free_rocking(2);
  EXPECT_NEAR(land(scene, {}).energy, 0.705, 5e-4);
  EXPECT_NEAR(land(scene, {true, true}).energy, 1.359, 5e-4);
  EXPECT_NEAR(land(scene, {.eq137 = true}).base, 1.072, 5e-4);
  EXPECT_NEAR(land(scene, {.eq138 = true}).base, 3.401, 5e-4);
}

TEST(Landing, TheWeldedBlockRocksAsTheClosedStackDoes) {
  // Their pull and inertia about the corner give the same acceleration.
  const Scene scene = free_rocking(2);
  Scene one = scene;
  one.blocks = {welded(scene)};
  State<double> stack{closed_pattern(2), Vector<double>::Zero(2), Vector<double>::Zero(2)};
  State<double> block{closed_pattern(1), Vector<double>::Zero(1), Vector<double>::Zero(1)};
  stack.pattern[0] = block.pattern[0] = Contact::right;
  stack.angles[0] = block.angles[0] = 0.1;
  const Point<double> still = Point<double>::Zero();
  EXPECT_NEAR(accelerations(make_model<double>(scene), stack, still)[0],
              accelerations(make_model<double>(one), block, still)[0], roundings);
}

TEST(ImpactEnergies, BeforeIsAfterPlusThatOfTheJump) {
  const Scene scene = free_rocking(2);
  int impacts = 0;
  for (const Event& event : solve(scene).events) {
    if (event.kind != EventKind::impact) continue;
    const ImpactEnergies energies = impact_energies(scene, event);
    EXPECT_NEAR(energies.before, energies.after + energies.jump, roundings * energies.before) << event.time;
    ++impacts;
  }
  EXPECT_GT(impacts, 10);
}

TEST(Wording, NumbersReadAsTheyShould) {
  EXPECT_EQ(fixed(-0.48158, 3), "−0.482");
  EXPECT_EQ(fixed(-0.0001, 3), "0.000");
  EXPECT_EQ(power(-3.14e-5, 1), "−3.1 × 10⁻⁵");
  EXPECT_EQ(power(0, 1), "0");
  EXPECT_EQ(percent(0.2954, 1), "29.5 %");
}

TEST(Lessons, EachHasASuiteAndATextThatEndsWithQuestionsAndWhatToTry) {
  EXPECT_GE(lessons().size(), 16u);
  for (const Lesson& lesson : lessons()) {
    EXPECT_FALSE(title(lesson).empty()) << lesson.name;
    std::ifstream in(std::filesystem::path(ROCKSTACK_LESSONS) / lesson.name / "text.html");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const char* part :
         {"<h2>Try this</h2>", "--set", "<h2>Questions</h2>", "class=\"question\"", "{{player:", "<math"})
      EXPECT_NE(text.find(part), std::string::npos) << lesson.name << ": " << part;
  }
}

TEST(Lessons, ASignChangeIsFoundToARounding) {
  EXPECT_NEAR(crossing(0, 2, [](double x) { return x * x - 2; }), std::sqrt(2), 1e-14);
  EXPECT_NEAR(crossing(0, 2, [](double x) { return 2 - x * x; }), std::sqrt(2), 1e-14);
  EXPECT_NEAR(crossing(0, 1, [](double x) { return x < 0.3 ? -1 : 1; }), 0.3, 1e-14);
}

/// What a lesson's text is filled with, where its suite asks no engine.
LessonValues values_without_engines(const std::string& lesson) {
  const std::filesystem::path file = std::filesystem::path(ROCKSTACK_LESSONS) / lesson / "suite.toml";
  return find_lesson(lesson).values(read_suite(file, {}), {});
}

// θ − α + θ̇/p after a constant push of a has to be above zero: a > g α/(1 − exp(−p T)), of slender blocks.
TEST(LargeSurvives, APushThatIsConstantTopplesAsTheFormulaTells) {
  const LessonValues values = values_without_engines("large-survives");
  for (const auto& row : values.tables.at("pushes").rows) {
    EXPECT_EQ(row.at(2), row.at(3)) << row.front();
    // In full the block leaves its base at g tan α, not at g α, which is 1.3 % less here.
    EXPECT_NEAR(std::stod(row.at(4)) / std::stod(row.at(2)), 1.013, 1e-3) << row.front();
  }
}

TEST(LargeSurvives, ItsMapHasAStripAndAModelTopplesAsTheWholeDoes) {
  const LessonValues values = values_without_engines("large-survives");
  EXPECT_GT(values.measured.at("threshold_ratio"), 2);
  EXPECT_EQ(values.measured.at("topples_at_twice"), 0);
  EXPECT_EQ(values.numbers.at("model_from"), values.numbers.at("large_from"));
  std::vector<double> before(4, 0);
  for (const auto& row : values.tables.at("strips").rows)
    for (std::size_t i = 1; i < row.size(); ++i) {
      EXPECT_GT(std::stod(row[i]), before[i]) << "larger blocks have larger ones: " << row.front();
      EXPECT_GT(std::stod(row[i]), i == 1 ? 1 : std::stod(row[i - 1]));
      before[i] = std::stod(row[i]);
    }
}

// Jacobi's matrix of n equal blocks on a floor has the eigenvalues cos((2k − 1) π/2n), Gauss–Seidel's their
// squares.
TEST(StackOfTen, SweepsOfEqualBlocksAreThoseOfTheClosedForm) {
  const std::filesystem::path folder = std::filesystem::path(ROCKSTACK_LESSONS) / "stack-of-ten";
  const Suite suite = read_suite(folder / "suite.toml", {});
  EXPECT_GE(suite.replicates.runs, 7);
  std::vector<RunMetrics> rows;
  for (const NamedScene& scene : suite.scenes)
    for (const auto& [engine, solver] : {std::pair{"ode", "quickstep"}, {"bullet", "sequential-impulse"}})
      for (const char* sweeps : {"10", "40", "160"}) {
        RunMetrics& row = rows.emplace_back();
        row.scene = scene.name;
        row.engine = engine;
        row.solver = solver;
        row.settings = std::string("tuned+numIterations=") + sweeps;
        row.rms_position_difference = row.rms_position_difference_lower = row.rms_position_difference_upper =
            1;
      }
  const LessonValues values = find_lesson("stack-of-ten").values(suite, rows);
  EXPECT_EQ(values.tables.at("heavy").rows.at(0).at(1), values.numbers.at("ten"));
  EXPECT_GT(values.measured.at("heavy_ratio"), 2);
  EXPECT_EQ(values.tables.at("engines").rows.size(), 6U);
}

/// Columns of reactions.csv at every sample of a scene.
std::vector<std::vector<double>> reactions_of(const Scene& scene, const History& history,
                                              const std::vector<std::string>& names) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "reactions.csv";
  std::ofstream(file) << reactions_csv(scene, history);
  return read_columns(file, names);
}

TEST(Reactions, TheStackAtRestStandsOnItsWeightInTheMiddle) {
  Scene scene = free_rocking(2);
  scene.initial = {{0, 0}, {0, 0}};
  const History history = solve(scene, {.sample_times = {0, 1}});
  const auto columns = reactions_of(scene, history, {"normal_1", "normal_2", "tangential_1", "centre_1"});
  const double top = scene.blocks[1].mass * scene.gravity;
  for (std::size_t i = 0; i < 2; ++i) {
    // Seven digits are written.
    EXPECT_NEAR(columns[0][i], top + scene.blocks[0].mass * scene.gravity, 1e-6 * top);
    EXPECT_NEAR(columns[1][i], top, 1e-6 * top);
    EXPECT_NEAR(columns[2][i], 0, 1e-6 * top);
    EXPECT_NEAR(columns[3][i], 0, 1e-6);
  }
}

TEST(Reactions, TheCentreOfPressureReachesTheEndWhereTheBlocksPart) {
  const Scene scene = free_rocking(2);
  const History events = solve(scene);
  ASSERT_EQ(events.events.front().kind, EventKind::opening);
  const double opening = events.events.front().time;
  const History history = solve(scene, {.sample_times = {0.0, opening - 1e-6}});
  const auto centres = reactions_of(scene, history, {"centre_2"})[0];
  EXPECT_LT(std::abs(centres[0]), 0.49);
  // It moves by about 1 m/s here, so by 1e-6 m in the time that is left.
  EXPECT_NEAR(centres[1], 0.5, 1e-5);
}

}  // namespace
}  // namespace rockstack
