#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include "tests/benchmarks/lean_chain.hpp"

namespace rockstack::benchmarks {

/// The classical Runge–Kutta method at a fixed step with impacts by linear interpolation: Spanos et al. 2001,
/// Section 6.
template <int N>
class PaperRk4 {
 public:
  static constexpr bool finds_roots = false;

  /// @param step s
  explicit PaperRk4(double step) : step_(step) {}

  void restart(const Stretch<N>& stretch, double offset, const Values<N>& values) {
    stretch_ = stretch;
    to_ = offset;
    end_ = values;
  }

  double advance(double limit) {
    from_ = to_;
    start_ = end_;
    to_ = limit - from_ < 1.001 * step_ ? limit : from_ + step_;
    const double length = to_ - from_;
    Values<N> k1;
    Values<N> k2;
    Values<N> k3;
    Values<N> k4;
    stretch_.derivative(start_, from_, k1.data());
    stretch_.derivative(moved(k1, length / 2), from_ + length / 2, k2.data());
    stretch_.derivative(moved(k2, length / 2), from_ + length / 2, k3.data());
    stretch_.derivative(moved(k3, length), to_, k4.data());
    for (std::size_t i = 0; i < 2 * N; ++i)
      end_[i] = start_[i] + length / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    return to_;
  }

  Values<N> at(double offset) const {
    const double share = (offset - from_) / (to_ - from_);
    Values<N> values;
    for (std::size_t i = 0; i < 2 * N; ++i) values[i] = start_[i] + share * (end_[i] - start_[i]);
    return values;
  }

 private:
  Values<N> moved(const Values<N>& rates, double length) const {
    Values<N> values;
    for (std::size_t i = 0; i < 2 * N; ++i) values[i] = start_[i] + length * rates[i];
    return values;
  }

  double step_;
  Stretch<N> stretch_{};
  double from_ = 0, to_ = 0;
  Values<N> start_{}, end_{};
};

/// Dormand & Prince's pair of order 5 from Boost.odeint, with step control and dense output.
template <int N>
class Dopri5 {
 public:
  static constexpr bool finds_roots = false;

  /// @param tolerance absolute and relative
  explicit Dopri5(double tolerance)
      : stepper_(boost::numeric::odeint::make_dense_output(tolerance, tolerance, Base())) {}

  void restart(const Stretch<N>& stretch, double offset, const Values<N>& values) {
    stretch_ = stretch;
    reached_ = offset;
    stepper_.initialize(values, offset, std::min(length_, stretch.piece->length - offset));
  }

  /// A step may pass the limit, where the ground's line is continued.
  double advance(double limit) {
    if (reached_ >= stepper_.current_time()) {
      stepper_.do_step([this](const Values<N>& values, Values<N>& rates, double offset) {
        stretch_.derivative(values, offset, rates.data());
      });
      length_ = stepper_.current_time_step();
    }
    return reached_ = std::min(limit, stepper_.current_time());
  }

  Values<N> at(double offset) {
    Values<N> values;
    stepper_.calc_state(offset, values);
    return values;
  }

 private:
  using Base = boost::numeric::odeint::runge_kutta_dopri5<Values<N>>;
  typename boost::numeric::odeint::result_of::make_dense_output<Base>::type stepper_;
  Stretch<N> stretch_{};
  double length_ = 1e-3;  ///< the first step, s
  double reached_ = 0;
};

}  // namespace rockstack::benchmarks
