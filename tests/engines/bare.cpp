#include "tests/engines/bare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "engines/scene_setup.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {

std::string bare_question(const WorkerEngine& engine, const Scene& scene, double step,
                          const Parameters& parameters) {
  const Setup setup = set_up(scene, step, parameters);
  const double mass = parameters.count("unitMass") != 0 ? mass_factor(setup, parameters) : 1;
  double reach = scene.depth;
  for (const Block& block : scene.blocks) reach += 2 * (block.half_width + block.half_height);
  const double steps = std::floor(scene.duration / step + 1e-9);
  std::string text = fmt::format("solver {} gravity {} friction {} dt {} steps {}\n", engine.solver,
                                 scene.gravity, friction_of(scene).front(), step, steps);
  if (engine.name != "ode") text += fmt::format("reach {}\n", 10 * reach);
  for (const Placement& block : setup.blocks) {
    text += fmt::format("block {} {} {} {} {} {} {} {} {} {}\n", block.width, block.height, block.depth,
                        mass * block.mass, mass * block.inertia_about_x, mass * block.inertia_about_y,
                        mass * block.inertia, block.x, block.y, block.angle);
  }
  for (const Setting& setting : engine.settings) {
    double value = parameters.at(setting.name);
    if (value == setting.default_value || setting.name == "unitMass") continue;
    if (setting.name == "contactStiffness" || setting.name == "contactDamping") value *= mass;
    if (setting.name == "slip1") value /= mass;
    text += fmt::format("set {} {}\n", setting.name, value);
  }
  for (double k = 0; k < steps && is_shaken(scene); ++k) {
    text += fmt::format("shake {} 0\n", mean_acceleration(scene.horizontal, k * step, (k + 1) * step));
  }
  return text;
}

std::vector<double> bare_angles(const std::string& engine, const std::string& question) {
  const TemporaryFolder folder;
  const std::filesystem::path input = folder.write("question", question);
  std::string name = engine;
  std::replace(name.begin(), name.end(), '-', '_');
  const std::string command = fmt::format("'{}/bare_{}' < '{}'", BARE_PROGRAMS, name, input.string());
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t length = std::fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), length);
  if (::pclose(pipe) != 0) throw std::runtime_error("a bare program does not take this:\n" + question);
  std::istringstream words(output);
  std::vector<double> angles;
  for (std::string word; words >> word;) angles.push_back(std::stod(word));
  return angles;
}

}  // namespace rockstack
