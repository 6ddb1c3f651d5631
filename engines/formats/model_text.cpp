#include "engines/formats/model_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "analytic/scene/messages/one_line.hpp"
#include "engines/scene_setup.hpp"

namespace rockstack {
namespace {

/// A text that may stand in a comment of XML.
std::string in_comment(std::string text) {
  text = one_line(text);
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at))
    text.replace(at, 2, "- -");
  return text;
}

}  // namespace

ModelScene model_scene(const Scene& scene, const std::string& name, double dt, const std::string& file) {
  const std::filesystem::path path = file;
  ModelScene made{.name = name,
                  .title = scene.title,
                  .setup = set_up(scene, dt, {}),
                  .restitution = scene.point_restitution,
                  .file = path.filename().string()};
  if (is_shaken(scene)) {
    made.ground = ground_path(scene, dt, made.setup.steps);
    made.table = path.stem().string() + "-ground.csv";
  }
  return made;
}

std::vector<double> surface_friction(const std::vector<double>& interfaces) {
  std::vector<double> list;
  for (std::size_t k = 0; k <= interfaces.size(); ++k)
    list.push_back(std::max(interfaces[k == 0 ? 0 : k - 1], interfaces[std::min(k, interfaces.size() - 1)]));
  return list;
}

std::vector<std::size_t> wrong_interfaces(const std::vector<double>& interfaces) {
  const std::vector<double> surfaces = surface_friction(interfaces);
  std::vector<std::size_t> list;
  for (std::size_t k = 0; k < interfaces.size(); ++k)
    if (std::min(surfaces[k], surfaces[k + 1]) != interfaces[k]) list.push_back(k + 1);
  return list;
}

std::string middle_text(const Placement& block) {
  return fmt::format("{} 0 {}", 0 - block.offset_x, 0 - block.offset_y);  // 0, not -0, in the middle
}

bool starts_in_motion(const Setup& setup) {
  return std::ranges::any_of(setup.blocks, [](const Placement& block) {
    return block.velocity_x != 0 || block.velocity_y != 0 || block.angular_velocity != 0;
  });
}

std::vector<std::string> left_out_everywhere(const ModelScene& scene, bool bounces) {
  std::vector<std::string> list;
  if (!scene.ground.empty()) list.emplace_back("the ground's motion");
  if (const auto& sliding = scene.setup.kinetic_friction; !sliding.empty())
    list.push_back(fmt::format("kinetic_friction {}", fmt::join(sliding, " ")));
  if (!scene.setup.pushes.empty()) list.emplace_back("pushes");
  if (!scene.setup.restraints.empty()) list.emplace_back("tendons and dampers");
  if (scene.restitution > 0 && !bounces) list.push_back(fmt::format("restitution {}", scene.restitution));
  return list;
}

std::string head_comment(const ModelScene& scene, const std::string& lines,
                         const std::vector<std::string>& left_out) {
  std::string text = fmt::format(
      "<!--\n{}{}rockstack wrote this from the scene {}.\nAxes: x to the right, z up, y into the picture; a "
      "clockwise angle is a positive turn about y. A body's origin is its centre of mass. SI units.\n{}",
      in_comment(scene.title), scene.title.empty() ? "" : "\n", in_comment(scene.name), lines);
  if (!scene.ground.empty())
    text += fmt::format(
        "{} has a line a step: gravity for a ground at rest, or displacement and velocity of one that moves.\n",
        in_comment(scene.table));
  text += fmt::format(
      "Back to rockstack: write time, x_1, y_1, z_1, qw_1, qx_1, qy_1, qz_1, x_2, … (or in the plane x_1, y_1 "
      "up, theta_1, …) to run.csv, then\n  rockstack compare {} with the option trajectory NAME=run.csv\n",
      in_comment(scene.name));
  if (!left_out.empty()) text += fmt::format("Not in this file: {}.\n", fmt::join(left_out, "; "));
  return text + "-->\n";
}

std::string steps_text(const ModelScene& scene) {
  return fmt::format("{} steps of {} s", scene.setup.steps, scene.setup.dt);
}

std::string ground_table(const ModelScene& scene) {
  std::string text = "time,gravity_x,gravity_z,x_0,z_0,vx_0,vz_0\n";
  for (std::size_t i = 0; i < scene.ground.size(); ++i) {
    const BodyAcceleration& gravity = scene.setup.accelerations[i];
    const GroundStep& ground = scene.ground[i];
    text += fmt::format("{},{},{},{},{},{},{}\n", static_cast<double>(i) * scene.setup.dt, gravity.x,
                        gravity.y, ground.x, ground.y, ground.velocity_x, ground.velocity_y);
  }
  return text;
}

}  // namespace rockstack
