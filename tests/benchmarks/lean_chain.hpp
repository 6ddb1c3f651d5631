#pragma once

#include <array>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/mechanics/linkage.hpp"
#include "analytic/steps/ground_pieces.hpp"

namespace rockstack::benchmarks {

/// Relative angles in rad, then relative velocities in rad/s.
template <int N>
using Values = std::array<double, 2UL * N>;

/// A stack's equations of motion in one pattern, as somebody would write them who has N blocks and an
/// integrator of ordinary differential equations: constants computed once, no memory asked for, one sine and
/// cosine a moving body. All integrators here that need a right-hand side share it; `Real` is a double, or a
/// pack of stacks that have a pattern each.
template <int N, class Real = double>
class LeanEquations {
 public:
  using Values = std::array<Real, 2UL * N>;

  LeanEquations(const Linkage<Real, N>& linkage, const Real& gravity)
      : linkage_(linkage), gravity_(gravity) {}

  const Linkage<Real, N>& linkage() const { return linkage_; }

  /// Relative accelerations, and how far the centre of pressure of each interface stays from its right and
  /// left end, times the normal force, where it is closed.
  struct Response {
    std::array<Real, N> accelerations;
    std::array<Real, N> right, left;
  };

  /// Response to the ground's acceleration, m/s².
  Response respond(const Values& values, const Real& horizontal, const Real& vertical) const {
    Bodies bodies = place(values);
    bodies.pull = {-horizontal, -(gravity_ + vertical)};
    Response response;
    std::array<Real, N> known = known_moments(bodies);
    std::array<std::array<Real, N>, N> mass = mass_matrix(bodies);
    response.accelerations = solve(mass, known);
    add_margins(bodies, mass, known, response);
    return response;
  }

 private:
  struct Vector2 {
    Real x, y;
    Vector2 operator+(const Vector2& other) const { return {x + other.x, y + other.y}; }
    Vector2 operator-(const Vector2& other) const { return {x - other.x, y - other.y}; }
    Vector2 operator*(const Real& factor) const { return {x * factor, y * factor}; }
    Real dot(const Vector2& other) const { return x * other.x + y * other.y; }
    Vector2 quarter_turned() const { return {y, -x}; }
  };
  struct Bodies {
    std::array<Real, N> cosine, sine, square;  ///< of the angle; of the angular velocity
    std::array<Vector2, N> moment, link;
    Vector2 pull;
  };

  /// A body is turned as that below it where the interface between them is closed.
  void turn(std::size_t k, const Real& angle, Bodies& bodies) const {
    if constexpr (std::is_same_v<Real, double>) {
      const bool open = linkage_.free[k] != 0;
      bodies.cosine[k] = open ? std::cos(angle) : k > 0 ? bodies.cosine[k - 1] : 1;
      bodies.sine[k] = open ? std::sin(angle) : k > 0 ? bodies.sine[k - 1] : 0;
    } else {
      std::tie(bodies.sine[k], bodies.cosine[k]) = sincos(angle);
    }
  }

  Bodies place(const Values& values) const {
    Bodies bodies;
    Real angle = 0;
    Real rate = 0;
    for (std::size_t k = 0; k < N; ++k) {
      angle += values[k];
      rate += values[k + N];
      turn(k, angle, bodies);
      bodies.square[k] = rate * rate;
      const auto turned = [&](const Real& x, const Real& y) {
        return Vector2{x * bodies.cosine[k] + y * bodies.sine[k], y * bodies.cosine[k] - x * bodies.sine[k]};
      };
      bodies.moment[k] = turned(linkage_.moment_x[k], linkage_.moment_y[k]);
      bodies.link[k] = turned(linkage_.link_x[k], linkage_.link_y[k]);
    }
    return bodies;
  }

  /// Moments about the pivots if nothing accelerated, summed from the top.
  static std::array<Real, N> known_moments(const Bodies& bodies) {
    std::array<Real, N> known;
    Vector2 below{-bodies.pull.x, -bodies.pull.y};
    for (std::size_t k = 0; k < N; ++k) {
      known[k] = bodies.moment[k].quarter_turned().dot(below);
      below = below - bodies.link[k] * bodies.square[k];
    }
    Vector2 above{0, 0};
    Real sum = 0;
    for (std::size_t k = N; k-- > 0;) {
      sum += known[k] + bodies.link[k].quarter_turned().dot(above);
      known[k] = sum;
      above = above - bodies.moment[k] * bodies.square[k];
    }
    return known;
  }

  std::array<std::array<Real, N>, N> mass_matrix(const Bodies& bodies) const {
    std::array<std::array<Real, N>, N> mass;
    for (std::size_t j = 0; j < N; ++j) {
      mass[j][j] = linkage_.inertia[j];
      for (std::size_t i = 0; i < j; ++i) mass[i][j] = mass[j][i] = bodies.link[i].dot(bodies.moment[j]);
    }
    for (std::size_t i = N - 1; i-- > 0;)
      for (std::size_t j = 0; j < N; ++j) mass[i][j] += mass[i + 1][j];
    for (std::size_t j = N - 1; j-- > 0;)
      for (std::size_t i = 0; i < N; ++i) mass[i][j] += mass[i][j + 1];
    return mass;
  }

  /// Closed interfaces neither accelerate nor couple.
  std::array<Real, N> solve(const std::array<std::array<Real, N>, N>& mass,
                            const std::array<Real, N>& known) const {
    static_assert(N == 1 || N == 2);
    if constexpr (N == 1) {
      return {-linkage_.free[0] * known[0] / mass[0][0]};
    } else {
      const Real first = linkage_.free[0] * known[0];
      const Real second = linkage_.free[1] * known[1];
      const Real coupling = linkage_.free[0] * linkage_.free[1] * mass[0][1];
      const Real inverse = 1 / (mass[0][0] * mass[1][1] - coupling * coupling);
      return {(coupling * second - mass[1][1] * first) * inverse,
              (coupling * first - mass[0][0] * second) * inverse};
    }
  }

  void add_margins(const Bodies& bodies, const std::array<std::array<Real, N>, N>& mass,
                   const std::array<Real, N>& known, Response& response) const {
    std::array<Vector2, N> pivots;
    std::array<Vector2, N> own;
    Vector2 below{-bodies.pull.x, -bodies.pull.y};
    Real spin = 0;
    for (std::size_t k = 0; k < N; ++k) {
      spin += response.accelerations[k];
      pivots[k] = below;
      own[k] = bodies.moment[k].quarter_turned() * spin - bodies.moment[k] * bodies.square[k];
      below = below + bodies.link[k].quarter_turned() * spin - bodies.link[k] * bodies.square[k];
    }
    Vector2 above{0, 0};
    for (std::size_t k = N; k-- > 0;) {
      above = above + own[k];
      const Vector2 force = pivots[k] * linkage_.mass[k] + above;
      const Real push = k == 0 ? force.y : force.x * bodies.sine[k - 1] + force.y * bodies.cosine[k - 1];
      Real moment = known[k];
      for (std::size_t j = 0; j < N; ++j) moment += mass[k][j] * response.accelerations[j];
      response.right[k] = push * linkage_.width[k] + moment;
      response.left[k] = push * linkage_.width[k] - moment;
    }
  }

  Linkage<Real, N> linkage_;
  Real gravity_;
};

/// The equations of one stack, with its pattern.
template <int N>
class LeanChain : public LeanEquations<N> {
 public:
  LeanChain(const Model<double, N>& model, const Pattern& pattern)
      : LeanEquations<N>(make_linkage(model.stack, pattern), model.gravity), pattern_(pattern) {}

  const Pattern& pattern() const { return pattern_; }

 private:
  Pattern pattern_;
};

/// What the ground's acceleration may change by at the end of a piece for derivatives to go on there, m/s².
inline constexpr double continuous_ground = 1e-12;

/// What an integrator steps through: a pattern under a piece of ground motion.
template <int N>
struct Stretch {
  const LeanChain<N>* chain;
  const GroundPiece<double>* piece;

  typename LeanChain<N>::Response respond(const Values<N>& values, double offset) const {
    return chain->respond(values, piece->horizontal.at(offset), piece->vertical.at(offset));
  }
  void derivative(const Values<N>& values, double offset, double* rates) const {
    const auto response = respond(values, offset);
    for (std::size_t k = 0; k < N; ++k) {
      rates[k] = values[k + N];
      rates[k + N] = response.accelerations[k];
    }
  }
};

}  // namespace rockstack::benchmarks
