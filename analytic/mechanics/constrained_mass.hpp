#pragma once

#include "analytic/scene/kinematics.hpp"

namespace rockstack {

template <class Real, int N>
using PerBlock = std::array<Real, static_cast<std::size_t>(capacity(N))>;

/// The mass matrix of relative angles, kg·m², with closed interfaces held: their rows and columns are those
/// of the identity. As factors L D Lᵀ.
template <class Real, int N>
class ConstrainedMass {
 public:
  /// `free` is 1 where an interface is open, 0 where it is closed; `mass(i, j)` is the matrix, i ≥ j.
  template <class Mass>
  void factorise(std::size_t blocks, const PerBlock<Real, N>& free, const Mass& mass) {
    blocks_ = blocks;
    for (std::size_t i = 0; i < size(); ++i) {
      free_[i] = free[i];
      for (std::size_t j = 0; j <= i; ++j) {
        Real sum = mass(i, j) * free[i] * free[j];
        if (i == j) sum += Real(1) - free[i];
        for (std::size_t m = 0; m < j; ++m) sum -= factors_[i][m] * factors_[m][m] * factors_[j][m];
        factors_[i][j] = i == j ? sum : sum * inverse_[j];
      }
      inverse_[i] = Real(1) / factors_[i][i];
    }
  }

  /// Of D: what is left of a diagonal entry when the motions of the interfaces below are taken out of it.
  const Real& diagonal(std::size_t k) const { return factors_[k][k]; }

  /// The relative motions that take up generalised momenta; zero where an interface is closed. Series ask for
  /// them at every order, and a call costs more than the answer.
  [[gnu::always_inline]] PerBlock<Real, N> solve(const PerBlock<Real, N>& momenta) const {
    PerBlock<Real, N> x;
    for (std::size_t i = 0; i < size(); ++i) {
      x[i] = momenta[i] * free_[i];
      for (std::size_t m = 0; m < i; ++m) x[i] -= factors_[i][m] * x[m];
    }
    for (std::size_t i = size(); i-- > 0;) {
      x[i] *= inverse_[i];
      for (std::size_t m = i + 1; m < size(); ++m) x[i] -= factors_[m][i] * x[m];
    }
    return x;
  }

 private:
  std::size_t size() const { return N == Eigen::Dynamic ? blocks_ : static_cast<std::size_t>(N); }

  std::size_t blocks_ = 0;
  PerBlock<Real, N> free_;
  std::array<PerBlock<Real, N>, capacity(N)> factors_;  ///< L below the diagonal, D on it
  PerBlock<Real, N> inverse_;                           ///< of D
};

}  // namespace rockstack
