// An example of engines/README.md in C++: springs, dashpots and sliders at corners of blocks, stepped by
// semi-implicit Euler in 64 parts of each step. It links rockstack::engine, and serves an Engine.

#include <algorithm>
#include <array>
#include <utility>

#include "engines/worker/serve.hpp"

namespace {

using namespace rockstack;

constexpr int parts = 64;  ///< of a step

/// A block as it is now; the ground is one without mass that never moves.
struct Body {
  Placement shape;
  std::array<double, 3> force{};  ///< along x and y, N, and clockwise about the centre of mass, N m
  BodyLoad load = {};             ///< over the step under way

  /// Between the world and the block's axes, from the middle of its box.
  std::pair<double, double> corner(double x, double y) const {
    const double c = std::cos(shape.angle), s = std::sin(shape.angle);
    x -= shape.offset_x;
    y -= shape.offset_y;
    return {shape.x + x * c + y * s, shape.y - x * s + y * c};
  }
  std::pair<double, double> seen(double x, double y) const {
    const double c = std::cos(shape.angle), s = std::sin(shape.angle);
    return {(x - shape.x) * c - (y - shape.y) * s + shape.offset_x,
            (x - shape.x) * s + (y - shape.y) * c + shape.offset_y};
  }
  std::pair<double, double> velocity(double x, double y) const {
    return {shape.velocity_x + shape.angular_velocity * (y - shape.y),
            shape.velocity_y - shape.angular_velocity * (x - shape.x)};
  }
  void push(double x, double y, double along, double up) {
    force[0] += along;
    force[1] += up;
    force[2] += (y - shape.y) * along - (x - shape.x) * up;
  }
};

class Springs final : public ShakenSimulation {
 public:
  Springs(const Setup& setup, const Parameters& parameters)
      : ShakenSimulation(setup), setup_(setup), pull_(setup.gravity) {
    Body ground;
    ground.shape.width = HUGE_VAL;
    bodies_.push_back(ground);
    double mass = 0;
    for (const Placement& block : setup.blocks) {
      bodies_.push_back({block, {}, {}});
      mass += block.mass;
    }
    // Two corners bear the stack on Earth at the depth that was asked for.
    stiffness_ = 9.81 * mass / (2 * parameters.at("sinking"));
    damping_ = 2 * parameters.at("dampingRatio") * std::sqrt(stiffness_ * mass);
  }

  BodyState body(std::size_t block) const override {
    const Placement& now = bodies_[block + 1].shape;
    return {now.x, now.y, now.velocity_x, now.velocity_y, now.angle, now.angular_velocity};
  }

  bool watch_contacts() override { return false; }

 private:
  void set_gravity(const BodyAcceleration& acceleration) override { pull_ = acceleration; }

  void apply_load(std::size_t block, const BodyLoad& load) override { bodies_[block + 1].load = load; }

  void advance() override {
    for (int part = 0; part < parts; ++part) {
      for (std::size_t k = 1; k < bodies_.size(); ++k)
        touch(bodies_[k - 1], bodies_[k], setup_.friction[k - 1]);
      for (std::size_t k = 1; k < bodies_.size(); ++k) move(bodies_[k], dt() / parts);
    }
  }

  void move(Body& body, double time) const {
    Placement& now = body.shape;
    now.velocity_x += time * (pull_.x + (body.force[0] + body.load.x) / now.mass);
    now.velocity_y += time * (pull_.y + (body.force[1] + body.load.y) / now.mass);
    now.angular_velocity += time * (body.force[2] + body.load.moment) / now.inertia;
    now.x += time * now.velocity_x;
    now.y += time * now.velocity_y;
    now.angle += time * now.angular_velocity;
    body.force = {};
  }

  /// Corners of each body in the other's face.
  void touch(Body& lower, Body& upper, double friction) const {
    for (const double side : {-0.5, 0.5}) {
      bear(lower, upper, lower, upper.corner(side * upper.shape.width, -0.5 * upper.shape.height), friction);
      if (!std::isinf(lower.shape.width))
        bear(lower, upper, upper, lower.corner(side * lower.shape.width, 0.5 * lower.shape.height), friction);
    }
  }

  /// A corner over the face of one of both bodies.
  void bear(Body& lower, Body& upper, const Body& face, std::pair<double, double> corner,
            double friction) const {
    const auto [x, y] = corner;
    const auto [beside, height] = face.seen(x, y);
    const double depth = 0.5 * face.shape.height + (&face == &lower ? -height : height);
    if (!(std::abs(beside) <= 0.5 * face.shape.width) || depth <= 0) return;
    const auto [low_x, low_y] = lower.velocity(x, y);
    const auto [high_x, high_y] = upper.velocity(x, y);
    const double c = std::cos(face.shape.angle), s = std::sin(face.shape.angle);
    const double up = (high_x - low_x) * s + (high_y - low_y) * c;
    const double along = (high_x - low_x) * c - (high_y - low_y) * s;
    const double normal = std::max(0.0, stiffness_ * depth - damping_ * up);
    const double tangential = std::clamp(-damping_ * along, -friction * normal, friction * normal);
    upper.push(x, y, normal * s + tangential * c, normal * c - tangential * s);
    lower.push(x, y, -normal * s - tangential * c, tangential * s - normal * c);
  }

  Setup setup_;
  BodyAcceleration pull_;
  std::vector<Body> bodies_;  ///< ground first
  double stiffness_ = 0;      ///< of each corner, N/m
  double damping_ = 0;        ///< N s/m
};

}  // namespace

int main() {
  return serve({{{.name = "springs",
                  .solver = "euler",
                  .version = "1",
                  .licence = "same as rockstack",
                  .capabilities =
                      {.applied_forces = true, .planar = true, .center_of_mass = true, .lead = 0.5 / parts},
                  .settings = {{.name = "sinking",
                                .unit = "m",
                                .default_value = 1e-4,
                                .tuned = 1e-6,
                                .least = 1e-9,
                                .most = 1},
                               {.name = "dampingRatio", .default_value = 0.5, .tuned = 2, .most = 10}}},
                 [](const Setup& setup, const Parameters& parameters) {
                   return std::make_unique<Springs>(setup, parameters);
                 }}});
}
