#include "analytic/unilateral/solve_contacts.hpp"

#include "analytic/unilateral/contact_solver.hpp"

namespace rockstack {

template <class Real>
BasicHistory<Real> solve_contacts(const Scene& scene, const SolveOptions& options, Branching* branching) {
  ContactSolver<Real> solver(scene, options, branching);
  try {
    solver.run();
  } catch (const std::runtime_error& failure) {
    throw UnfinishedContacts<Real>(failure.what(), std::move(solver).history());
  }
  return std::move(solver).history();
}

template BasicHistory<double> solve_contacts(const Scene&, const SolveOptions&, Branching*);
template BasicHistory<long double> solve_contacts(const Scene&, const SolveOptions&, Branching*);

bool double_does(const Scene& scene) {
  return keeps_digits(ContactModel<>(scene.blocks, friction_of(scene)), 10);
}

}  // namespace rockstack
