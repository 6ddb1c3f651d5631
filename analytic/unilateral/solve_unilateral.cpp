#include "analytic/unilateral/solve_unilateral.hpp"

#include <stdexcept>
#include <utility>

#include "analytic/unilateral/contact_solver.hpp"

namespace rockstack {

ContactHistory solve_unilateral(const Scene& scene, const ContactOptions& options) {
  validate(scene);
  if (!(options.resolution >= 0)) throw std::invalid_argument("resolution: must be ≥ 0");
  ContactSolver<double> solver(scene, options);
  try {
    solver.run();
  } catch (const std::runtime_error& failure) {
    throw UnfinishedContacts(failure.what(), std::move(solver).history());
  }
  return std::move(solver).history();
}

}  // namespace rockstack
