#include "tests/benchmarks/sprung_block.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <sundials/sundials_context.hpp>

namespace rockstack::benchmarks {
namespace {

constexpr int size = 8;  // x, y and angle of the middle, their rates, and how far either corner is stretched
using State = std::array<double, size>;
using Found = std::array<int, 6>;  // of roots

enum class Press { off, left_behind, pushing };

struct Corner {
  int side = 0;  ///< −1 left, 1 right
  Press press = Press::off;
  int slide = 0;  ///< the way its slider moves; 0: it stands still
};

/// A corner of the block against the ground.
struct Place {
  double depth;
  double x_turn, depth_turn;  ///< what they change by with the angle
  double x_rate, depth_rate;
};

class SprungBlock {
 public:
  explicit SprungBlock(const Scene& scene)
      : block_(scene.blocks.front()),
        gravity_(scene.gravity),
        stiffness_(scene.springs.stiffness.front()),
        damping_(scene.springs.damping.front()),
        tangential_(scene.springs.tangential),
        friction_(scene.friction.front()) {
    const double angle = scene.initial.angles.front();
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    start_ = {block_.half_height * sine - block_.half_width * cosine,
              block_.half_height * cosine + block_.half_width * sine, angle};
    corners_[1].press = Press::pushing;
  }

  const State& start() const { return start_; }

  void derivative(const double* state, double* rates) const {
    double along = 0;
    double up = -block_.mass * gravity_;
    double moment = 0;
    std::copy_n(state + 3, 3, rates);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      rates[6 + i] = 0;
      if (corners_[i].press != Press::pushing) continue;
      const Place place = place_of(corners_[i], state);
      const double normal = pressure(place);
      rates[6 + i] = stretch_rate(corners_[i], place, state[6 + i]);
      const double tangential = -tangential_ * (stiffness_ * state[6 + i] + damping_ * rates[6 + i]);
      along += tangential;
      up += normal;
      moment += tangential * place.x_turn - normal * place.depth_turn;
    }
    rates[3] = along / block_.mass;
    rates[4] = up / block_.mass;
    rates[5] = moment / block_.inertia;
  }

  /// Three a corner: depth, pressure, and what parts standing still from sliding; one where they do not
  /// matter.
  void roots(const double* state, double* values) const {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Corner& corner = corners_[i];
      const Place place = place_of(corner, state);
      const bool pushes = corner.press == Press::pushing;
      values[3 * i] = pushes ? 1 : place.depth;
      values[3 * i + 1] = corner.press == Press::off ? 1 : pressure(place);
      values[3 * i + 2] = !pushes ? 1 : grip(corner, place, state[6 + i]);
    }
  }

  /// The ways in which roots are passed: what rounding leaves of a root just behind is none.
  Found directions() const {
    Found result{};
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      result[3 * i] = corners_[i].press == Press::off ? 1 : -1;
      result[3 * i + 1] = corners_[i].press == Press::pushing ? -1 : 1;
      result[3 * i + 2] = -1;
    }
    return result;
  }

  void change(double* state, const Found& found) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      Corner& corner = corners_[i];
      if (found[3 * i] != 0 || found[3 * i + 1] != 0) {
        press(corner, found[3 * i] != 0);
        state[6 + i] = 0;
        corner.slide = 0;
      } else if (found[3 * i + 2] == 0) {
        continue;
      }
      const bool slid = corner.slide != 0;
      corner.slide = 0;
      const Place place = place_of(corner, state);
      if (corner.press == Press::pushing && !slid && grip(corner, place, state[6 + i]) <= rounding())
        corner.slide = held(place, state[6 + i]) > 0 ? 1 : -1;
    }
  }

 private:
  double pressure(const Place& place) const { return stiffness_ * place.depth + damping_ * place.depth_rate; }

  /// The force along the ground of a spring whose slider stands still, N.
  double held(const Place& place, double stretch) const {
    return tangential_ * (stiffness_ * stretch + damping_ * place.x_rate);
  }

  double stretch_rate(const Corner& corner, const Place& place, double stretch) const {
    if (corner.slide == 0) return place.x_rate;
    const double limit = corner.slide * friction_ * pressure(place);
    return (limit - tangential_ * stiffness_ * stretch) / (tangential_ * damping_);
  }

  /// Above zero as long as a slider goes on to stand still, N, or to move, m/s.
  double grip(const Corner& corner, const Place& place, double stretch) const {
    if (corner.slide == 0) return friction_ * pressure(place) - std::abs(held(place, stretch));
    return corner.slide * (place.x_rate - stretch_rate(corner, place, stretch));
  }

  /// Rounding of forces, N.
  double rounding() const { return 1e-9 * block_.mass * gravity_; }

  static void press(Corner& corner, bool at_face) {
    if (corner.press == Press::pushing)
      corner.press = Press::left_behind;
    else
      corner.press = corner.press == Press::left_behind && at_face ? Press::off : Press::pushing;
  }

  Place place_of(const Corner& corner, const double* state) const {
    const double cosine = std::cos(state[2]);
    const double sine = std::sin(state[2]);
    const double arm = corner.side * block_.half_width;
    Place place{};
    place.depth = -(state[1] - arm * sine - block_.half_height * cosine);
    place.x_turn = -arm * sine - block_.half_height * cosine;
    place.depth_turn = arm * cosine - block_.half_height * sine;
    place.x_rate = state[3] + place.x_turn * state[5];
    place.depth_rate = -state[4] + place.depth_turn * state[5];
    return place;
  }

  Block block_;
  double gravity_, stiffness_, damping_, tangential_, friction_;
  State start_{};
  std::array<Corner, 2> corners_{{{-1}, {1}}};
};

struct Release {
  void operator()(N_Vector vector) const { N_VDestroy(vector); }
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
  void operator()(void* memory) const { CVodeFree(&memory); }
};

template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

void require(int result) {
  if (result < 0) throw std::runtime_error("CVODE failed: " + std::to_string(result));
}

/// CVODE's BDF on a block's equations.
class Bdf {
 public:
  Bdf(SprungBlock& block, double tolerance)
      : block_(block),
        vector_(N_VNew_Serial(size, context_)),
        matrix_(SUNDenseMatrix(size, size, context_)),
        linear_(SUNLinSol_Dense(vector_.get(), matrix_.get(), context_)),
        memory_(CVodeCreate(CV_BDF, context_)) {
    std::copy_n(block.start().begin(), size, values());
    constexpr auto derivative = [](double, N_Vector at, N_Vector rates, void* self) {
      static_cast<SprungBlock*>(self)->derivative(N_VGetArrayPointer(at), N_VGetArrayPointer(rates));
      return 0;
    };
    constexpr auto roots = [](double, N_Vector at, double* found, void* self) {
      static_cast<SprungBlock*>(self)->roots(N_VGetArrayPointer(at), found);
      return 0;
    };
    require(CVodeInit(memory_.get(), derivative, 0, vector_.get()));
    require(CVodeSStolerances(memory_.get(), tolerance, tolerance));
    require(CVodeSetUserData(memory_.get(), &block_));
    require(CVodeSetLinearSolver(memory_.get(), linear_.get(), matrix_.get()));
    require(CVodeRootInit(memory_.get(), std::tuple_size_v<Found>, roots));
    set_directions();
    require(CVodeSetNoInactiveRootWarn(memory_.get()));
    require(CVodeSetMaxNumSteps(memory_.get(), 100000000));
  }

  /// Up to a time, through events.
  void go_to(double time) {
    while (time_ < time) {
      const int result = CVode(memory_.get(), time, vector_.get(), &time_, CV_NORMAL);
      require(result);
      if (result != CV_ROOT_RETURN) continue;
      constexpr int most_events = 10000;
      if (++events_ > most_events) throw std::runtime_error("CVODE finds no end of events");
      Found found{};
      require(CVodeGetRootInfo(memory_.get(), found.data()));
      note_steps();
      block_.change(values(), found);
      set_directions();
      require(CVodeReInit(memory_.get(), time_, vector_.get()));
    }
  }

  double angle() const { return values()[2]; }

  long steps() {
    note_steps();
    return steps_;
  }

 private:
  double* values() const { return N_VGetArrayPointer(vector_.get()); }

  void set_directions() {
    Found ways = block_.directions();
    require(CVodeSetRootDirection(memory_.get(), ways.data()));
  }

  void note_steps() {
    long since_restart = 0;
    require(CVodeGetNumSteps(memory_.get(), &since_restart));
    steps_ += since_restart;
  }

  SprungBlock& block_;
  sundials::Context context_;
  Owned<N_Vector> vector_;
  Owned<SUNMatrix> matrix_;
  Owned<SUNLinearSolver> linear_;
  Owned<void*> memory_;
  double time_ = 0;
  long steps_ = 0;
  int events_ = 0;
};

}  // namespace

SprungMotion sprung_by_bdf(const Scene& scene, double tolerance, const std::vector<double>& samples) {
  SprungBlock block(scene);
  Bdf method(block, tolerance);
  SprungMotion motion;
  for (const double sample : samples) {
    method.go_to(sample);
    motion.angles.push_back(method.angle());
  }
  motion.steps = method.steps();
  return motion;
}

}  // namespace rockstack::benchmarks
