#include <fmt/format.h>

#include "engines/formats/model_text.hpp"

namespace rockstack {
namespace {

/// A link with a box of that name, and what fastens it.
std::string link(const Placement& block, std::size_t number) {
  const std::string box =
      fmt::format("<origin xyz=\"{}\" rpy=\"0 0 0\"/><geometry><box size=\"{} {} {}\"/></geometry>",
                  middle_text(block), block.width, block.depth, block.height);
  return fmt::format(
      R"(  <link name="block_{0}">
    <inertial>
      <mass value="{1}"/>
      <inertia ixx="{2}" iyy="{3}" izz="{4}" ixy="0" ixz="0" iyz="0"/>
    </inertial>
    <collision>{5}</collision>
    <visual>{5}</visual>
  </link>
  <joint name="plane_{0}" type="planar">
    <parent link="world"/>
    <child link="block_{0}"/>
    <origin xyz="{6} 0 {7}" rpy="0 {8} 0"/>
    <axis xyz="0 1 0"/>
  </joint>
)",
      number, block.mass, block.inertia_about_x, block.inertia, block.inertia_about_y, box, block.x, block.y,
      block.angle);
}

std::string ground(double reach) {
  const double thickness = reach / 10;
  return fmt::format(R"(  <link name="world"/>
  <link name="ground">
    <collision><geometry><box size="{0} {0} {1}"/></geometry></collision>
  </link>
  <joint name="ground" type="fixed">
    <parent link="world"/>
    <child link="ground"/>
    <origin xyz="0 0 {2}" rpy="0 0 0"/>
  </joint>
)",
                     2 * reach, 2 * thickness, -thickness);
}

std::string wall(const FixedBox& box) {
  const std::string shape =
      fmt::format("<geometry><box size=\"{} {} {}\"/></geometry>", box.width, box.depth, box.height);
  return fmt::format(R"(  <link name="wall">
    <collision>{0}</collision>
    <visual>{0}</visual>
  </link>
  <joint name="wall" type="fixed">
    <parent link="world"/>
    <child link="wall"/>
    <origin xyz="{1} 0 {2}" rpy="0 0 0"/>
  </joint>
)",
                     shape, box.x, box.y);
}

std::string velocities(const Setup& setup) {
  std::string text;
  for (const Placement& block : setup.blocks)
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", block.velocity_x, block.velocity_y,
                        block.angular_velocity);
  return text;
}

std::string urdf_usage(const ModelScene& scene) {
  return fmt::format(
      R"(Joints keep blocks in the plane; where they are zero blocks are at the start. The scene takes {0}.
Drake: Parser(plant).AddModels("{1}"). Isaac Sim: File, Import, URDF. Genesis: gs.morphs.URDF(file="{1}", fixed=True). A script sets what is not here.
)",
      steps_text(scene), scene.file);
}

}  // namespace

ModelFile urdf_of(const ModelScene& scene) {
  const Setup& setup = scene.setup;
  std::vector<std::string> left_out{
      fmt::format("gravity {} 0 {} m/s²", setup.gravity.x, setup.gravity.y),
      fmt::format("friction {} of the interfaces from the ground up", fmt::join(setup.friction, " "))};
  if (starts_in_motion(setup))
    left_out.push_back(fmt::format("velocities at the start along x and z and about y, of each block: {}",
                                   velocities(setup)));
  for (std::string& more : left_out_everywhere(scene, false)) left_out.push_back(std::move(more));
  std::string blocks = setup.wall ? wall(*setup.wall) : "";
  for (std::size_t k = 0; k < setup.blocks.size(); ++k) blocks += link(setup.blocks[k], k + 1);
  return {fmt::format("<?xml version=\"1.0\"?>\n{}<robot name=\"{}\">\n{}{}</robot>\n",
                      head_comment(scene, urdf_usage(scene), left_out), scene.name,
                      ground(ground_reach(setup.blocks)), blocks),
          left_out};
}

}  // namespace rockstack
