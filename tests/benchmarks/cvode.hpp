#pragma once

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <stdexcept>
#include <sundials/sundials_context.hpp>

#include "tests/benchmarks/lean_chain.hpp"

namespace rockstack::benchmarks {

/// SUNDIALS CVODE: Adams' methods of order 1 … 12 with fixed-point iteration, which suits motion that is not
/// stiff, and CVODE's own root finding on the guards. It starts anew where the ground's course changes.
template <int N>
class Cvode {
 public:
  static constexpr bool finds_roots = true;

  /// @param tolerance absolute and relative
  explicit Cvode(double tolerance)
      : vector_(N_VNew_Serial(2UL * N, context_)),
        iteration_(SUNNonlinSol_FixedPoint(vector_.get(), 0, context_)),
        memory_(CVodeCreate(CV_ADAMS, context_)) {
    N_VConst(0, vector_.get());
    require(CVodeInit(memory_.get(), derivative, 0, vector_.get()));
    require(CVodeSStolerances(memory_.get(), tolerance, tolerance));
    require(CVodeSetUserData(memory_.get(), this));
    require(CVodeSetNonlinearSolver(memory_.get(), iteration_.get()));
    require(CVodeRootInit(memory_.get(), 3UL * N, guards));
    require(CVodeSetNoInactiveRootWarn(memory_.get()));
    require(CVodeSetMaxNumSteps(memory_.get(), 100000));
  }

  void restart(const Stretch<N>& stretch, double offset, const Values<N>& values) {
    stretch_ = stretch;
    std::copy(values.begin(), values.end(), N_VGetArrayPointer(vector_.get()));
    require(CVodeReInit(memory_.get(), offset, vector_.get()));
  }

  double advance(double limit) {
    require(CVodeSetStopTime(memory_.get(), limit));
    double reached = 0;
    const int result = CVode(memory_.get(), limit, vector_.get(), &reached, CV_ONE_STEP);
    require(result);
    at_root_ = result == CV_ROOT_RETURN;
    reached_ = reached;
    std::copy_n(N_VGetArrayPointer(vector_.get()), 2UL * N, end_.begin());
    return reached;
  }

  bool at_root() const { return at_root_; }

  Values<N> at(double offset) {
    if (offset == reached_) return end_;
    require(CVodeGetDky(memory_.get(), offset, 0, vector_.get()));
    Values<N> values;
    std::copy_n(N_VGetArrayPointer(vector_.get()), 2UL * N, values.begin());
    return values;
  }

 private:
  struct Release {
    void operator()(N_Vector vector) const { N_VDestroy(vector); }
    void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
    void operator()(void* memory) const { CVodeFree(&memory); }
  };

  static void require(int result) {
    if (result < 0) throw std::runtime_error("CVODE failed: " + std::to_string(result));
  }

  static Values<N> values_of(N_Vector vector) {
    Values<N> values;
    std::copy_n(N_VGetArrayPointer(vector), 2UL * N, values.begin());
    return values;
  }

  static int derivative(double offset, N_Vector vector, N_Vector rates, void* self) {
    static_cast<const Cvode*>(self)->stretch_.derivative(values_of(vector), offset,
                                                         N_VGetArrayPointer(rates));
    return 0;
  }

  static int guards(double offset, N_Vector vector, double* guard, void* self) {
    const Stretch<N>& stretch = static_cast<const Cvode*>(self)->stretch_;
    const Pattern& pattern = stretch.chain->pattern();
    const Values<N> values = values_of(vector);
    std::fill_n(guard, 3UL * N, 1.0);
    bool closed = false;
    for (std::size_t k = 0; k < N; ++k) {
      closed = closed || pattern[static_cast<int>(k)] == Contact::closed;
      if (pattern[static_cast<int>(k)] != Contact::closed) guard[k] = values[k];
    }
    if (!closed) return 0;
    const auto response = stretch.respond(values, offset);
    for (std::size_t k = 0; k < N; ++k) {
      if (pattern[static_cast<int>(k)] != Contact::closed) continue;
      guard[N + k] = response.right[k];
      guard[2UL * N + k] = response.left[k];
    }
    return 0;
  }

  sundials::Context context_;
  std::unique_ptr<std::remove_pointer_t<N_Vector>, Release> vector_;
  std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, Release> iteration_;
  std::unique_ptr<void, Release> memory_;
  Stretch<N> stretch_{};
  bool at_root_ = false;
  double reached_ = 0;
  Values<N> end_{};
};

}  // namespace rockstack::benchmarks
