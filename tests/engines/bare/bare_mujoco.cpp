// A stack of blocks in MuJoCo by MuJoCo's header alone: nothing of this project is read here, so that its
// adapter can be held to it. What is not set stays as the library has it, but for elliptic cones. Standard
// input has words:
//
//   solver newton                      (or cg, pgs)
//   gravity 9.81  friction 1000  dt 0.001  steps 500  reach 100
//     reach: half the ground's length, m
//   block 1.25 1.25 1 3906 834 834 1017 0 0.6 0.15
//     of each block from the bottom up: width, height, depth (m), mass (kg), moments of inertia about x, y
//     and z (kg m²), centre x, y (m), angle (rad)
//   set solref_timeconst 0.01          (whatever MuJoCo can be told)
//   shake 0.5 -0.1                     (the ground's acceleration right and up, m/s², one a step)
//
// Standard output has a line a step, the start first: the angles in rad, clockwise positive.

#include <mujoco/mujoco.h>

#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace {

struct Block {
  double width, height, depth, mass, about_x, about_y, about_z, x, y, angle;
};

struct Question {
  std::map<std::string, double> number{
      {"gravity", 0}, {"friction", 0}, {"dt", 0}, {"steps", 0}, {"reach", 0}};
  std::string solver;
  std::vector<Block> blocks;
  std::map<std::string, double> set;
  std::vector<std::pair<double, double>> shaking;

  double setting(const std::string& name, double default_value) const {
    const auto found = set.find(name);
    return found == set.end() ? default_value : found->second;
  }
};

bool read(std::istream& in, Question& question) {
  for (std::string word; in >> word;) {
    if (word == "solver") {
      in >> question.solver;
    } else if (word == "block") {
      Block& block = question.blocks.emplace_back();
      in >> block.width >> block.height >> block.depth >> block.mass >> block.about_x >> block.about_y;
      in >> block.about_z >> block.x >> block.y >> block.angle;
    } else if (word == "set") {
      in >> word;
      in >> question.set[word];
    } else if (word == "shake") {
      auto& [x, y] = question.shaking.emplace_back();
      in >> x >> y;
    } else if (question.number.count(word) != 0) {
      in >> question.number[word];
    } else {
      return false;
    }
  }
  return in.eof();
}

__attribute__((format(printf, 1, 2))) std::string print(const char* format, ...) {
  char line[1000];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  return line;
}

/// Two slides and a hinge keep a block in the plane; the hinge is at its centre.
std::string body(const Block& block, std::size_t number, double depth) {
  return "<body><joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/>"
         "<joint type='hinge' axis='0 0 1'/>" +
         print("<inertial pos='0 0 0' mass='%.17g' diaginertia='%.17g %.17g %.17g'/>", block.mass,
               block.about_x, block.about_y, block.about_z) +
         print("<geom name='%zu' type='box' size='%.17g %.17g %.17g' contype='0' conaffinity='0'/></body>",
               number, block.width / 2, block.height / 2, depth / 2);
}

std::string ground(const Question& question) {
  const double reach = question.number.at("reach");
  if (question.setting("ground", 0) == 0)
    return "<geom name='0' type='plane' zaxis='0 1 0' size='0 0 1' contype='0' conaffinity='0'/>";
  return print(
      "<geom name='0' type='box' size='%.17g %.17g %.17g' pos='0 %.17g 0' contype='0' conaffinity='0'/>",
      reach, reach / 10, reach, -reach / 10);
}

/// Every two bodies may touch.
std::string pairs(const Question& question) {
  const double friction = question.number.at("friction");
  std::string text;
  for (std::size_t upper = 1; upper <= question.blocks.size(); ++upper) {
    for (std::size_t lower = 0; lower < upper; ++lower) {
      text += print("<pair geom1='%zu' geom2='%zu' condim='%d' margin='%.17g' gap='%.17g'", lower, upper,
                    friction > 0 ? 3 : 1, question.setting("margin", 0), question.setting("gap", 0)) +
              print(" friction='%.17g %.17g 0 0 0'", friction, friction) +
              print(" solref='%.17g %.17g'", question.setting("solref_timeconst", 0.02),
                    question.setting("solref_dampratio", 1)) +
              print(" solimp='%.17g %.17g %.17g %.17g %.17g'/>", question.setting("solimp_d0", 0.9),
                    question.setting("solimp_dwidth", 0.95), question.setting("solimp_width", 0.001),
                    question.setting("solimp_midpoint", 0.5), question.setting("solimp_power", 2));
    }
  }
  return text;
}

std::string model_text(const Question& question) {
  std::string text = "<mujoco><compiler angle='radian'/><worldbody>" + ground(question);
  double share = 1;
  for (std::size_t k = 0; k < question.blocks.size(); ++k) {
    text += body(question.blocks[k], k + 1, share * question.blocks[k].depth);
    share *= question.setting("depth_ratio", 1);
  }
  return text + "</worldbody><contact>" + pairs(question) + "</contact></mujoco>";
}

mjModel* compile(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "stack.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  char error[1000] = "";
  mjModel* model = mj_loadXML("stack.xml", files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) std::fprintf(stderr, "%s\n", error);
  return model;
}

void set_options(mjOption& option, const Question& question) {
  option.timestep = question.number.at("dt");
  option.solver = question.solver == "newton" ? mjSOL_NEWTON : question.solver == "cg" ? mjSOL_CG : mjSOL_PGS;
  option.integrator = static_cast<int>(question.setting("integrator", option.integrator));
  option.cone = static_cast<int>(question.setting("cone", mjCONE_ELLIPTIC));
  option.impratio = question.setting("impratio", option.impratio);
  option.iterations = static_cast<int>(question.setting("iterations", option.iterations));
  option.tolerance = question.setting("tolerance", option.tolerance);
  option.noslip_iterations =
      static_cast<int>(question.setting("noslip_iterations", option.noslip_iterations));
  option.noslip_tolerance = question.setting("noslip_tolerance", option.noslip_tolerance);
  if (question.setting("refsafe", 1) == 0) option.disableflags |= mjDSBL_REFSAFE;
  if (question.setting("warmstart", 1) == 0) option.disableflags |= mjDSBL_WARMSTART;
}

void print(const mjData* data, std::size_t blocks) {
  for (std::size_t k = 0; k < blocks; ++k) std::printf("%.17g ", -data->qpos[3 * k + 2]);
  std::printf("\n");
}

}  // namespace

int main() {
  Question question;
  if (!read(std::cin, question)) return 2;
  mjModel* model = compile(model_text(question));
  if (model == nullptr) return 2;
  set_options(model->opt, question);
  mjData* data = mj_makeData(model);
  for (std::size_t k = 0; k < question.blocks.size(); ++k) {
    data->qpos[3 * k] = question.blocks[k].x;
    data->qpos[3 * k + 1] = question.blocks[k].y;
    data->qpos[3 * k + 2] = -question.blocks[k].angle;
  }
  const double gravity = question.number.at("gravity");
  model->opt.gravity[0] = model->opt.gravity[2] = 0;
  model->opt.gravity[1] = -gravity;
  print(data, question.blocks.size());
  for (std::size_t step = 0; step < static_cast<std::size_t>(question.number.at("steps")); ++step) {
    if (step < question.shaking.size()) {
      model->opt.gravity[0] = -question.shaking[step].first;
      model->opt.gravity[1] = -gravity - question.shaking[step].second;
    }
    mj_step(model, data);
    print(data, question.blocks.size());
  }
  mj_deleteData(data);
  mj_deleteModel(model);
}
