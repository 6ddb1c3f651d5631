#include "tests/benchmarks/pack_steps.hpp"

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cstring>
#include <xsimd/xsimd.hpp>

namespace rockstack::benchmarks {
namespace {

using Real = xsimd::batch<double, xsimd::avx2>;
using Mask = Real::batch_bool_type;

void put(Real& row, std::size_t lane, double value) {
  std::memcpy(reinterpret_cast<char*>(&row) + lane * sizeof value, &value, sizeof value);
}

double get(const Real& row, std::size_t lane) {
  double value = 0;
  std::memcpy(&value, reinterpret_cast<const char*>(&row) + lane * sizeof value, sizeof value);
  return value;
}

LaneSet set_of(const Mask& mask) {
  return LaneSet(static_cast<unsigned>(_mm256_movemask_pd(mask)));
}

template <int N>
class Avx2Steps final : public PackSteps<N> {
 public:
  static_assert(PackSteps<N>::lanes == Real::size);
  using typename PackSteps<N>::Outcome;
  using typename PackSteps<N>::Step;

  explicit Avx2Steps(double tolerance) : tolerance_(tolerance) {
    // What lanes have in which no scene is: numbers, as others do.
    for (auto* row :
         {&linkage_.moment_x, &linkage_.moment_y, &linkage_.link_x, &linkage_.link_y, &linkage_.inertia,
          &linkage_.mass, &linkage_.width, &linkage_.free, &sides_, &toppling_})
      row->fill(Real(1.0));
    values_.fill(Real(0.0));
    rates_.fill(Real(0.0));
  }

  void start(std::size_t lane, double gravity, const std::array<double, N>& toppling) override {
    put(gravity_, lane, gravity);
    put(length_, lane, 1e-3);
    put(busy_, lane, 1);
    for (std::size_t k = 0; k < N; ++k) put(toppling_[k], lane, toppling[k]);
  }

  void stop(std::size_t lane) override { put(busy_, lane, 0); }

  void follow(std::size_t lane, const GroundPiece<double>& piece, double offset) override {
    // A motion may start or end with a jump; where it does not, derivatives go on.
    const auto set = [&](const GroundComponent<double>& course, Line& line) {
      const double before = get(line.value, lane) + get(offset_, lane) * get(line.rate, lane);
      fresh_ = fresh_ || std::abs(course.line_at(offset) - before) >= continuous_ground;
      put(line.value, lane, course.value);
      put(line.rate, lane, course.rate);
    };
    set(piece.horizontal, horizontal_);
    set(piece.vertical, vertical_);
    put(offset_, lane, offset);
    put(end_, lane, piece.length);
  }

  void go_on(std::size_t lane, const Values<N>& values, const LeanChain<N>& chain) override {
    const Linkage<double, N>& linkage = chain.linkage();
    for (std::size_t k = 0; k < N; ++k) {
      put(linkage_.moment_x[k], lane, linkage.moment_x[k]);
      put(linkage_.moment_y[k], lane, linkage.moment_y[k]);
      put(linkage_.link_x[k], lane, linkage.link_x[k]);
      put(linkage_.link_y[k], lane, linkage.link_y[k]);
      put(linkage_.inertia[k], lane, linkage.inertia[k]);
      put(linkage_.mass[k], lane, linkage.mass[k]);
      put(linkage_.width[k], lane, linkage.width[k]);
      put(linkage_.free[k], lane, linkage.free[k]);
      put(sides_[k], lane, sign(chain.pattern()[static_cast<int>(k)]));
    }
    for (std::size_t i = 0; i < 2UL * N; ++i) put(values_[i], lane, values[i]);
    fresh_ = true;
  }

  Outcome step() override {
    const auto derivative = [this](const State& values, State& rates, const Real& offset) {
      const auto response = respond(values, offset);
      for (std::size_t k = 0; k < N; ++k) {
        rates[k] = values[k + N];
        rates[k + N] = response.accelerations[k];
      }
    };
    if (fresh_) derivative(values_, rates_, offset_);
    fresh_ = false;
    const Mask busy = busy_ > Real(0.0);
    const Real left = xsimd::select(busy, end_ - offset_, length_);
    step_ = left / xsimd::ceil(left / length_);
    reached_ = xsimd::select(step_ < left, offset_ + step_, end_);
    State errors;
    stepper_.do_step(derivative, values_, rates_, offset_, after_, rates_after_, step_, errors);
    made_ = control(errors) & busy;
    const Mask happens = made_ & (least_guard() < Real(0.0));
    return {set_of(made_), set_of(happens), set_of(happens | (made_ & (reached_ >= end_)))};
  }

  Step step_of(std::size_t lane) const override {
    return {get(offset_, lane), get(reached_, lane), values_of(after_, lane)};
  }

  Values<N> at(std::size_t lane, double offset) const override {
    State values;
    stepper_.calc_state(Real(offset), values, values_, rates_, offset_, after_, rates_after_,
                        offset_ + step_);
    return values_of(values, lane);
  }

  void keep() override {
    for (std::size_t i = 0; i < 2UL * N; ++i) {
      values_[i] = xsimd::select(made_, after_[i], values_[i]);
      rates_[i] = xsimd::select(made_, rates_after_[i], rates_[i]);
    }
    offset_ = xsimd::select(made_, reached_, offset_);
  }

 private:
  using State = std::array<Real, 2UL * N>;
  using Equations = LeanEquations<N, Real>;
  struct Line {
    Real value = 0.0, rate = 0.0;  ///< m/s², m/s³
  };

  static Values<N> values_of(const State& state, std::size_t lane) {
    Values<N> values;
    for (std::size_t i = 0; i < 2UL * N; ++i) values[i] = get(state[i], lane);
    return values;
  }

  typename Equations::Response respond(const State& values, const Real& offset) const {
    return Equations(linkage_, gravity_)
        .respond(values, horizontal_.value + offset * horizontal_.rate,
                 vertical_.value + offset * vertical_.rate);
  }

  /// Sets the next steps; true where this one is accurate enough. As default_error_checker and
  /// default_step_adjuster do.
  Mask control(const State& errors) {
    Real error = 0;
    for (std::size_t i = 0; i < 2UL * N; ++i)
      error = xsimd::max(
          error, xsimd::abs(errors[i]) /
                     (tolerance_ + tolerance_ * (xsimd::abs(values_[i]) + xsimd::abs(step_ * rates_[i]))));
    const Mask accurate = error <= Real(1);
    const Real least = std::pow(5.0, -5);
    const Real factor =
        0.9 * xsimd::pow(xsimd::max(error, least), xsimd::select(accurate, Real(-1.0 / 5), Real(-1.0 / 3)));
    const Real longer = xsimd::select(error < Real(0.5), step_ * factor, step_);
    length_ = xsimd::select(accurate, xsimd::max(longer, length_), step_ * xsimd::max(factor, Real(0.2)));
    return accurate;
  }

  /// The least of the guards of Stepped after the step.
  Real least_guard() const {
    Real least = 1;
    Real leaning = 0;
    bool closed = false;
    for (std::size_t k = 0; k < N; ++k) {
      const Mask open = sides_[k] != Real(0);
      leaning += after_[k];
      least = xsimd::min(least, toppling_[k] - xsimd::abs(leaning));
      least = xsimd::min(least, xsimd::select(open, sides_[k] * after_[k], Real(1)));
      closed = closed || !xsimd::all(open);
    }
    if (!closed) return least;
    const auto response = respond(after_, reached_);
    for (std::size_t k = 0; k < N; ++k) {
      const Real margin = xsimd::min(response.right[k], response.left[k]);
      least = xsimd::min(least, xsimd::select(sides_[k] == Real(0), margin, Real(1)));
    }
    return least;
  }

  boost::numeric::odeint::runge_kutta_dopri5<State, Real, State, Real> stepper_;
  Real tolerance_;
  bool fresh_ = true;  ///< the first derivative is not known
  Linkage<Real, N> linkage_;
  Real gravity_ = 0.0, busy_ = 0.0;
  std::array<Real, N> sides_, toppling_;
  Line horizontal_, vertical_;
  Real offset_ = 0.0, end_ = 1.0;  ///< in the piece of ground, s
  Real length_ = 1e-3;             ///< of the next step, s
  State values_, rates_;
  Real step_ = 0.0, reached_ = 0.0;
  State after_, rates_after_;
  Mask made_ = false;
};

}  // namespace

template <int N>
std::unique_ptr<PackSteps<N>> make_pack_steps(double tolerance) {
  return std::make_unique<Avx2Steps<N>>(tolerance);
}

template std::unique_ptr<PackSteps<1>> make_pack_steps(double tolerance);
template std::unique_ptr<PackSteps<2>> make_pack_steps(double tolerance);

}  // namespace rockstack::benchmarks
