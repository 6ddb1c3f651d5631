#include "engines/mujoco/model.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>

namespace rockstack {
namespace {

/// kg on each of a moving ground's coordinates, on which gravity does not act: whatever presses on it, it
/// goes on as it was told.
constexpr double unmoved = 1e30;

/// Half the length of a ground that is a box: blocks never get to its ends.
double reach(const Setup& setup) {
  double sizes = setup.blocks.front().depth;
  for (const Placement& block : setup.blocks) sizes += block.width + block.height;
  return 10 * sizes;
}

/// Of the blocks' coordinates, kg and kg m². Solvers measure their tolerance against it, so that with a
/// moving ground's they would stop at once.
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
  const double half = reach(setup);
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

/// Every two bodies may touch, with the friction of the interface under the upper one; one coefficient for
/// each of both directions in the face.
std::string pairs(const Setup& setup, const Parameters& parameters) {
  const std::string alike = surface(parameters);
  std::string text;
  for (std::size_t upper = 1; upper <= setup.blocks.size(); ++upper) {
    const double friction = setup.friction[upper - 1];
    for (std::size_t lower = 0; lower < upper; ++lower) {
      text += fmt::format("<pair geom1='{}' geom2='{}' condim='{}' friction='{} {} 0 0 0' {}/>", lower, upper,
                          friction > 0 ? 3 : 1, friction, friction, alike);
    }
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

/// A file in memory, as the library reads its models from files alone.
class TextFile {
 public:
  explicit TextFile(const std::string& text) {
    mj_defaultVFS(files_.get());
    mj_makeEmptyFileVFS(files_.get(), name, static_cast<int>(text.size()));
    std::memcpy(files_->filedata[0], text.data(), text.size());
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  ~TextFile() { mj_deleteVFS(files_.get()); }

  static constexpr const char* name = "stack.xml";
  const mjVFS* files() const { return files_.get(); }

 private:
  std::unique_ptr<mjVFS> files_ = std::make_unique<mjVFS>();
};

}  // namespace

void DeleteModel::operator()(mjModel_* model) const {
  mj_deleteModel(model);
}

MujocoModel compile_stack(const Setup& setup, const Parameters& parameters) {
  const TextFile file(stack_text(setup, parameters));
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML(TextFile::name, file.files(), error.data(), static_cast<int>(error.size())));
  mj_freeLastXML();
  if (!model) throw std::runtime_error(fmt::format("mujoco: {}", error.data()));
  if (!setup.ground.empty()) model->stat.meaninertia = mean_inertia(setup, mass_factor(setup, parameters));
  return model;
}

}  // namespace rockstack
