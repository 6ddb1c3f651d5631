#pragma once

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

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
    for (std::size_t i = 0; i < 2UL * N; ++i)
      end_[i] = start_[i] + length / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
    return to_;
  }

  Values<N> at(double offset) const {
    const double share = (offset - from_) / (to_ - from_);
    Values<N> values;
    for (std::size_t i = 0; i < 2UL * N; ++i) values[i] = start_[i] + share * (end_[i] - start_[i]);
    return values;
  }

 private:
  Values<N> moved(const Values<N>& rates, double length) const {
    Values<N> values;
    for (std::size_t i = 0; i < 2UL * N; ++i) values[i] = start_[i] + length * rates[i];
    return values;
  }

  double step_;
  Stretch<N> stretch_{};
  double from_ = 0, to_ = 0;
  Values<N> start_{}, end_{};
};

/// Dormand & Prince's pair of order 5 from Boost.odeint, with step control and dense output. Steps end at the
/// ends of the ground's pieces, and the last derivative of one is the first of the next.
template <int N>
class Dopri5 {
 public:
  static constexpr bool finds_roots = false;

  /// @param tolerance absolute and relative
  explicit Dopri5(double tolerance)
      : stepper_(boost::numeric::odeint::make_controlled(tolerance, tolerance, Base())) {}

  void restart(const Stretch<N>& stretch, double offset, const Values<N>& values) {
    const Point<double> ground = stretch.piece->at(offset).ground;
    const bool goes_on = values == end_ && stretch.chain->pattern() == pattern_ &&
                         (ground - ground_).cwiseAbs().maxCoeff() < continuous_ground;
    stretch_ = stretch;
    pattern_ = stretch.chain->pattern();
    to_ = offset;
    end_ = values;
    if (!goes_on) system()(end_, rates_, to_);
  }

  double advance(double limit) {
    from_ = to_;
    start_ = end_;
    start_rates_ = rates_;
    const double left = limit - from_;
    double length = left / std::ceil(left / length_);
    double tried = length;
    while (stepper_.try_step(system(), start_, start_rates_, to_, end_, rates_, length) ==
           boost::numeric::odeint::fail)
      length_ = tried = length;
    length_ = std::max(length, length_);
    if (tried == left) to_ = limit;
    ground_ = stretch_.piece->at(to_).ground;
    return to_;
  }

  Values<N> at(double offset) {
    if (offset == to_) return end_;
    Values<N> values;
    stepper_.stepper().calc_state(offset, values, start_, start_rates_, from_, end_, rates_, to_);
    return values;
  }

 private:
  using Base = boost::numeric::odeint::runge_kutta_dopri5<Values<N>>;

  auto system() const {
    return [this](const Values<N>& values, Values<N>& rates, double offset) {
      stretch_.derivative(values, offset, rates.data());
    };
  }

  typename boost::numeric::odeint::result_of::make_controlled<Base>::type stepper_;
  Stretch<N> stretch_{};
  Pattern pattern_;
  Point<double> ground_ = Point<double>::Zero();  ///< at the end of the last step, m/s²
  double length_ = 1e-3;                          ///< of the next step, s
  double from_ = 0, to_ = 0;
  Values<N> start_{}, end_{}, start_rates_{}, rates_{};
};

/// Fehlberg's pair of order 7 and 8 from Boost.odeint with step control. It has no dense output: values
/// within a step are Hermite's polynomial through its ends and two shorter steps, with their rates.
template <int N>
class Fehlberg78 {
 public:
  static constexpr bool finds_roots = false;

  /// @param tolerance absolute and relative
  explicit Fehlberg78(double tolerance)
      : stepper_(boost::numeric::odeint::make_controlled(tolerance, tolerance, Base())) {}

  void restart(const Stretch<N>& stretch, double offset, const Values<N>& values) {
    stretch_ = stretch;
    to_ = offset;
    end_ = values;
  }

  double advance(double limit) {
    from_ = to_;
    start_ = end_;
    dense_ = false;
    const double left = limit - from_;
    double length = std::min(length_, left);
    double tried = length;
    while (stepper_.try_step(system(), start_, to_, end_, length) == boost::numeric::odeint::fail)
      tried = length;
    if (tried == left) to_ = limit;
    length_ = tried == left ? std::max(length, length_) : length;
    return to_;
  }

  Values<N> at(double offset) {
    if (offset == to_) return end_;
    if (!dense_) interpolate();
    const double share = (offset - from_) / (to_ - from_);
    Values<N> values = newton_.back();
    for (std::size_t n = newton_.size() - 1; n-- > 0;)
      for (std::size_t i = 0; i < 2UL * N; ++i) values[i] = values[i] * (share - node(n)) + newton_[n][i];
    return values;
  }

 private:
  using Base = boost::numeric::odeint::runge_kutta_fehlberg78<Values<N>>;

  auto system() const {
    return [this](const Values<N>& values, Values<N>& rates, double offset) {
      stretch_.derivative(values, offset, rates.data());
    };
  }

  /// Each share of the step twice: for its value and for its rate.
  static double node(std::size_t n) {
    const std::size_t third = n / 2;
    return static_cast<double>(third) / 3;
  }

  /// Newton's divided differences.
  void interpolate() {
    const double length = to_ - from_;
    std::array<Values<N>, 8> rates;
    for (std::size_t n = 0; n < 8; n += 2) {
      const double offset = from_ + node(n) * length;
      Values<N> values = n == 0 ? start_ : end_;
      if (n == 2 || n == 4) stepper_.stepper().do_step(system(), start_, from_, values, offset - from_);
      newton_[n] = newton_[n + 1] = values;
      system()(values, rates[n + 1], offset);
    }
    for (std::size_t order = 1; order < 8; ++order) {
      for (std::size_t n = 7; n >= order; --n) {
        const double apart = node(n) - node(n - order);
        for (std::size_t i = 0; i < 2UL * N; ++i)
          newton_[n][i] = apart > 0 ? (newton_[n][i] - newton_[n - 1][i]) / apart : length * rates[n][i];
      }
    }
    dense_ = true;
  }

  typename boost::numeric::odeint::result_of::make_controlled<Base>::type stepper_;
  Stretch<N> stretch_{};
  double length_ = 1e-3;  ///< of the next step, s
  double from_ = 0, to_ = 0;
  Values<N> start_{}, end_{};
  bool dense_ = false;
  std::array<Values<N>, 8> newton_{};
};

}  // namespace rockstack::benchmarks
