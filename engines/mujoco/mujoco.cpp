// MuJoCo beside the exact model; README.md says what its contacts are and why its sets are as they are.

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

#include "engines/engine.hpp"

namespace rockstack {
namespace {

/// In the order of MuJoCo's own numbers.
enum class MujocoSolver { pgs, cg, newton };

/// A negative number of solref is a stiffness or a damping.
std::vector<Setting> settings_of(MujocoSolver solver) {
  const bool pgs = solver == MujocoSolver::pgs;
  return {
      {.name = "integrator", .choices = {"Euler", "RK4", "implicit"}},
      {.name = "cone", .choices = {"pyramidal", "elliptic"}, .default_value = 1},
      {.name = "solref_timeconst",
       .unit = "s",
       .default_value = 0.02,
       .tuned = 1e-3,
       .least = -1e18,
       .most = 1e18},
      {.name = "solref_dampratio",
       .default_value = 1,
       .tuned = pgs ? 6.0 : 3.0,
       .least = -1e18,
       .most = 1e18},
      {.name = "solimp_d0", .default_value = 0.9, .tuned = 0.995, .most = 1},
      {.name = "solimp_dwidth", .default_value = 0.95, .tuned = 0.995, .most = 1},
      {.name = "solimp_width", .unit = "m", .default_value = 1e-3},
      {.name = "solimp_midpoint", .default_value = 0.5, .most = 1},
      {.name = "solimp_power", .default_value = 2, .least = 1},
      {.name = "margin", .unit = "m"},
      {.name = "gap", .unit = "m"},
      {.name = "impratio", .default_value = 1, .least = 1e-6, .most = 1e6},
      count_setting("iterations", 100, pgs ? 300 : 100),
      {.name = "tolerance", .default_value = 1e-8, .tuned = 1e-12, .most = 1},
      {.name = "noslip_iterations", .most = 1e6, .whole = true},
      {.name = "noslip_tolerance", .default_value = 1e-6, .most = 1},
      switch_setting("refsafe", true, true),
      switch_setting("warmstart", true, true),
      {.name = "ground", .choices = {"plane", "box"}},
      {.name = "depth_ratio", .default_value = 1, .tuned = 0.9, .least = 0.1, .most = 10},
      {.name = "unitMass", .unit = "kg", .tuned = 1, .most = 1e12},
      shaking_setting(),
  };
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
  // Mass, kg, with which it goes as told without gravity, whatever presses on it.
  constexpr double unmoved = 1e30;
  return fmt::format(
      "<body><joint type='slide' axis='1 0 0' armature='{0}'/><joint type='slide' axis='0 1 0' "
      "armature='{0}'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>{1}</body>",
      unmoved, box);
}

/// Two slides and a hinge through the centre of mass, so that moments of inertia about x and y have no
/// effect.
std::string body(const Placement& block, std::size_t number, double masses, double depth) {
  return fmt::format(
      "<body><joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/><joint type='hinge' "
      "axis='0 0 1'/><inertial pos='0 0 0' mass='{0}' diaginertia='{1} {1} {1}'/>{2}</body>",
      masses * block.mass, masses * block.inertia,
      geom(number, fmt::format("type='box' size='{} {} {}' pos='{} {} 0'", block.width / 2, block.height / 2,
                               depth / 2, -block.offset_x, -block.offset_y)));
}

/// Every two bodies may touch, with the friction of the interface under the upper one in both directions.
std::string pairs(const Setup& setup, const Parameters& given) {
  const std::string alike =
      fmt::format("solref='{} {}' solimp='{} {} {} {} {}' margin='{}' gap='{}'", given.at("solref_timeconst"),
                  given.at("solref_dampratio"), given.at("solimp_d0"), given.at("solimp_dwidth"),
                  given.at("solimp_width"), given.at("solimp_midpoint"), given.at("solimp_power"),
                  given.at("margin"), given.at("gap"));
  std::string text;
  for (std::size_t upper = 1; upper <= setup.blocks.size(); ++upper) {
    const double friction = setup.friction[upper - 1];
    for (std::size_t lower = 0; lower < upper; ++lower)
      text += fmt::format("<pair geom1='{}' geom2='{}' condim='{}' friction='{} {} 0 0 0' {}/>", lower, upper,
                          friction > 0 ? 3 : 1, friction, friction, alike);
  }
  return text;
}

using MujocoModel = std::unique_ptr<mjModel, void (*)(mjModel*)>;

/// A stack as MuJoCo compiles it: the ground where it really moves, with two coordinates (x, y), then the
/// blocks, with three each (x, y, angle anticlockwise). @throws std::runtime_error with the library's error.
MujocoModel compile_stack(const Setup& setup, const Parameters& parameters) {
  const double masses = mass_factor(setup, parameters);
  std::string blocks;
  double share = 1;
  for (std::size_t k = 0; k < setup.blocks.size(); ++k, share *= parameters.at("depth_ratio"))
    blocks += body(setup.blocks[k], k + 1, masses, share * setup.blocks[k].depth);
  const std::string text = fmt::format("<mujoco><worldbody>{}{}</worldbody><contact>{}</contact></mujoco>",
                                       ground(setup, parameters), blocks, pairs(setup, parameters));
  // The library reads its models from files alone: this one is in memory.
  constexpr const char* name = "stack.xml";
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
  if (!setup.ground.empty()) {  // without the ground's: tolerances are relative to it, and solvers would stop
    double sum = 0;
    for (const Placement& block : setup.blocks) sum += masses * (2 * block.mass + block.inertia);
    model->stat.meaninertia = sum / (3 * static_cast<double>(setup.blocks.size()));
  }
  return model;
}

/// A body's coordinates, as MuJoCo has them.
struct Pose {
  double x = 0, y = 0, angle = 0;  ///< m, m, rad anticlockwise
};

/// How far a point that a body holds goes along a normal while the body goes from one pose to another, m.
double way_along(const double* normal, const double* point, const Pose& from, const Pose& to) {
  const double x = point[0] - from.x, y = point[1] - from.y;
  const double cosine = std::cos(to.angle - from.angle), sine = std::sin(to.angle - from.angle);
  return normal[0] * (to.x + cosine * x - sine * y - point[0]) +
         normal[1] * (to.y + sine * x + cosine * y - point[1]);
}

class MujocoSimulation final : public ShakenSimulation {
 public:
  MujocoSimulation(MujocoSolver solver, const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup, mass_factor(setup, parameters)),
        blocks_(setup.blocks.size()),
        model_(compile_stack(setup, parameters)),
        data_(mj_makeData(model_.get()), mj_deleteData) {
    if (!data_) throw std::runtime_error("mujoco: no memory for a run");
    set_options(solver, setup.dt, parameters);
    set_gravity(setup.gravity);
    for (std::size_t k = 0; k < blocks_; ++k) place(setup.blocks[k], k);
  }

  BodyState body(std::size_t k) const override {
    const double *place = data_->qpos + first(k), *velocity = data_->qvel + first(k);
    return {place[0], place[1], velocity[0], velocity[1], -place[2], -velocity[2]};
  }

  std::size_t warnings() const override {
    std::size_t sum = 0;
    for (const mjWarningStat& warning : data_->warning) sum += static_cast<std::size_t>(warning.number);
    return sum;
  }

  /// What is left after a step of Runge and Kutta's method are the contacts of its last stage alone.
  bool watch_contacts() override {
    return model_->opt.integrator != mjINT_RK4 && ShakenSimulation::watch_contacts();
  }

  std::vector<ContactPoint> contacts() const override {
    std::vector<ContactPoint> points;
    if (!watches_contacts() || before_.empty()) return points;
    const std::vector<Pose> now = poses();
    for (int i = 0; i < data_->ncon; ++i) points.push_back(point_of(i, now));
    return points;
  }

 private:
  /// First of a block's three coordinates.
  std::size_t first(std::size_t block) const { return (moves_ground() ? 2 : 0) + 3 * block; }

  void set_options(MujocoSolver solver, double dt, const Parameters& parameters) {
    mjOption& option = model_->opt;
    const auto whole = [&](const char* name) { return static_cast<int>(parameters.at(name)); };
    option.timestep = dt;
    option.solver = static_cast<int>(solver);
    option.integrator = whole("integrator");
    option.cone = whole("cone");
    option.impratio = parameters.at("impratio");
    option.iterations = whole("iterations");
    option.tolerance = parameters.at("tolerance");
    option.noslip_iterations = whole("noslip_iterations");
    option.noslip_tolerance = parameters.at("noslip_tolerance");
    if (whole("refsafe") == 0) option.disableflags |= mjDSBL_REFSAFE;
    if (whole("warmstart") == 0) option.disableflags |= mjDSBL_WARMSTART;
  }

  void advance() override {
    if (watches_contacts()) before_ = poses();
    mj_step(model_.get(), data_.get());
    // MuJoCo begins anew where a coordinate is not a number or above 10¹⁰: that is no motion of this stack.
    for (const mjtWarning lost : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
      if (data_->warning[lost].number > 0) throw std::runtime_error("mujoco: the motion is not finite");
  }

  void set_gravity(const BodyAcceleration& acceleration) override {
    const std::array<double, 3> gravity{acceleration.x, acceleration.y, 0};
    std::copy(gravity.begin(), gravity.end(), model_->opt.gravity);
  }

  /// Coordinates are those of the centre of mass.
  void apply_load(std::size_t k, const BodyLoad& load) override {
    const std::array<double, 3> force{load.x, load.y, -load.moment};
    std::copy(force.begin(), force.end(), data_->qfrc_applied + first(k));
  }

  void place(const Placement& block, std::size_t k) {
    const std::array<double, 3> place{block.x, block.y, -block.angle};
    const std::array<double, 3> velocity{block.velocity_x, block.velocity_y, -block.angular_velocity};
    std::copy(place.begin(), place.end(), data_->qpos + first(k));
    std::copy(velocity.begin(), velocity.end(), data_->qvel + first(k));
  }

  void place_ground(const GroundStep& step) override {
    data_->qpos[0] = step.x;
    data_->qpos[1] = step.y;
    data_->qvel[0] = step.velocity_x;
    data_->qvel[1] = step.velocity_y;
  }

  /// Poses of the ground, then of the blocks.
  std::vector<Pose> poses() const {
    std::vector<Pose> list(1);
    if (moves_ground()) list[0] = {data_->qpos[0], data_->qpos[1], 0};
    for (std::size_t k = 0; k < blocks_; ++k) {
      const double* place = data_->qpos + first(k);
      list.push_back({place[0], place[1], place[2]});
    }
    return list;
  }

  /// A contact of the last step. Geoms are numbered as poses are; the normal points from first to second.
  ContactPoint point_of(int i, const std::vector<Pose>& now) const {
    const mjContact& contact = data_->contact[i];
    const auto one = static_cast<std::size_t>(contact.geom1), other = static_cast<std::size_t>(contact.geom2);
    const Pose& upper = before_[std::max(one, other)];
    std::array<mjtNum, 6> force{};
    mj_contactForce(model_.get(), data_.get(), i, force.data());
    ContactPoint point;
    point.interface = std::max(one, other) - 1;
    point.along = std::cos(upper.angle) * (contact.pos[0] - upper.x) +
                  std::sin(upper.angle) * (contact.pos[1] - upper.y);
    point.gap_before = contact.dist;
    point.gap = contact.dist + way_along(contact.frame, contact.pos, before_[other], now[other]) -
                way_along(contact.frame, contact.pos, before_[one], now[one]);
    point.normal = dt() * force[0] / mass_factor_;
    point.tangential = dt() * std::hypot(force[1], force[2]) / mass_factor_;
    const double on_upper = (other > one ? dt() : -dt()) / mass_factor_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point.impulse_x += on_upper * force[axis] * contact.frame[3 * axis];
      point.impulse_y += on_upper * force[axis] * contact.frame[3 * axis + 1];
    }
    if (contact.efc_address < 0) return point;
    // Where nothing accelerates, each row of a contact is a spring of k d/R and a dashpot of b/R (README.md).
    // A pyramidal cone has four rows that share the normal force.
    const bool pyramid = model_->opt.cone == mjCONE_PYRAMIDAL && contact.dim > 1;
    const double rows = pyramid ? 2 * (contact.dim - 1) : 1;
    const double* terms = data_->efc_KBIP + std::ptrdiff_t{4} * contact.efc_address;
    const double compliance = mass_factor_ * data_->efc_R[contact.efc_address] / rows;
    point.stiffness = terms[0] * terms[2] / compliance;
    point.damping = terms[1] / compliance;
    return point;
  }

  std::size_t blocks_;
  MujocoModel model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  std::vector<Pose> before_;  ///< of the ground and the blocks where the last step started
};

Engine with(MujocoSolver solver, const char* name) {
  return {{.name = "mujoco",
           .solver = name,
           .version = std::string(mj_versionString()) + ", double precision",
           .licence = "Apache-2.0",
           .capabilities = {.applied_forces = true, .planar = true, .center_of_mass = true},
           .settings = settings_of(solver)},
          [solver](const Setup& setup, const Parameters& parameters) {
            // MuJoCo would end the process, or write a file into the working folder; its data count warnings.
            mju_user_error = [](const char* what) {
              throw std::runtime_error("mujoco: " + std::string(what));
            };
            mju_user_warning = [](const char*) {};
            return std::make_unique<MujocoSimulation>(solver, setup, parameters);
          }};
}

}  // namespace

std::vector<Engine> make_mujoco() {
  return {with(MujocoSolver::newton, "newton"), with(MujocoSolver::cg, "cg"), with(MujocoSolver::pgs, "pgs")};
}

}  // namespace rockstack
