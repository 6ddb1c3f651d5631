#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "comparisons/python/compare.hpp"
#include "comparisons/python/engines.hpp"
#include "comparisons/python/errors.hpp"
#include "comparisons/python/ground.hpp"
#include "comparisons/python/keys.hpp"
#include "comparisons/python/motion.hpp"
#include "comparisons/python/scene.hpp"
#include "comparisons/python/solve.hpp"
#include "comparisons/python/sweep.hpp"
#include "comparisons/results/build.hpp"
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
