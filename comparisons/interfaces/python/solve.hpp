#pragma once

#include <pybind11/pybind11.h>

namespace rockstack::python {

/// solve and solve_many.
void add_solve(pybind11::module_& core);

}  // namespace rockstack::python
