// bare_mujoco_model MODEL.xml STEPS [GROUND.csv]: MuJoCo runs a model that it reads from a file, from the
// model's first keyframe, and tells where its bodies are as a simulator in space does: time, then of each
// body place, quaternion and the rates of both. With a table of the ground's motion each step has its
// gravity.

#include <mujoco/mujoco.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace {

/// Gravity along x and z of each step.
std::vector<std::array<double, 2>> read_gravity(const char* file) {
  std::vector<std::array<double, 2>> list;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::array<double, 2>& gravity = list.emplace_back();
    double time = 0;
    std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &gravity[0], &gravity[1]);
  }
  return list;
}

/// Sum of what the joints of one kind of a body do along their axes; no joint here turns another's.
std::array<double, 3> rate_of(const mjModel& model, const mjData& data, int body, int kind) {
  std::array<double, 3> sum{};
  for (int joint = 0; joint < model.njnt; ++joint)
    if (model.jnt_bodyid[joint] == body && model.jnt_type[joint] == kind)
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] +=
            model.jnt_axis[3 * static_cast<std::size_t>(joint) + i] * data.qvel[model.jnt_dofadr[joint]];
  return sum;
}

void print_row(const mjModel& model, const mjData& data) {
  std::printf("%.17g", data.time);
  for (int body = 1; body < model.nbody; ++body) {
    const double *place = data.xpos + std::ptrdiff_t{3} * body, *turn = data.xquat + std::ptrdiff_t{4} * body;
    for (int i = 0; i < 3; ++i) std::printf(",%.17g", place[i]);
    for (int i = 0; i < 4; ++i) std::printf(",%.17g", turn[i]);
    for (const int kind : {mjJNT_SLIDE, mjJNT_HINGE})
      for (const double rate : rate_of(model, data, body, kind)) std::printf(",%.17g", rate);
  }
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML(arguments[1], nullptr, error.data(), static_cast<int>(error.size())), mj_deleteModel);
  if (!model) {
    std::fprintf(stderr, "%s\n", error.data());
    return 1;
  }
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), mj_deleteData);
  mj_resetDataKeyframe(model.get(), data.get(), 0);
  const auto gravity = count > 3 ? read_gravity(arguments[3]) : std::vector<std::array<double, 2>>();
  std::printf("time");
  for (int k = 1; k < model->nbody; ++k)
    std::printf(",x_%d,y_%d,z_%d,qw_%d,qx_%d,qy_%d,qz_%d,vx_%d,vy_%d,vz_%d,wx_%d,wy_%d,wz_%d", k, k, k, k, k,
                k, k, k, k, k, k, k, k);
  std::printf("\n");
  const int up = model->opt.gravity[1] != 0 ? 1 : 2;
  const auto steps = static_cast<std::size_t>(std::strtoul(arguments[2], nullptr, 10));
  for (std::size_t i = 0; i <= steps; ++i) {
    mj_kinematics(model.get(), data.get());
    print_row(*model, *data);
    if (i < gravity.size()) {
      model->opt.gravity[0] = gravity[i][0];
      model->opt.gravity[up] = gravity[i][1];
    }
    mj_step(model.get(), data.get());
  }
  return 0;
}
