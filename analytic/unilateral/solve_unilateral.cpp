#include "analytic/unilateral/solve_unilateral.hpp"

#include <stdexcept>
#include <utility>

#include "analytic/scene/solve_options.hpp"
#include "analytic/unilateral/contact_solver.hpp"
#include "analytic/unilateral/contacts_in_double.hpp"

namespace rockstack {

template <class Real>
BasicContactHistory<Real> solve_contacts(const Scene& scene, const ContactOptions& options) {
  validate(scene);
  if (!(options.resolution >= 0)) throw std::invalid_argument("resolution: must be ≥ 0");
  validate_sample_times(options.sample_times);
  ContactSolver<Real> solver(scene, options);
  try {
    solver.run();
  } catch (const std::runtime_error& failure) {
    throw BasicUnfinishedContacts<Real>(failure.what(), std::move(solver).history());
  }
  return std::move(solver).history();
}

template BasicContactHistory<double> solve_contacts(const Scene&, const ContactOptions&);
template BasicContactHistory<long double> solve_contacts(const Scene&, const ContactOptions&);

bool double_does(const Scene& scene) {
  validate(scene);
  return keeps_digits(FrictionStack(scene.blocks, friction_of(scene)), 10);
}

ContactHistory solve_unilateral(const Scene& scene, const ContactOptions& options) {
  if (double_does(scene)) return solve_contacts<double>(scene, options);
  try {
    return in_double(solve_contacts<long double>(scene, options));
  } catch (const BasicUnfinishedContacts<long double>& unfinished) {
    throw UnfinishedContacts(unfinished.what(), in_double(unfinished.history));
  }
}

}  // namespace rockstack
