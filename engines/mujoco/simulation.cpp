#include "engines/mujoco/simulation.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace rockstack {
namespace {

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
  /// Of a block's three coordinates.
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

  /// Of the ground, then the blocks.
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
    if (contact.efc_address >= 0) soften(point, contact);
    return point;
  }

  /// Where nothing accelerates, each row of a contact is a spring of k d/R and a dashpot of b/R (README.md).
  /// A pyramidal cone has four rows that share the normal force.
  void soften(ContactPoint& point, const mjContact& contact) const {
    const bool pyramid = model_->opt.cone == mjCONE_PYRAMIDAL && contact.dim > 1;
    const double rows = pyramid ? 2 * (contact.dim - 1) : 1;
    const double* terms = data_->efc_KBIP + std::ptrdiff_t{4} * contact.efc_address;
    const double compliance = mass_factor_ * data_->efc_R[contact.efc_address] / rows;
    point.stiffness = terms[0] * terms[2] / compliance;
    point.damping = terms[1] / compliance;
  }

  std::size_t blocks_;
  MujocoModel model_;
  std::unique_ptr<mjData, void (*)(mjData*)> data_;
  std::vector<Pose> before_;  ///< of the ground and the blocks where the last step started
};

}  // namespace

std::unique_ptr<Simulation> start_mujoco(MujocoSolver solver, const Setup& setup,
                                         const Parameters& parameters) {
  // MuJoCo would end the process, or write a file into the working folder; its data count warnings as well.
  mju_user_error = [](const char* message) { throw std::runtime_error("mujoco: " + std::string(message)); };
  mju_user_warning = [](const char*) {};
  return std::make_unique<MujocoSimulation>(solver, setup, parameters);
}

}  // namespace rockstack
