// Error against run time on stiff springs, in one run: stiff_time [LEAST [MOST]] prints a table as
// CSV for stiffnesses from 10^LEAST to 10^MOST N/m (5 … 12 unless given) and damping ratios of 0.1 and 1.
//
// A block of 0.5 m × 1 m is released at 0.1 rad on springs and dashpots at its corners, with a coefficient of
// friction of 1, and rocks for a second. Error: RMS, over samples 10 ms apart, of the difference of its angle
// to the solver in long double, rad. Time: processor time without those samples, the least of
// five runs by turns.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "analytic/solver/to_double.hpp"
#include "analytic/unilateral/solve_contacts.hpp"
#include "engines/engine.hpp"
#include "tests/analytic/unilateral/solve_unilateral.hpp"
#include "tests/benchmarks/processor_time.hpp"
#include "tests/benchmarks/sprung_block.hpp"
#include "tests/engines/linked_engines.hpp"

namespace rockstack::benchmarks {
namespace {

constexpr double duration = 1.0;  // s
constexpr int points_a_corner = 2;

Scene sprung_scene(double stiffness, double damping_ratio) {
  Scene scene;
  scene.duration = duration;
  scene.law = Law::compliant;
  scene.blocks = {make_block(0.5, 1, 2500)};
  scene.initial = {{0.1}, {0}};
  scene.friction = {1};
  scene.initial.preloaded = false;  // as engines place blocks
  scene.springs.stiffness = {stiffness};
  scene.springs.damping = {2 * damping_ratio * std::sqrt(stiffness * scene.blocks.front().mass)};
  return scene;
}

template <class Real>
std::vector<double> angles_by(const Scene& scene, const std::vector<double>& samples) {
  return in_double(solve_contacts<Real>(scene, {.sample_times = samples}).angles);
}

struct Contender {
  std::string name;
  std::function<std::vector<double>(const Scene&, const std::vector<double>&)> angles;
  std::function<double(const Scene&)> seconds;
};

Contender ours() {
  return {"rockstack", angles_by<double>,
          [](const Scene& scene) { return processor_seconds([&] { solve_unilateral(scene); }); }};
}

Contender bdf(double tolerance) {
  char name[32];
  std::snprintf(name, sizeof name, "CVODE BDF %.0e", tolerance);
  return {name,
          [=](const Scene& scene, const std::vector<double>& samples) {
            return sprung_by_bdf(scene, tolerance, samples).angles;
          },
          [=](const Scene& scene) {
            return processor_seconds([&] { sprung_by_bdf(scene, tolerance, {scene.duration}); });
          }};
}

Parameters springs_of(const Engine& engine, const Scene& scene) {
  Parameters parameters = engine.default_parameters();
  parameters["contactStiffness"] = scene.springs.stiffness.front() / points_a_corner;
  parameters["contactDamping"] = scene.springs.damping.front() / points_a_corner;
  if (engine.name == "bullet") parameters["splitImpulse"] = 0;
  return parameters;
}

Contender stepped_by(const Engine& engine, double dt) {
  char name[48];
  std::snprintf(name, sizeof name, "%s, %g s", engine.name.c_str(), dt);
  const auto as_rigid = [](Scene scene) {
    scene.law = Law::unilateral;
    scene.springs = {};
    return scene;
  };
  return {name,
          [=, &engine](const Scene& scene, const std::vector<double>& samples) {
            const History history = simulate(engine, as_rigid(scene), dt, springs_of(engine, scene)).history;
            std::vector<double> angles;
            angles.reserve(samples.size());
            for (const double sample : samples)
              angles.push_back(
                  history.angles_at(std::min<std::size_t>(std::lround(sample / dt), history.size() - 1))[0]);
            return angles;
          },
          [=, &engine](const Scene& scene) {
            const auto simulation = start(engine, as_rigid(scene), dt, springs_of(engine, scene));
            const std::clock_t begin = std::clock();
            for (long i = 0; i < std::lround(scene.duration / dt); ++i) simulation->step();
            return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
          }};
}

std::vector<Contender> contenders() {
  std::vector<Contender> all{ours()};
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) all.push_back(bdf(tolerance));
  for (const auto& engine : linked_engines()) {
    const std::string solver = engine->name + ':' + engine->solver;
    if (solver != "bullet:sequential-impulse" && solver != "ode:step") continue;
    for (const double dt : {1e-3, 1e-4}) all.push_back(stepped_by(*engine, dt));
  }
  return all;
}

double root_mean_square(const std::vector<double>& angles, const std::vector<double>& expected) {
  if (angles.size() != expected.size()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) sum += std::pow(angles[i] - expected[i], 2);
  return std::sqrt(sum / static_cast<double>(angles.size()));
}

/// The error and the least time of a contender, or that it cannot go on.
std::string cell(const Contender& contender, const Scene& scene, const std::vector<double>& samples,
                 const std::vector<double>& expected) {
  char text[64];
  try {
    const double error = root_mean_square(contender.angles(scene, samples), expected);
    double seconds = std::numeric_limits<double>::infinity();
    for (int turn = 0; turn < 5; ++turn) seconds = std::min(seconds, contender.seconds(scene));
    std::snprintf(text, sizeof text, ",%.1e,%.3g", error, 1e3 * seconds);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "%s, %g N/m: %s\n", contender.name.c_str(), scene.springs.stiffness.front(),
                 error.what());
    return ",no end,";
  }
  return text;
}

void print_row(double stiffness, double ratio, const std::vector<Contender>& all) {
  constexpr double apart = 0.01;  // s
  const Scene scene = sprung_scene(stiffness, ratio);
  std::vector<double> samples;
  for (int i = 1; i * apart <= duration * (1 + 1e-12); ++i) samples.push_back(i * apart);
  const std::vector<double> expected = angles_by<long double>(scene, samples);
  std::printf("%g,%.0e", ratio, stiffness);
  for (const Contender& contender : all) std::printf("%s", cell(contender, scene, samples, expected).c_str());
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace rockstack::benchmarks

int main(int arguments, char** values) try {
  using namespace rockstack::benchmarks;
  const int least = arguments > 1 ? std::atoi(values[1]) : 5;
  const int most = arguments > 2 ? std::atoi(values[2]) : 12;
  const std::vector<Contender> all = contenders();
  std::printf("damping ratio,k (N/m)");
  for (const Contender& contender : all)
    std::printf(",%s (rad),%s (ms)", contender.name.c_str(), contender.name.c_str());
  std::printf("\n");
  for (const double ratio : {0.1, 1.0})
    for (int decade = least; decade <= most; ++decade) print_row(std::pow(10, decade), ratio, all);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
