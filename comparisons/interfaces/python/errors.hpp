#pragma once

#include <pybind11/pybind11.h>

namespace rockstack::python {

/// Lets what is thrown for wrong input arrive as rockstack.InputError, with its text.
void add_errors(pybind11::module_& core);

}  // namespace rockstack::python
