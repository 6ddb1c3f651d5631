#pragma once

#include <Eigen/Core>
#include <optional>

namespace rockstack {

/// z ≥ 0 with w = q + Az ≥ 0 and zᵀw = 0.
struct ComplementarySolution {
  Eigen::VectorXd z, w;
};

/// A solution of a linear complementarity problem by Lemke's method with the lexicographic rule, so that it
/// ends; nothing where it ends in a ray. It finds one wherever A is copositive and q is one of impacts:
/// Stewart & Trinkle 1996, Int. J. Numer. Meth. Engng 39, 2673–2691.
std::optional<ComplementarySolution> solve_complementarity(const Eigen::MatrixXd& matrix,
                                                           const Eigen::VectorXd& vector);

}  // namespace rockstack
