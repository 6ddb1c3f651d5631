// MuJoCo beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "engines/mujoco/simulation.hpp"

namespace rockstack {
namespace {

/// A negative number of solref is a stiffness or a damping.
std::vector<Setting> settings_of(MujocoSolver solver) {
  const bool pgs = solver == MujocoSolver::pgs;
  return {
      {.name = "integrator", .choices = {"Euler", "RK4", "implicit"}},
      {.name = "cone", .choices = {"pyramidal", "elliptic"}, .standard = 1},
      {.name = "solref_timeconst",
       .unit = "s",
       .standard = 0.02,
       .tuned = 1e-3,
       .least = -stiffest,
       .most = stiffest},
      {.name = "solref_dampratio",
       .standard = 1,
       .tuned = pgs ? 6.0 : 3.0,
       .least = -stiffest,
       .most = stiffest},
      {.name = "solimp_d0", .standard = 0.9, .tuned = 0.995, .most = 1},
      {.name = "solimp_dwidth", .standard = 0.95, .tuned = 0.995, .most = 1},
      {.name = "solimp_width", .unit = "m", .standard = 1e-3},
      {.name = "solimp_midpoint", .standard = 0.5, .most = 1},
      {.name = "solimp_power", .standard = 2, .least = 1},
      {.name = "margin", .unit = "m"},
      {.name = "gap", .unit = "m"},
      {.name = "impratio", .standard = 1, .least = 1e-6, .most = 1e6},
      count_setting("iterations", 100, pgs ? 300 : 100),
      {.name = "tolerance", .standard = 1e-8, .tuned = 1e-12, .most = 1},
      {.name = "noslip_iterations", .most = 1e6, .whole = true},
      {.name = "noslip_tolerance", .standard = 1e-6, .most = 1},
      switch_setting("refsafe", true, true),
      switch_setting("warmstart", true, true),
      {.name = "ground", .choices = {"plane", "box"}},
      {.name = "depth_ratio", .standard = 1, .tuned = 0.9, .least = 0.1, .most = 10},
      {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
      shaking_setting(),
  };
}

Engine with(MujocoSolver solver, const char* name) {
  return {{.name = "mujoco",
           .solver = name,
           .version = std::string(mj_versionString()) + ", double precision",
           .licence = "Apache-2.0",
           .capabilities = {.planar = true},
           .settings = settings_of(solver)},
          std::bind_front(start_mujoco, solver)};
}

/// kg on each of a moving ground's coordinates, without gravity: whatever presses on it, it goes as told.
constexpr double unmoved = 1e30;

/// Of blocks, kg and kg m²: solvers' tolerances are relative to it, and with a moving ground's they stop.
double mean_inertia(const Setup& setup, double masses) {
  double sum = 0;
  for (const Placement& block : setup.blocks) sum += masses * (2 * block.mass + block.inertia);
  return sum / (3 * static_cast<double>(setup.blocks.size()));
}

/// A geom meets others by `pairs` alone.
std::string geom(std::size_t number, const std::string& shape) {
  return fmt::format("<geom name='{}' contype='0' conaffinity='0' {}/>", number, shape);
}

std::string ground(const Setup& setup, const Parameters& parameters) {
  if (setup.ground.empty() && parameters.at("ground") == 0)
    return geom(0, "type='plane' zaxis='0 1 0' size='0 0 1'");
  const double half = ground_reach(setup.blocks);
  std::string box =
      geom(0, fmt::format("type='box' size='{} {} {}' pos='0 {} 0'", half, half / 10, half, -half / 10));
  if (setup.ground.empty()) return box;
  return fmt::format(
      "<body><joint type='slide' axis='1 0 0' armature='{0}'/><joint type='slide' axis='0 1 0' "
      "armature='{0}'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>{1}</body>",
      unmoved, box);
}

/// Two slides and a hinge through the centre, so that moments of inertia about x and y have no effect.
std::string body(const Placement& block, std::size_t number, double masses, double depth) {
  return fmt::format(
      "<body><joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/><joint type='hinge' "
      "axis='0 0 1'/><inertial pos='0 0 0' mass='{0}' diaginertia='{1} {1} {1}'/>{2}</body>",
      masses * block.mass, masses * block.inertia,
      geom(number, fmt::format("type='box' size='{} {} {}'", block.width / 2, block.height / 2, depth / 2)));
}

std::string surface(const Parameters& given) {
  return fmt::format("solref='{} {}' solimp='{} {} {} {} {}' margin='{}' gap='{}'",
                     given.at("solref_timeconst"), given.at("solref_dampratio"), given.at("solimp_d0"),
                     given.at("solimp_dwidth"), given.at("solimp_width"), given.at("solimp_midpoint"),
                     given.at("solimp_power"), given.at("margin"), given.at("gap"));
}

/// Every two bodies may touch, with the friction of the interface under the upper one in both directions.
std::string pairs(const Setup& setup, const Parameters& parameters) {
  const std::string alike = surface(parameters);
  std::string text;
  for (std::size_t upper = 1; upper <= setup.blocks.size(); ++upper) {
    const double friction = setup.friction[upper - 1];
    for (std::size_t lower = 0; lower < upper; ++lower)
      text += fmt::format("<pair geom1='{}' geom2='{}' condim='{}' friction='{} {} 0 0 0' {}/>", lower, upper,
                          friction > 0 ? 3 : 1, friction, friction, alike);
  }
  return text;
}

std::string stack_text(const Setup& setup, const Parameters& parameters) {
  const double masses = mass_factor(setup, parameters);
  std::string blocks;
  double share = 1;
  for (std::size_t k = 0; k < setup.blocks.size(); ++k, share *= parameters.at("depth_ratio"))
    blocks += body(setup.blocks[k], k + 1, masses, share * setup.blocks[k].depth);
  return fmt::format("<mujoco><worldbody>{}{}</worldbody><contact>{}</contact></mujoco>",
                     ground(setup, parameters), blocks, pairs(setup, parameters));
}

}  // namespace

std::vector<Engine> make_mujoco() {
  return {with(MujocoSolver::newton, "newton"), with(MujocoSolver::cg, "cg"), with(MujocoSolver::pgs, "pgs")};
}

MujocoModel compile_stack(const Setup& setup, const Parameters& parameters) {
  // The library reads its models from files alone: this one is in memory.
  constexpr const char* name = "stack.xml";
  const std::string text = stack_text(setup, parameters);
  const std::unique_ptr<mjVFS, void (*)(mjVFS*)> files(new mjVFS{}, [](mjVFS* made) {
    mj_deleteVFS(made);
    delete made;
  });
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())),
                    mj_deleteModel);
  mj_freeLastXML();
  if (!model) throw std::runtime_error(fmt::format("mujoco: {}", error.data()));
  if (!setup.ground.empty()) model->stat.meaninertia = mean_inertia(setup, mass_factor(setup, parameters));
  return model;
}

}  // namespace rockstack
