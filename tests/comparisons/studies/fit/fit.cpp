#include "comparisons/studies/fit/fit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/statistics/draws.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr double half_width = 0.2, half_height = 0.8, start = 0.12, ratio = 0.9, gravity = 9.81;
const double slope = std::atan(half_width / half_height);
const double rate = std::sqrt(3 * gravity / (4 * std::hypot(half_width, half_height)));  // p of Housner 1963

constexpr const char* measured_block = R"(duration = 3.0
equations = "small-angle"
restitution = [0.9]
[[blocks]]
width = 0.4
height = 1.6
density = 2500
[initial]
angles = [0.12]
[measured]
file = "test.csv"
column = "angle"
)";

/// Housner's block in closed form, 1963: cosh down from rest, then at each impact the velocity times the
/// ratio, and up and down on the other side.
double housner(double t) {
  double fall = std::acosh(1 / (1 - start / slope)) / rate;  // a quarter of the period of that amplitude
  if (t < fall) return slope - (slope - start) * std::cosh(rate * t);
  double velocity = (slope - start) * rate * std::sinh(rate * fall), side = -1;
  for (t -= fall;; t -= fall, side = -side) {
    velocity *= ratio;
    fall = 2 * std::atanh(velocity / (slope * rate)) / rate;  // half of it
    if (t < fall) return side * (slope - slope * std::cosh(rate * t) + velocity / rate * std::sinh(rate * t));
  }
}

std::vector<double> every(double interval, double end) {
  return regular_times(interval, end);
}

std::string measured_csv(const std::vector<double>& times, const std::vector<double>& values) {
  CsvWriter csv;
  csv.line("time", "angle");
  for (std::size_t i = 0; i < times.size(); ++i) csv.line(times[i], values[i]);
  return csv.text();
}

std::string closed_form() {
  std::vector<double> values;
  for (const double t : every(0.02, 3)) values.push_back(housner(t));
  return measured_csv(every(0.02, 3), values);
}

/// A scene in a file beside its readings.
struct Tested {
  Tested(const std::string& scene, const std::string& readings) {
    folder.write("test.csv", readings);
    document = read_document(folder.write("scene.toml", scene));
    MotionLibrary library;
    measured = read_measurement(*document.measured, folder.path(), make_scene(document, library));
  }

  TemporaryFolder folder;
  SceneDocument document;
  Measurement measured;
};

const std::vector<VariedKey> unknown{{"restitution.1", 0.7, 0.99}, {"blocks.1.width", 0.3, 0.5}};

TEST(Fit, FindsHousnersBlockFromItsPeriodsAndAmplitudes) {
  const Tested test(measured_block, closed_form());
  const Fit found = fit(test.document, test.measured, unknown);
  EXPECT_EQ(found.readings, 151U);
  EXPECT_EQ(found.horizon, 3);
  // Numbers in the file read back to the bit: what is left is the method's tolerance, 1e-12 of the sum.
  EXPECT_NEAR(found.parameters[0].value, ratio, 1e-6);
  EXPECT_NEAR(found.parameters[1].value, 2 * half_width, 1e-6);
  EXPECT_LT(found.residual, 1e-6);
  ASSERT_EQ(found.motion.size(), 151U);
  EXPECT_NEAR(found.motion[75], housner(1.5), 1e-5);
}

TEST(Fit, DerivativesAreThoseOfTheClosedForm) {
  const Tested test(measured_block, closed_form());
  const std::vector<VariedKey> parameters{{"gravity", 9, 11}, {"initial.angles.1", 0.1, 0.15}};
  const double fall = std::acosh(1 / (1 - start / slope)) / rate;
  const FittedScene fitted(test.document, test.measured, parameters, fall);
  const auto derivatives = fitted.derivatives({gravity, start});
  ASSERT_GT(fitted.size(), 10U);
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    const double t = fitted.times()[i];
    // Differences over 2e-5: h² θ'''/6 is below 1e-9, rounding 1e-14/1e-5.
    EXPECT_NEAR(derivatives(static_cast<Eigen::Index>(i), 0),
                -(slope - start) * std::sinh(rate * t) * t * rate / (2 * gravity), 1e-8);
    EXPECT_NEAR(derivatives(static_cast<Eigen::Index>(i), 1), std::cosh(rate * t), 1e-8);
  }
}

/// The least count of hits that a chance of 0.95 each falls below in less than one of ten thousand times.
int least_hits(int trials) {
  double probability = std::pow(0.05, trials), sum = 0;
  for (int hits = 0;; ++hits) {
    sum += probability;
    if (sum > 1e-4) return hits;
    probability *= static_cast<double>(trials - hits) / (hits + 1) * 0.95 / 0.05;
  }
}

TEST(Fit, IntervalsHoldTheTruthInNinetyFiveOfAHundredTests) {
  constexpr int tests = 100;
  constexpr double sigma = 2e-3;
  const std::vector<double> times = every(0.02, 2);
  int hits[2] = {}, quiet = 0;
  for (int i = 0; i < tests; ++i) {
    std::vector<double> values;
    for (std::size_t k = 0; k < times.size(); ++k)
      values.push_back(housner(times[k]) +
                       draw({Distribution::Kind::normal, 0, sigma},
                            {1, static_cast<std::uint64_t>(i), static_cast<std::uint32_t>(k)}));
    const Tested test(std::string(measured_block) + "uncertainty = 0.002\n", measured_csv(times, values));
    const Fit found = fit(test.document, test.measured, unknown);
    const double truth[] = {ratio, 2 * half_width};
    for (std::size_t k = 0; k < 2; ++k) hits[k] += found.parameters[k].holds(truth[k]) ? 1 : 0;
    const auto said = meaning(found, test.measured);
    if (said[1].find("tells all") != std::string::npos && said[2].find("intervals hold") != std::string::npos)
      ++quiet;
  }
  EXPECT_EQ(least_hits(tests), 85);
  for (const int count : hits) {
    EXPECT_GE(count, least_hits(tests));
    EXPECT_LT(count, tests) << "intervals of 95 % that never miss are too wide";
  }
  // Sentences warn beyond three standard deviations, which chance brings about in less than one of a hundred.
  EXPECT_GE(quiet, 95);
}

// A clock that starts late sees the block: what it shows before the start is the block at rest.
TEST(Fit, IntervalsHoldTheTruthWhateverTheClockShowsAtTheStart) {
  constexpr int tests = 50;
  constexpr double sigma = 2e-3;
  const std::vector<double> times = every(0.02, 2);
  for (const double late : {3e-3, 1e-2}) {
    int hits[3] = {}, told = 0;
    for (int i = 0; i < tests; ++i) {
      std::vector<double> values;
      for (std::size_t k = 0; k < times.size(); ++k)
        values.push_back(housner(std::max(0.0, times[k] - late)) +
                         draw({Distribution::Kind::normal, 0, sigma},
                              {4, static_cast<std::uint64_t>(i), static_cast<std::uint32_t>(k)}));
      const Tested test(measured_block, measured_csv(times, values));
      const Fit found = fit(test.document, test.measured, unknown);
      const double truth[] = {ratio, 2 * half_width, late};
      for (std::size_t k = 0; k < 3; ++k) hits[k] += found.parameters[k].holds(truth[k]) ? 1 : 0;
      for (const std::string& sentence : meaning(found, test.measured))
        told += sentence.find("s later than") != std::string::npos ? 1 : 0;
    }
    for (const int count : hits) EXPECT_GE(count, least_hits(tests)) << late;
    EXPECT_GE(told, late > 5e-3 ? tests : 0);  // by 10 ms it is off by many deviations
  }
}

TEST(Fit, AMotionWithoutNoiseHasBoundsOfRounding) {
  constexpr const char* rocking = R"(duration = 4
restitution = [0.9]
[[blocks]]
width = 0.4
height = 1.2
density = 2500
[initial]
angles = [0.2]
[measured]
file = "test.csv"
column = "angle"
)";
  const Tested truth(rocking, "time,angle\n0,0\n");
  MotionLibrary library;
  for (const int seconds : {2, 3, 4}) {
    SCOPED_TRACE(seconds);
    const History motion = solve(make_scene(truth.document, library), {.sample_times = every(0.01, seconds)});
    const Tested test(rocking, measured_csv(motion.times, motion.angles));
    const Fit found = fit(test.document, test.measured, {{"restitution.1", 0.8, 1}});
    EXPECT_TRUE(found.parameters[0].holds(ratio));
    EXPECT_LT(found.parameters[0].upper - found.parameters[0].lower, 1e-5);
    EXPECT_TRUE(found.parameters[1].holds(0));
    EXPECT_EQ(
        meaning(found, test.measured),
        std::vector<std::string>{fmt::format(
            "The fitted motion is the test's to rounding, over {} readings up to {} s: bounds are of rounding.",
            100 * seconds + 1, seconds)});
    const Json headline = fit_json("A block", test.measured, found, "").at("headline");
    ASSERT_EQ(headline.size(), 3U);  // a sentence a parameter, and what they mean
    const FittedParameter& one = found.parameters[0];
    EXPECT_EQ(headline.at(0),
              fmt::format("restitution.1 = {:.6g}, with 95 % confidence from {:.6g} to {:.6g}.", one.value,
                          one.lower, one.upper));
  }
}

/// How many intervals of 95 % hold the truth in a hundred tests: a motion with noise.
int held(const std::string& scene, const std::vector<double>& times, const std::vector<double>& motion,
         double sigma, const VariedKey& parameter, double truth) {
  int hits = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<double> values;
    for (std::size_t k = 0; k < times.size(); ++k)
      values.push_back(motion[k] + draw({Distribution::Kind::normal, 0, sigma},
                                        {2, static_cast<std::uint64_t>(i), static_cast<std::uint32_t>(k)}));
    const Tested test(scene, measured_csv(times, values));
    hits += fit(test.document, test.measured, {parameter}).parameters[0].holds(truth) ? 1 : 0;
  }
  return hits;
}

/// A block pushed off flat with 2 m/s, of which a point is measured.
constexpr const char* pushed_block = R"(duration = 0.6
law = "unilateral"
[[blocks]]
width = 0.4
height = 0.4
density = 1000
[initial]
slip_velocities = [2.0]
[contact]
friction = 0.5
[measured]
file = "test.csv"
column = "angle"
point = [0.1, 0.2]
)";

TEST(Fit, IntervalsHoldTheFrictionOfASlide) {
  constexpr double friction = 0.5, speed = 2, stop = speed / (friction * gravity);
  const std::vector<double> times = every(0.02, 0.6);
  std::vector<double> way;
  for (const double time : times) {
    const double t = std::min(time, stop);
    way.push_back(speed * t - friction * gravity * t * t / 2);
  }
  const int hits = held(pushed_block, times, way, 1e-3, {"contact.friction", 0.2, 0.9}, friction);
  EXPECT_GE(hits, least_hits(100));
  EXPECT_LT(hits, 100);
}

constexpr const char* soft_block = R"(duration = 0.3
law = "compliant"
[[blocks]]
width = 0.4
height = 0.8
density = 1000
[initial]
velocities = [0.5]
[contact]
friction = 1
stiffness = 2e5
damping = 1e3
[measured]
file = "test.csv"
column = "angle"
)";

TEST(Fit, IntervalsHoldTheStiffnessOfCorners) {
  const Tested truth(soft_block, "time,angle\n0,0\n");
  MotionLibrary library;
  const History motion = solve(make_scene(truth.document, library), {.sample_times = every(0.01, 0.3)});
  const int hits = held(soft_block, motion.times, motion.angles, 1e-3, {"contact.stiffness", 1e5, 4e5}, 2e5);
  EXPECT_GE(hits, least_hits(100));
  EXPECT_LT(hits, 100);
}

/// With more friction than it needs this block never slips, and rocks as with any.
TEST(Fit, AnIntervalHoldsAllValuesThatComeAsNear) {
  constexpr const char* rocking = R"(duration = 1.2
law = "unilateral"
[[blocks]]
width = 0.4
height = 1.2
density = 1000
[initial]
angles = [0.2]
[contact]
friction = 0.28
[measured]
file = "test.csv"
column = "angle"
)";
  const Tested truth(rocking, "time,angle\n0,0\n");
  MotionLibrary library;
  const History motion =
      solve(make_scene(truth.document, library), {.sample_times = every(0.01, 1.2), .validity = true});
  const double needed = std::max(motion.forces[0].friction, motion.impulses[0].friction);
  ASSERT_LT(needed, 0.28);
  const VariedKey friction{"contact.friction", 0.2, 0.36};
  constexpr double part = 0.16 / 40;
  for (const double noise : {0.0, 1e-3}) {
    std::vector<double> values;
    for (std::size_t k = 0; k < motion.size(); ++k)
      values.push_back(motion.angles[k] + noise * draw({Distribution::Kind::normal, 0, 1},
                                                       {3, 0, static_cast<std::uint32_t>(k)}));
    const Tested test(rocking, measured_csv(motion.times, values));
    const Fit found = fit(test.document, test.measured, {friction});
    const FittedParameter& one = found.parameters[0];
    EXPECT_TRUE(one.holds(0.28)) << one.lower << ' ' << one.upper;
    EXPECT_EQ(one.upper, friction.high);
    EXPECT_LT(one.lower, needed);
    EXPECT_GE(one.lower, noise == 0 ? needed - 2 * part : friction.low);
    EXPECT_NE(meaning(found, test.measured).back().find("may as well lie anywhere"), std::string::npos);
  }
}

TEST(Fit, SaysWhatTheModelLeavesOut) {
  const Tested test(std::string(measured_block) + "uncertainty = 0.1\nunit = \"mrad\"\n", [] {
    std::vector<double> values;
    for (const double t : every(0.02, 3)) values.push_back(1e3 * housner(t));
    return measured_csv(every(0.02, 3), values);
  }());
  std::string scene = measured_block;
  scene.replace(scene.find("[0.9]"), 5, "[0.8]");
  const Tested other(scene, closed_form());
  const std::vector<VariedKey> width{unknown[1]};
  const Fit found = fit(other.document, test.measured, width);
  const auto said = meaning(found, test.measured);
  EXPECT_NE(said[1].find("the model leaves something out"), std::string::npos) << said[1];
  EXPECT_NE(said[2].find("the intervals are too narrow"), std::string::npos) << said[2];
}

TEST(Fit, SaysWhatATestDoesNotTell) {
  const Tested test(measured_block, closed_form());
  const Fit found = fit(test.document, test.measured, {{"blocks.1.density", 1000, 3000}, unknown[0]});
  EXPECT_TRUE(std::isinf(found.parameters[0].lower) && std::isinf(found.parameters[0].upper));
  EXPECT_LT(found.parameters[1].upper - found.parameters[1].lower, 2e-5);
  const Fit beside = fit(test.document, test.measured, {{"restitution.1", 0.5, 0.85}});
  EXPECT_TRUE(beside.parameters[0].at_end());
  const std::vector<std::string> said = meaning(beside, test.measured);
  EXPECT_TRUE(std::ranges::any_of(
      said, [](const std::string& one) { return one.starts_with("restitution.1 stands at an end"); }));
}

TEST(Fit, TakesParametersOfOneForm) {
  const VariedKey parameter = varied_key("--vary", "blocks.1.width=0.3:5e-1");
  EXPECT_EQ(parameter.key, "blocks.1.width");
  EXPECT_EQ(parameter.low, 0.3);
  EXPECT_EQ(parameter.high, 0.5);
  for (const char* wrong : {"width", "width=1", "width=2:1", "=1:2", "width=a:2"})
    EXPECT_THROW(varied_key("--vary", wrong), InputError) << wrong;
}

/// The error of a table [measured] with those lines, without its place where it is of the table.
std::string error_of(const std::string& lines, const std::string& readings) {
  std::string scene = measured_block;
  try {
    Tested(scene.erase(scene.find("file =")) + lines, readings);
  } catch (const InputError& error) {
    const std::string line = error.what();
    return line.substr(line.find("measured") == std::string::npos ? 0 : line.find("measured"));
  }
  return {};
}

TEST(Measured, IsOfItsColumnUnitAndStart) {
  std::string scene = measured_block;
  scene.erase(scene.find("column"));
  const Tested test(scene + "time = \"t\"\ncolumn = \"deg\"\nunit = \"deg\"\nstart = 10\n",
                    "t,deg\n9.9,1\n10,180\n10.5,\n11,-90\n14,2\n");
  EXPECT_EQ(test.measured.times, (std::vector<double>{0, 0.5, 1}));
  EXPECT_DOUBLE_EQ(test.measured.values[0], std::acos(-1.0));
  EXPECT_TRUE(std::isnan(test.measured.values[1]));
  const std::vector<VariedKey> one{unknown[0]};
  const FittedScene fitted(test.document, test.measured, one, 3);
  EXPECT_EQ(fitted.places(), (std::vector<std::size_t>{0, 2}));
}

TEST(Measured, IsReadAsRecordsAre) {
  const std::string head = "\xEF\xBB\xBF";
  for (const std::string& readings :
       {head + "time,angle\r\n0,0.5\r\n0.5,-0.25\r\n",
        std::string("Zeit;time (s);angle (rad)\n1;0,0;0,5\n2;0,5;-0,25\n"),
        std::string("time,angle,pattern\n0,0.5,R\n0.5,-0.25,rest\n"),
        std::string("time\tangle\n0,0\t0,5\n0,5\t-0,25\n"),
        std::string("# a test\n\"time\",\"angle\"\nms,mrad\n0,500\n500,-250\n")}) {
    const Tested test(measured_block, readings);
    EXPECT_EQ(test.measured.times, (std::vector<double>{0, 0.5})) << readings;
    EXPECT_EQ(test.measured.values, (std::vector<double>{0.5, -0.25})) << readings;
  }
}

TEST(Measured, UnitsAreReadOfTitlesAndHeadersOrRefused) {
  const std::string lines = "file = \"test.csv\"\ncolumn = \"angle\"\n";
  const std::string rows = "\n0,1\n0.5,2\n";
  for (const std::string head :
       {"time,angle_deg", "# units: deg\ntime,angle", "# angle in degrees\ntime,angle",
        "# units: s, deg\ntime,angle", "time,angle [\u00b0]", "# Winkel in deg\ntime,angle"}) {
    const Tested test(measured_block, head + rows);
    EXPECT_DOUBLE_EQ(test.measured.values[0], std::acos(-1.0) / 180) << head;
  }
  const Tested milliseconds(measured_block, "# time in ms\ntime,angle (deg)\n0,1\n500,2\n");
  EXPECT_DOUBLE_EQ(milliseconds.measured.times[1], 0.5);
  for (const std::string unit :
       {"(grad)", "[gon]", "(gradi)", "[derece]", "[\u03bc\u03bf\u03af\u03c1\u03b5\u03c2]", "(%)", "[mm/m]",
        "[V]", "(deg/s)", "(rad/s)", "(arcmin)"})
    EXPECT_NE(
        error_of(lines, "time,angle " + unit + rows).find("has no unit of angle: must be rad, mrad or deg"),
        std::string::npos)
        << unit;
  EXPECT_NE(error_of(lines, "# units: gon\ntime,angle" + rows).find("'gon' is no unit of angle"),
            std::string::npos);
  EXPECT_NE(
      error_of(lines, "# units: deg\n# angle in rad\ntime,angle" + rows).find("names another unit of angle"),
      std::string::npos);
  EXPECT_NE(error_of(lines, "time,angle\n0.00,0.12\n0.01,0.1").find("this line has no end"),
            std::string::npos);
  EXPECT_NE(error_of(lines, "time,angle\n0,0.12\n10,0.1\n").find("more than one reading within"),
            std::string::npos);
}

TEST(Measured, AnglesBeyondTopplingNeedAUnit) {
  const std::string lines = "file = \"test.csv\"\ncolumn = \"angle\"\n";
  const std::string readings = "time,angle\n0,0.2\n0.5,6\n";
  // Halfway from the slenderness angle, 0.245, to π/2.
  EXPECT_EQ(
      error_of(lines, readings),
      "measured.column = \"angle\": must be of angles in rad: 6 at 0.5 s is beyond 0.9079, where block 1 has "
      "toppled; say unit = \"deg\", or unit = \"rad\" where it is meant");
  EXPECT_EQ(error_of(lines + "unit = \"rad\"\n", readings), "");
  EXPECT_EQ(error_of(lines + "unit = \"deg\"\n", readings), "");
}

TEST(Measured, MistakesAreRefused) {
  const std::string file = "file = \"test.csv\"\n", angle = "column = \"angle\"\n";
  EXPECT_EQ(error_of(file, "time,angle\n0,1\n"), "measured.column: missing, must be the name of a column");
  EXPECT_EQ(
      error_of(file + "column = [\"angle\", \"b\"]\n", "time,angle,b\n0,1,1\n"),
      "measured.column = an array of 2: must be as many names as there are blocks from `block` up, or fewer");
  for (const char* titles : {"time,angle,angle", "time,angle (rad),angle (deg)", "time,time,angle"})
    EXPECT_NE(error_of(file + angle, std::string(titles) + "\n0,1,2\n").find("several columns are "),
              std::string::npos)
        << titles;
  EXPECT_EQ(error_of(file + angle + "unit = \"mm\"\n", "time,angle\n0,1\n"),
            "measured.unit = \"mm\": must be \"rad\" or \"mrad\" or \"deg\"");
  EXPECT_EQ(
      error_of(file + angle, "time,angle\n0,1\n0,2\n"),
      "measured.file = \"test.csv\": must be a file with times that ascend, those of its reading 2 do not");
  EXPECT_EQ(error_of(file + angle, "time,angle\n5,1\n"),
            "measured.file = \"test.csv\": must be a file with readings within the scene's duration");
}

TEST(Measured, APointMovesWithItsBlock) {
  std::string scene = measured_block;
  scene.replace(scene.find("\"small-angle\""), 13, "\"nonlinear\"");
  const Tested test(scene + "unit = \"mm\"\npoint = [0.1, 0.7]\n", "time,angle\n0,1\n");
  EXPECT_DOUBLE_EQ(test.measured.values[0], 1e-3);
  MotionLibrary library;
  const Scene made = make_scene(test.document, library);
  const History history = solve(made, {.sample_times = {0}});
  const auto list = readings_of(test.measured, made, history, centres_of(made, history));
  // About the lower right corner.
  const double expected =
      half_width + (0.1 - half_width) * std::cos(start) + (0.7 + half_height) * std::sin(start) - 0.1;
  EXPECT_NEAR(list[0], expected, 1e-15);
}

}  // namespace
}  // namespace rockstack
