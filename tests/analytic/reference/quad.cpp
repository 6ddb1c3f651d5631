#include "tests/analytic/reference/quad.hpp"

#include "analytic/solver/solver.hpp"

namespace rockstack::testing {

QuadHistory reference(const Scene& scene, std::vector<double> sample_times) {
  SolveOptions options;
  options.resolution = std::numeric_limits<double>::epsilon();
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
