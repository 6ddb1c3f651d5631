#pragma once

#include <pybind11/pybind11.h>

namespace rockstack::python {

void add_keys(pybind11::module_& core);

}  // namespace rockstack::python
