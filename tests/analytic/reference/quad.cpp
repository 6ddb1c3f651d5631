#include "tests/analytic/reference/quad.hpp"

#include "analytic/solver/solver.hpp"
#include "analytic/unilateral/contact_solver.hpp"

namespace rockstack::testing {
namespace {

QuadHistory reference_of_contacts(const Scene& scene, const SolveOptions& options) {
  ContactSolver<Quad> solver(scene, options);
  solver.run();
  return std::move(solver).history();
}

}  // namespace

QuadHistory reference(const Scene& scene, std::vector<double> sample_times, double look_ahead) {
  constexpr double resolution = std::numeric_limits<double>::epsilon();
  if (leaves_pivots(scene.law))
    return reference_of_contacts(
        scene, {.sample_times = std::move(sample_times), .resolution = resolution, .look_ahead = look_ahead});
  SolveOptions options;
  options.resolution = resolution;
  options.sample_times = std::move(sample_times);
  switch (scene.blocks.size()) {
    case 1:
      return Solver<Quad, 1>(scene, options).run();
    case 2:
      return Solver<Quad, 2>(scene, options).run();
    default:
      return Solver<Quad>(scene, options).run();
  }
}

}  // namespace rockstack::testing
