#pragma once

#include <pybind11/pybind11.h>

#include "analytic/scene/input/document.hpp"

namespace rockstack::python {

/// A value as the readers of files take it, read into `target`: mappings are tables, sequences and arrays are
/// arrays, and keys whose value is None are left out. @throws InputError for what no file can hold.
void read_value(const pybind11::handle& value, Node& target);

/// The top of a document from a mapping; `place` is what messages say in place of file and line.
Node read_document(const pybind11::handle& mapping, const std::string& place);

/// The same as Python has it: dict, list, float, str.
pybind11::object to_python(const Node& node);

}  // namespace rockstack::python
