#pragma once

#include <stdexcept>

#include "analytic/scene/branching.hpp"
#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {

/// A motion that could not be followed to its end: why, and what is known of it.
template <class Real>
class UnfinishedContacts : public std::runtime_error {
 public:
  UnfinishedContacts(const std::string& reason, BasicHistory<Real> known)
      : std::runtime_error(reason), history(std::move(known)) {}
  BasicHistory<Real> history;  ///< up to there
};

/// The exact motion of rigid blocks that push, rub by Coulomb's law, lift off, fly and land without bounce,
/// in one number type, double or long double. The law and the equations of the scene are not asked for:
/// blocks rub, and their equations are nonlinear; springs of the scene act. Other number types:
/// ContactSolver<Real> in contact_solver.hpp. `branching` leads it where contact leaves several motions.
/// Precondition: scene and options pass validate(), and double is asked for where double_does().
/// @throws UnfinishedContacts where events do not come to an end; std::domain_error where masses or sizes
/// are so far apart that contact forces keep fewer than six digits.
template <class Real>
BasicHistory<Real> solve_contacts(const Scene& scene, const SolveOptions& options,
                                  Branching* branching = nullptr);

/// Whether contact forces and sizes keep ten digits in double. Where they do not, the energy that events make
/// is more than a thousand roundings. Precondition: the scene passes validate().
bool double_does(const Scene& scene);

}  // namespace rockstack
