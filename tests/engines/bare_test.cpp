// Adapters beside bare programs (bare/), which share no code with them: what each engine makes of a scene by
// its library's own calls is what the adapter says that it makes.
//
// Both are given the same numbers and make the same calls, so that the same bits come out, however the motion
// multiplies rounding. What differs is known. Angles are read from other elements of the rotation: by the
// rounding of those, at most two units in the last place of 1. In ODE each step's rotation is put back into
// the plane by other operations, and the motion may multiply that rounding: 1e-13 rad was measured, 1e-9 rad
// is allowed. With unitMass adapters divide masses by the stack's, which is a power of two here, so that
// nothing is rounded.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numbers>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engines/placement.hpp"
#include "engines/worker/registry.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

constexpr double step = 1e-3;  // s

/// Blocks of one material that together have 4096 kg.
std::vector<Block> stack_of(const std::vector<std::pair<double, double>>& sizes) {
  constexpr double whole = 4096;
  double area = 0, left = whole;
  for (const auto& [width, height] : sizes) area += width * height;
  std::vector<Block> blocks;
  for (const auto& [width, height] : sizes) {
    Block block = make_block(width, height, whole / area);
    const double mass = blocks.size() + 1 == sizes.size() ? left : block.mass;
    block.inertia *= mass / block.mass;
    block.mass = mass;
    left -= mass;
    blocks.push_back(block);
  }
  return blocks;
}

/// Spanos et al. 2001's two blocks, a slender block, and one that a sine of the ground lifts.
std::vector<Scene> scenes() {
  std::vector<Scene> list(3);
  list[0].duration = 1.5;
  list[0].blocks = stack_of({{1.25, 1.25}, {1, 2.5}});
  list[0].initial = {{0.15, 0.15}, {0, 0}};
  list[1].duration = 2;
  list[1].blocks = stack_of({{0.5, 2.5}});
  list[1].initial = {{0.1}, {0}};
  list[2].duration = 0.9;
  list[2].blocks = stack_of({{0.4, 2}});
  list[2].initial = {{0}, {0}};
  list[2].horizontal.pulse = Pulse{PulseShape::sine, 5, 0.8, 0, 1, 0};
  return list;
}

/// What a bare program reads: the scene in plain numbers, and those settings that are not the library's own.
std::string question(const WorkerEngine& engine, const Scene& scene, const Parameters& parameters) {
  const double mass = mass_factor(scene, parameters);
  double reach = scene.engine.depth;
  for (const Block& block : scene.blocks) reach += 2 * (block.half_width + block.half_height);
  const double steps = std::floor(scene.duration / step + 1e-9);
  std::string text = fmt::format("solver {} gravity {} friction {} dt {} steps {}\n", engine.solver(),
                                 scene.gravity, scene.engine.friction, step, steps);
  if (engine.name() != "ode") text += fmt::format("reach {}\n", 10 * reach);
  for (const Placement& block : place(scene)) {
    text += fmt::format("block {} {} {} {} {} {} {} {} {} {}\n", block.width, block.height, block.depth,
                        mass * block.mass, mass * block.inertia_about_x, mass * block.inertia_about_y,
                        mass * block.inertia, block.x, block.y, block.angle);
  }
  for (const Setting& setting : engine.settings()) {
    double value = parameters.at(setting.name);
    if (value == setting.standard || setting.name == "unitMass") continue;
    if (setting.name == "contactStiffness" || setting.name == "contactDamping") value *= mass;
    if (setting.name == "slip1") value /= mass;
    text += fmt::format("set {} {}\n", setting.name, value);
  }
  for (double k = 0; k < steps && is_shaken(scene); ++k) {
    text += fmt::format("shake {} 0\n", mean_acceleration(scene.horizontal, k * step, (k + 1) * step));
  }
  return text;
}

/// The angles that a bare program prints, step after step.
std::vector<double> bare_angles(const WorkerEngine& engine, const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path input = folder.write("question", text);
  std::string name = engine.name();
  std::replace(name.begin(), name.end(), '-', '_');
  const std::string command = fmt::format("'{}/bare_{}' < '{}'", BARE_PROGRAMS, name, input.string());
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t length = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), length);
  if (::pclose(pipe) != 0) throw std::runtime_error("a bare program does not take this:\n" + text);
  std::istringstream words(output);
  std::vector<double> angles;
  for (std::string word; words >> word;) angles.push_back(std::stod(word));
  return angles;
}

struct Case {
  const WorkerEngine* engine;
  std::string name;
  Parameters parameters;
};

/// Settings that neither set has, each by itself.
std::vector<Parameters> more_settings(const WorkerEngine& engine) {
  if (engine.name() == "ode")
    return {{{"contactStiffness", 1e8}, {"contactDamping", 1e5}}, {{"slip1", 1e-6}}};
  return {{{"ground", 1}},
          {{"shape", 1}},
          {{"splitImpulse", 0}, {"contactStiffness", 1e8}, {"contactDamping", 1e5}},
          {{"frictionAnchor", 1}, {"frictionERP", 0.5}}};
}

std::vector<Case> cases() {
  std::vector<Case> list;
  for (const WorkerEngine& engine : engines()) {
    const std::string solver = engine.name() + ":" + engine.solver() + ":";
    list.push_back({&engine, solver + "default", engine.default_parameters()});
    list.push_back({&engine, solver + "tuned", engine.tuned_parameters()});
    for (const Parameters& more : more_settings(engine)) {
      Parameters parameters = engine.tuned_parameters();
      for (const auto& [name, value] : more) parameters[name] = value;
      list.push_back({&engine, solver + more.rbegin()->first, parameters});
    }
  }
  return list;
}

void PrintTo(const Case& one, std::ostream* out) {
  *out << one.name;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

double tolerance(const WorkerEngine& engine) {
  if (engine.name() == "ode") return 1e-9;
  return 2 * (engine.name() == "bullet" ? std::numeric_limits<double>::epsilon()
                                        : std::numeric_limits<float>::epsilon());
}

class Bare : public testing::TestWithParam<Case> {};

TEST_P(Bare, ProgramGivesTheAdaptersHistory) {
  const WorkerEngine& engine = *GetParam().engine;
  for (const Scene& scene : scenes()) {
    const History history = simulate(engine, scene, step, GetParam().parameters).history;
    const std::vector<double> bare = bare_angles(engine, question(engine, scene, GetParam().parameters));
    ASSERT_GE(bare.size(), history.angles.size());
    for (std::size_t i = 0; i < history.angles.size(); ++i) {
      // An angle past a turn is printed without it.
      const double difference = std::remainder(bare[i] - history.angles[i], 2 * std::numbers::pi);
      ASSERT_NEAR(difference, 0, tolerance(engine)) << history.times[i / scene.blocks.size()] << " s";
    }
  }
}

TEST(BareSettings, ChangeTheMotion) {
  for (const Case& one : cases()) {
    const Parameters tuned = one.engine->tuned_parameters();
    if (one.parameters == tuned) continue;
    bool changed = false;
    for (const Scene& scene : scenes()) {
      changed = changed || simulate(*one.engine, scene, step, one.parameters).history.angles !=
                               simulate(*one.engine, scene, step, tuned).history.angles;
    }
    EXPECT_TRUE(changed) << one.name;
  }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Bare);
INSTANTIATE_TEST_SUITE_P(Engines, Bare, testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace rockstack
