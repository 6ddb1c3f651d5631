#include <fmt/format.h>

#include "engines/formats/model_text.hpp"

namespace rockstack {
namespace {

std::string body(const Placement& block, std::size_t number, double friction) {
  return fmt::format(
      R"(    <body name="block_{0}">
      <joint name="x_{0}" type="slide" axis="1 0 0"/>
      <joint name="z_{0}" type="slide" axis="0 0 1"/>
      <joint name="theta_{0}" type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0" mass="{1}" diaginertia="{2} {3} {4}"/>
      <geom name="block_{0}" type="box" size="{5} {6} {7}" pos="{8}" friction="{9} 0 0"/>
    </body>
)",
      number, block.mass, block.inertia_about_x, block.inertia, block.inertia_about_y, block.width / 2,
      block.depth / 2, block.height / 2, middle_text(block), friction);
}

std::string geom_name(std::size_t body) {
  return body == 0 ? "ground" : fmt::format("block_{}", body);
}

/// Every two bodies may touch, with the friction of the interface under the upper one in both directions.
std::string pairs(const Setup& setup) {
  std::string text;
  for (std::size_t upper = 1; upper <= setup.blocks.size(); ++upper) {
    const double friction = setup.friction[upper - 1];
    for (std::size_t lower = 0; lower < upper; ++lower)
      text += fmt::format(R"(    <pair geom1="{}" geom2="{}" condim="{}" friction="{} {} 0 0 0"/>)"
                          "\n",
                          geom_name(lower), geom_name(upper), friction > 0 ? 3 : 1, friction, friction);
    if (setup.wall)
      text += fmt::format(R"(    <pair geom1="wall" geom2="{}" condim="{}" friction="{} {} 0 0 0"/>)"
                          "\n",
                          geom_name(upper), friction > 0 ? 3 : 1, friction, friction);
  }
  return text;
}

std::string wall(const FixedBox& box, double friction) {
  return fmt::format(R"(    <geom name="wall" type="box" pos="{} 0 {}" size="{} {} {}" friction="{} 0 0"/>)"
                     "\n",
                     box.x, box.y, box.width / 2, box.depth / 2, box.height / 2, friction);
}

std::string keyframe(const Setup& setup) {
  std::vector<double> places, rates;
  for (const Placement& block : setup.blocks) {
    places.insert(places.end(), {block.x, block.y, block.angle});
    rates.insert(rates.end(), {block.velocity_x, block.velocity_y, block.angular_velocity});
  }
  return fmt::format(R"(<key name="start" qpos="{}" qvel="{}"/>)", fmt::join(places, " "),
                     fmt::join(rates, " "));
}

std::string mjcf_usage(const ModelScene& scene) {
  const bool shaken = !scene.ground.empty();
  std::string text = fmt::format(
      R"(Solver settings are MuJoCo's defaults but for the step and the elliptic cone. The scene takes {0}. MuJoCo, in Python:
  import mujoco, numpy
  model = mujoco.MjModel.from_xml_path("{1}")
  data = mujoco.MjData(model)
  mujoco.mj_resetDataKeyframe(model, data, 0)
)",
      steps_text(scene), scene.file);
  if (shaken)
    text +=
        fmt::format("  gravity = numpy.loadtxt(\"{}\", delimiter=\",\", skiprows=1)[:, 1:3]\n", scene.table);
  text += fmt::format(
      R"(  rows = [[0, *data.qpos]]
  for step in range({0}):
{1}      mujoco.mj_step(model, data)
      rows.append([data.time, *data.qpos])
  header = ",".join(["time"] + [f"x_{{k}},y_{{k}},theta_{{k}}" for k in range(1, {2})])
  numpy.savetxt("run.csv", rows, "%.17g", ",", header=header, comments="")
Drake: Parser(plant).AddModels("{3}"). Isaac Sim: File, Import, MJCF. Genesis: gs.morphs.MJCF(file="{3}").
They take gravity, step and start from their own scripts: option and keyframe below have the numbers.
)",
      scene.setup.steps, shaken ? "      model.opt.gravity[[0, 2]] = gravity[step]\n" : "",
      scene.setup.blocks.size() + 1, scene.file);
  return text;
}

}  // namespace

ModelFile mjcf_of(const ModelScene& scene) {
  const Setup& setup = scene.setup;
  const std::vector<std::string> left_out = left_out_everywhere(scene, false);
  const std::vector<double> friction = surface_friction(setup.friction);
  std::string blocks = setup.wall ? wall(*setup.wall, friction.front()) : "";
  for (std::size_t k = 0; k < setup.blocks.size(); ++k)
    blocks += body(setup.blocks[k], k + 1, friction[k + 1]);
  return {fmt::format(R"(<mujoco model="{}">
{}  <option timestep="{}" gravity="{} 0 {}" integrator="Euler" cone="elliptic" solver="Newton" iterations="100" tolerance="1e-8"/>
  <worldbody>
    <light pos="0 -10 10" dir="0 1 -1"/>
    <geom name="ground" type="plane" size="0 0 1" friction="{} 0 0"/>
{}  </worldbody>
  <contact>
{}  </contact>
  <keyframe>
    {}
  </keyframe>
</mujoco>
)",
                      scene.name, head_comment(scene, mjcf_usage(scene), left_out), setup.dt, setup.gravity.x,
                      setup.gravity.y, friction.front(), blocks, pairs(setup), keyframe(setup)),
          left_out};
}

}  // namespace rockstack
