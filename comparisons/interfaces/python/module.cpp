#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "comparisons/interfaces/python/compare.hpp"
#include "comparisons/interfaces/python/engines.hpp"
#include "comparisons/interfaces/python/errors.hpp"
#include "comparisons/interfaces/python/ground.hpp"
#include "comparisons/interfaces/python/keys.hpp"
#include "comparisons/interfaces/python/motion.hpp"
#include "comparisons/interfaces/python/scene.hpp"
#include "comparisons/interfaces/python/solve.hpp"
#include "comparisons/interfaces/python/sweep.hpp"
#include "comparisons/measures/results/build.hpp"
#include "comparisons/suites/shipped.hpp"

// What the package `rockstack` in this folder is written over: no more than Python needs to be told, without
// words.
PYBIND11_MODULE(_core, core) {
  using namespace rockstack;
  core.attr("version") = build::version;
  core.def("shipped_names", &shipped_names);
  python::add_errors(core);
  python::add_scene(core);
  python::add_motion(core);
  python::add_solve(core);
  python::add_ground(core);
  python::add_keys(core);
  python::add_sweep(core);
  python::add_engines(core);
  python::add_compare(core);
}
