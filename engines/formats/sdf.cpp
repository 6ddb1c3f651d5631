#include <fmt/format.h>

#include "engines/formats/model_text.hpp"

namespace rockstack {
namespace {

std::string surface(double friction, double restitution) {
  const std::string bounce =
      restitution == 0 ? ""
                       : fmt::format("<bounce><restitution_coefficient>{}</restitution_coefficient></bounce>",
                                     restitution);
  return fmt::format("<surface>{0}<friction><ode><mu>{1}</mu><mu2>{1}</mu2></ode></friction></surface>",
                     bounce, friction);
}

std::string model(const Placement& block, std::size_t number, double friction, double restitution) {
  const std::string box =
      fmt::format("<pose>{} 0 0 0</pose><geometry><box><size>{} {} {}</size></box></geometry>",
                  middle_text(block), block.width, block.depth, block.height);
  return fmt::format(
      R"(    <model name="block_{}">
      <pose>{} 0 {} 0 {} 0</pose>
      <link name="link">
        <inertial>
          <mass>{}</mass>
          <inertia><ixx>{}</ixx><iyy>{}</iyy><izz>{}</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia>
        </inertial>
        <collision name="box">{}{}</collision>
        <visual name="box">{}</visual>
      </link>
    </model>
)",
      number, block.x, block.y, block.angle, block.mass, block.inertia_about_x, block.inertia,
      block.inertia_about_y, box, surface(friction, restitution), box);
}

std::string wall(const FixedBox& box, const std::string& surface) {
  const std::string shape =
      fmt::format("<geometry><box><size>{} {} {}</size></box></geometry>", box.width, box.depth, box.height);
  return fmt::format(
      R"(    <model name="wall">
      <static>true</static>
      <pose>{} 0 {} 0 0 0</pose>
      <link name="link">
        <collision name="box">{}{}</collision>
        <visual name="box">{}</visual>
      </link>
    </model>
)",
      box.x, box.y, shape, surface, shape);
}

std::string state(const ModelScene& scene) {
  std::string text = fmt::format("    <state world_name=\"{}\">\n", scene.name);
  for (std::size_t k = 0; k < scene.setup.blocks.size(); ++k) {
    const Placement& block = scene.setup.blocks[k];
    text += fmt::format(
        "      <model name=\"block_{0}\"><pose>{1} 0 {2} 0 {3} 0</pose><link name=\"link\"><pose>{1} 0 {2} 0 {3} "
        "0</pose><velocity>{4} 0 {5} 0 {6} 0</velocity></link></model>\n",
        k + 1, block.x, block.y, block.angle, block.velocity_x, block.velocity_y, block.angular_velocity);
  }
  return text + "    </state>\n";
}

/// What surfaces cannot have of the interfaces' friction; empty where they can.
std::string wrong_friction(const std::vector<double>& interfaces) {
  std::string text;
  for (const std::size_t wrong : wrong_interfaces(interfaces))
    text +=
        fmt::format("{}friction {} at interface {}", text.empty() ? "" : ", ", interfaces[wrong - 1], wrong);
  return text;
}

std::string sdf_usage(const ModelScene& scene) {
  return fmt::format(
      R"(Bodies are free, nothing holds them in the plane. Of two surfaces that meet the lesser friction counts, as in Gazebo with DART.
The scene takes {0}. Gazebo: gz sim -r {1}, poses are on the topic /world/{2}/dynamic_pose/info.
Drake, in Python, which takes step and gravity from the script:
  builder = DiagramBuilder()
  plant, graph = AddMultibodyPlantSceneGraph(builder, {3})
  Parser(plant).AddModels("{1}")
  plant.mutable_gravity_field().set_gravity_vector([{4}, 0, {5}])
  plant.Finalize()
)",
      steps_text(scene), scene.file, scene.name, scene.setup.dt, scene.setup.gravity.x,
      scene.setup.gravity.y);
}

}  // namespace

ModelFile sdf_of(const ModelScene& scene) {
  const Setup& setup = scene.setup;
  std::vector<std::string> left_out = left_out_everywhere(scene, true);
  if (const std::string wrong = wrong_friction(setup.friction); !wrong.empty()) left_out.push_back(wrong);
  if (starts_in_motion(setup))
    left_out.emplace_back("velocities at the start where a simulator passes over the state below");
  const std::vector<double> friction = surface_friction(setup.friction);
  std::string blocks = setup.wall ? wall(*setup.wall, surface(friction.front(), scene.restitution)) : "";
  for (std::size_t k = 0; k < setup.blocks.size(); ++k)
    blocks += model(setup.blocks[k], k + 1, friction[k + 1], scene.restitution);
  const double reach = 2 * ground_reach(setup.blocks);
  return {fmt::format(R"(<?xml version="1.0"?>
{}<sdf version="1.9">
  <world name="{}">
    <gravity>{} 0 {}</gravity>
    <physics name="step" type="ignored"><max_step_size>{}</max_step_size><real_time_factor>0</real_time_factor></physics>
    <model name="ground">
      <static>true</static>
      <link name="link">
        <collision name="plane"><geometry><plane><normal>0 0 1</normal><size>{} {}</size></plane></geometry>{}</collision>
      </link>
    </model>
{}{}  </world>
</sdf>
)",
                      head_comment(scene, sdf_usage(scene), left_out), scene.name, setup.gravity.x,
                      setup.gravity.y, setup.dt, reach, reach, surface(friction.front(), scene.restitution),
                      blocks, state(scene)),
          left_out};
}

}  // namespace rockstack
