#pragma once

#include "tests/analytic/proof/series.hpp"
#include "tests/analytic/proof/stack.hpp"

namespace rockstack::proof {

// Equations of motion of a chain of pivots, once for balls, complex balls and Taylor series. Block k turns by
// θₖ, clockwise positive, about a pivot from which its centre of mass is at the arm rₖ and the next pivot at
// the link Lₖ. With φ the relative angles, Mφ̈ = Q; what a closed interface holds is the residual of its row.

template <class Number>
struct Point {
  Number x, y;
};
template <class Number>
Point<Number> operator+(const Point<Number>& a, const Point<Number>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class Number>
Point<Number> operator-(const Point<Number>& a, const Point<Number>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class Number>
Point<Number> operator*(const Number& factor, const Point<Number>& a) {
  return {factor * a.x, factor * a.y};
}
template <class Number>
Number dot(const Point<Number>& a, const Point<Number>& b) {
  return a.x * b.x + a.y * b.y;
}
/// The velocity of a point at `arm` from a pivot, at unit clockwise rate.
template <class Number>
Point<Number> quarter_turned(const Point<Number>& arm) {
  return {arm.y, Number(0) - arm.x};
}

template <class Number>
struct Chain {
  std::vector<SineCosine<Number>> directions;  ///< of θ
  std::vector<Point<Number>> arms, links;      ///< r and L, m
  std::vector<Point<Number>> moments;          ///< S = m r + (mass above) L, kg·m
};

/// Masses above each block, kg.
inline std::vector<Ball> masses_above(const Stack& stack) {
  std::vector<Ball> above(stack.size());
  for (std::size_t k = stack.size() - 1; k > 0; --k) above[k - 1] = above[k] + stack.mass[k];
  return above;
}

/// Sums from the ground up: absolute angles or rates from relative ones. A closed interface has none.
template <class Number>
std::vector<Number> summed(const Pattern& pattern, const std::vector<Number>& relative) {
  std::vector<Number> absolute;
  Number sum(0);
  for (std::size_t k = 0; k < pattern.size(); ++k)
    absolute.push_back(sum = pattern[k] ? sum + relative[k] : sum);
  return absolute;
}

/// Sums from the top down: the force on φₖ is that on all θⱼ with j ≥ k.
template <class Number>
void sum_downwards(std::vector<Number>& values) {
  for (std::size_t k = values.size() - 1; k > 0; --k) values[k - 1] = values[k - 1] + values[k];
}

template <class Number>
Chain<Number> make_chain(const Stack& stack, const Pattern& pattern, const std::vector<Number>& angles,
                         const std::vector<Number>& rates) {
  const std::vector<Number> theta = summed(pattern, angles);
  const std::vector<Number> omega = summed(pattern, rates);
  const std::vector<Ball> above = masses_above(stack);
  Chain<Number> chain;
  SineCosine<Number> direction{0, 1};
  for (std::size_t k = 0; k < stack.size(); ++k) {
    if (pattern[k]) direction = sine_cosine(theta[k], omega[k]);
    const auto turned = [&](const Ball& x, const Ball& y) {
      return Point<Number>{Number(x) * direction.cosine + Number(y) * direction.sine,
                           Number(y) * direction.cosine - Number(x) * direction.sine};
    };
    const Ball pivot = stack.pivot(pattern, k);
    const Ball link_x = stack.pivot(pattern, k + 1) - pivot;
    const Ball arm_x = stack.centre_x[k] - pivot;
    chain.directions.push_back(direction);
    chain.arms.push_back(turned(arm_x, stack.centre_y[k]));
    chain.links.push_back(turned(link_x, stack.height[k]));
    chain.moments.push_back(turned(stack.mass[k] * arm_x + above[k] * link_x,
                                   stack.mass[k] * stack.centre_y[k] + above[k] * stack.height[k]));
  }
  return chain;
}

template <class Number>
using Matrix = std::vector<std::vector<Number>>;

/// M, of relative angles: Aᵢⱼ = Lᵢ·Sⱼ of absolute ones for i < j, summed over both.
template <class Number>
Matrix<Number> mass_matrix(const Stack& stack, const Pattern& pattern, const Chain<Number>& chain) {
  const std::size_t size = stack.size();
  const std::vector<Ball> above = masses_above(stack);
  Matrix<Number> matrix(size, std::vector<Number>(size, Number(0)));
  for (std::size_t j = 0; j < size; ++j) {
    const Ball pivot = stack.pivot(pattern, j);
    const Ball link_x = stack.pivot(pattern, j + 1) - pivot;
    const Ball arm_x = stack.centre_x[j] - pivot;
    matrix[j][j] = stack.inertia[j] +
                   stack.mass[j] * (arm_x * arm_x + stack.centre_y[j] * stack.centre_y[j]) +
                   above[j] * (link_x * link_x + stack.height[j] * stack.height[j]);
    for (std::size_t i = 0; i < j; ++i) matrix[i][j] = matrix[j][i] = dot(chain.links[i], chain.moments[j]);
  }
  for (std::size_t i = size - 1; i > 0; --i)
    for (std::size_t j = 0; j < size; ++j) matrix[i - 1][j] = matrix[i - 1][j] + matrix[i][j];
  for (std::vector<Number>& row : matrix) sum_downwards(row);
  return matrix;
}

/// Solves the rows and columns of open interfaces by elimination; 0 where closed.
template <class Number>
std::vector<Number> solve_open(const Pattern& pattern, Matrix<Number> matrix, std::vector<Number> right) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < pattern.size(); ++k)
    if (pattern[k]) open.push_back(k);
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t j = i + 1; j < open.size(); ++j) {
      const Number factor = matrix[open[j]][open[i]] / matrix[open[i]][open[i]];
      for (std::size_t l = i + 1; l < open.size(); ++l)
        matrix[open[j]][open[l]] = matrix[open[j]][open[l]] - factor * matrix[open[i]][open[l]];
      right[open[j]] = right[open[j]] - factor * right[open[i]];
    }
  std::vector<Number> solution(pattern.size(), Number(0));
  for (std::size_t i = open.size(); i-- > 0;) {
    Number rest = right[open[i]];
    for (std::size_t l = i + 1; l < open.size(); ++l)
      rest = rest - matrix[open[i]][open[l]] * solution[open[l]];
    solution[open[i]] = rest / matrix[open[i]][open[i]];
  }
  return solution;
}

/// What a closed interface's residual of a row, and the force across its face, leave on either side: wN ± τ >
/// 0 as long as its centre of pressure is inside its width.
template <class Number>
struct Margins {
  Number right, left;
};

template <class Number>
struct Accelerations {
  std::vector<Number> relative;          ///< φ̈, rad/s²; 0 where closed
  std::vector<Margins<Number>> margins;  ///< of closed interfaces, N·m; else 0
};

/// Q of relative angles: the body force's moment, and what is centripetal of the blocks above and below.
template <class Number>
std::vector<Number> generalized_forces(const Chain<Number>& chain, const std::vector<Number>& squares,
                                       const Point<Number>& body_force) {
  const std::size_t size = squares.size();
  std::vector<Number> forces(size, Number(0));
  for (std::size_t k = 0; k < size; ++k) {
    Number sum = dot(quarter_turned(chain.moments[k]), body_force);
    for (std::size_t j = k + 1; j < size; ++j)
      sum = sum + squares[j] * dot(quarter_turned(chain.links[k]), chain.moments[j]);
    for (std::size_t j = 0; j < k; ++j)
      sum = sum + squares[j] * dot(quarter_turned(chain.moments[k]), chain.links[j]);
    forces[k] = sum;
  }
  sum_downwards(forces);
  return forces;
}

/// The force that each interface bears in all, N: m(a − b) of all above it, where the second derivative of an
/// arm r is ω̇ r⊥ − ω² r.
template <class Number>
std::vector<Point<Number>> supports(const Stack& stack, const Chain<Number>& chain,
                                    const std::vector<Number>& turning, const std::vector<Number>& squares,
                                    const Point<Number>& body_force) {
  const auto second = [&](std::size_t k, const Point<Number>& arm) {
    return turning[k] * quarter_turned(arm) - squares[k] * arm;
  };
  std::vector<Point<Number>> result(stack.size());
  Point<Number> own{0, 0};
  Ball mass;
  for (std::size_t k = stack.size(); k-- > 0;) {
    mass = mass + stack.mass[k];
    own = own + second(k, chain.moments[k]);
    Point<Number> support = own - Number(mass) * body_force;
    for (std::size_t j = 0; j < k; ++j) support = support + Number(mass) * second(j, chain.links[j]);
    result[k] = support;
  }
  return result;
}

/// Row k of M times rates, less the right side: the moment at a closed interface's middle.
template <class Number>
Number residual(const Matrix<Number>& matrix, const std::vector<Number>& rates,
                const std::vector<Number>& right, std::size_t k, const Pattern& pattern) {
  Number sum = Number(0) - right[k];
  for (std::size_t j = 0; j < pattern.size(); ++j)
    if (pattern[j]) sum = sum + matrix[k][j] * rates[j];
  return sum;
}

template <class Number>
Margins<Number> margins_of(const Ball& half_width, const Number& normal, const Number& moment) {
  const Number lever = Number(half_width) * normal;
  return {lever + moment, lever - moment};
}

/// Accelerations and margins at a state. The ground accelerates by `ground`, m/s².
template <class Number>
Accelerations<Number> accelerate(const Stack& stack, const Pattern& pattern,
                                 const std::vector<Number>& angles, const std::vector<Number>& rates,
                                 const Point<Number>& ground) {
  const Chain<Number> chain = make_chain(stack, pattern, angles, rates);
  const Matrix<Number> matrix = mass_matrix(stack, pattern, chain);
  const Point<Number> body_force{Number(stack.downhill) - ground.x,
                                 Number(0) - Number(stack.gravity) - ground.y};
  std::vector<Number> squares;
  const std::vector<Number> omega = summed(pattern, rates);
  for (std::size_t k = 0; k < omega.size(); ++k)
    squares.push_back(k > 0 && !pattern[k] ? squares[k - 1] : omega[k] * omega[k]);
  const std::vector<Number> forces = generalized_forces(chain, squares, body_force);
  Accelerations<Number> result{solve_open(pattern, matrix, forces), {}};
  const std::vector<Point<Number>> support =
      supports(stack, chain, summed(pattern, result.relative), squares, body_force);
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    if (pattern[k]) {
      result.margins.push_back({0, 0});
      continue;
    }
    const Number normal = support[k].x * chain.directions[k].sine + support[k].y * chain.directions[k].cosine;
    result.margins.push_back(
        margins_of(stack.half_width[k], normal, residual(matrix, result.relative, forces, k, pattern)));
  }
  return result;
}

}  // namespace rockstack::proof
