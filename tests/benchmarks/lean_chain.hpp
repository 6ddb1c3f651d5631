#pragma once

#include <array>
#include <cmath>

#include "analytic/mechanics/dynamics.hpp"
#include "analytic/mechanics/linkage.hpp"
#include "analytic/steps/ground_pieces.hpp"

namespace rockstack::benchmarks {

/// Relative angles in rad, then relative velocities in rad/s.
template <int N>
using Values = std::array<double, 2 * N>;

/// A stack's equations of motion in one pattern, as somebody would write them who has N blocks and an
/// integrator of ordinary differential equations: constants computed once, no memory asked for, one sine and
/// cosine a moving body. All integrators here that need a right-hand side share it.
template <int N>
class LeanChain {
 public:
  LeanChain(const Model<double, N>& model, const Pattern& pattern)
      : linkage_(make_linkage(model.stack, pattern)), pattern_(pattern), gravity_(model.gravity) {}

  const Pattern& pattern() const { return pattern_; }

  /// Relative accelerations, and how far the centre of pressure of each closed interface stays from its right
  /// and left end, times the normal force.
  struct Response {
    std::array<double, N> accelerations;
    std::array<double, N> right, left;
  };

  /// `ground` is (ẍg, ÿg) in m/s².
  Response respond(const Values<N>& values, const Point<double>& ground) const {
    Bodies bodies = place(values);
    bodies.pull = {-ground.x(), -(gravity_ + ground.y())};
    Response response;
    std::array<double, N> known = known_moments(bodies);
    std::array<std::array<double, N>, N> mass = mass_matrix(bodies);
    response.accelerations = solve(mass, known);
    add_margins(bodies, mass, known, response);
    return response;
  }

 private:
  struct Vector2 {
    double x = 0, y = 0;
    Vector2 operator+(const Vector2& other) const { return {x + other.x, y + other.y}; }
    Vector2 operator-(const Vector2& other) const { return {x - other.x, y - other.y}; }
    Vector2 operator*(double factor) const { return {x * factor, y * factor}; }
    double dot(const Vector2& other) const { return x * other.x + y * other.y; }
    Vector2 quarter_turned() const { return {y, -x}; }
  };
  struct Bodies {
    std::array<double, N> cosine, sine, square;  ///< of the angle; of the angular velocity
    std::array<Vector2, N> moment, link;
    Vector2 pull;
  };

  bool closed(int k) const { return pattern_[k] == Contact::closed; }

  Bodies place(const Values<N>& values) const {
    Bodies bodies;
    double angle = 0;
    double rate = 0;
    for (int k = 0; k < N; ++k) {
      const auto i = static_cast<std::size_t>(k);
      angle += values[i];
      rate += values[i + N];
      bodies.cosine[i] = !closed(k) ? std::cos(angle) : k > 0 ? bodies.cosine[i - 1] : 1;
      bodies.sine[i] = !closed(k) ? std::sin(angle) : k > 0 ? bodies.sine[i - 1] : 0;
      bodies.square[i] = rate * rate;
      const auto turn = [&](double x, double y) {
        return Vector2{x * bodies.cosine[i] + y * bodies.sine[i], y * bodies.cosine[i] - x * bodies.sine[i]};
      };
      bodies.moment[i] = turn(linkage_.moment_x[i], linkage_.moment_y[i]);
      bodies.link[i] = turn(linkage_.link_x[i], linkage_.link_y[i]);
    }
    return bodies;
  }

  /// Moments about the pivots if nothing accelerated, summed from the top.
  static std::array<double, N> known_moments(const Bodies& bodies) {
    std::array<double, N> known;
    Vector2 below = bodies.pull * -1;
    for (std::size_t k = 0; k < N; ++k) {
      known[k] = bodies.moment[k].quarter_turned().dot(below);
      below = below - bodies.link[k] * bodies.square[k];
    }
    Vector2 above;
    double sum = 0;
    for (std::size_t k = N; k-- > 0;) {
      sum += known[k] + bodies.link[k].quarter_turned().dot(above);
      known[k] = sum;
      above = above - bodies.moment[k] * bodies.square[k];
    }
    return known;
  }

  std::array<std::array<double, N>, N> mass_matrix(const Bodies& bodies) const {
    std::array<std::array<double, N>, N> mass;
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

  std::array<double, N> solve(const std::array<std::array<double, N>, N>& mass,
                              const std::array<double, N>& known) const {
    static_assert(N == 1 || N == 2);
    std::array<double, N> result{};
    if constexpr (N == 1) {
      if (!closed(0)) result[0] = -known[0] / mass[0][0];
    } else if (closed(0) || closed(1)) {
      for (int k = 0; k < N; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (!closed(k)) result[i] = -known[i] / mass[i][i];
      }
    } else {
      const double inverse = 1 / (mass[0][0] * mass[1][1] - mass[0][1] * mass[0][1]);
      result[0] = (mass[0][1] * known[1] - mass[1][1] * known[0]) * inverse;
      result[1] = (mass[0][1] * known[0] - mass[0][0] * known[1]) * inverse;
    }
    return result;
  }

  void add_margins(const Bodies& bodies, const std::array<std::array<double, N>, N>& mass,
                   const std::array<double, N>& known, Response& response) const {
    std::array<Vector2, N> pivots;
    std::array<Vector2, N> own;
    Vector2 below = bodies.pull * -1;
    double spin = 0;
    for (std::size_t k = 0; k < N; ++k) {
      spin += response.accelerations[k];
      pivots[k] = below;
      own[k] = bodies.moment[k].quarter_turned() * spin - bodies.moment[k] * bodies.square[k];
      below = below + bodies.link[k].quarter_turned() * spin - bodies.link[k] * bodies.square[k];
    }
    Vector2 above;
    for (std::size_t k = N; k-- > 0;) {
      above = above + own[k];
      if (!closed(static_cast<int>(k))) continue;
      const Vector2 force = pivots[k] * linkage_.mass[k] + above;
      const double push = k == 0 ? force.y : force.x * bodies.sine[k - 1] + force.y * bodies.cosine[k - 1];
      double moment = known[k];
      for (std::size_t j = 0; j < N; ++j) moment += mass[k][j] * response.accelerations[j];
      response.right[k] = push * linkage_.width[k] + moment;
      response.left[k] = push * linkage_.width[k] - moment;
    }
  }

  Linkage<double, N> linkage_;
  Pattern pattern_;
  double gravity_;
};

/// What an integrator steps through: a pattern under a piece of ground motion.
template <int N>
struct Stretch {
  const LeanChain<N>* chain;
  const GroundPiece<double>* piece;

  typename LeanChain<N>::Response respond(const Values<N>& values, double offset) const {
    return chain->respond(values, piece->at(offset));
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
