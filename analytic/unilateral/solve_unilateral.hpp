#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "analytic/unilateral/contact_energy.hpp"
#include "analytic/unilateral/contact_history.hpp"

namespace rockstack {

/// A motion that could not be followed to its end: why, and what is known of it.
class UnfinishedContacts : public std::runtime_error {
 public:
  UnfinishedContacts(const std::string& reason, ContactHistory known)
      : std::runtime_error(reason), history(std::move(known)) {}
  ContactHistory history;  ///< up to there
};

/// The exact motion of rigid blocks that push, rub by Coulomb's law, lift off, fly and land without bounce.
/// The law and the equations of the scene are not asked for: they are unilateral and nonlinear. Other number
/// types: ContactSolver<Real> in contact_solver.hpp.
/// @throws FieldError for a scene out of range; std::invalid_argument for options out of range;
/// UnfinishedContacts where events do not come to an end; std::domain_error where masses or sizes are so far
/// apart that contact forces keep fewer than six digits.
ContactHistory solve_unilateral(const Scene& scene, const ContactOptions& options = {});

}  // namespace rockstack
