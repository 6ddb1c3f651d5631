#include "comparisons/interfaces/python/errors.hpp"

#include <exception>
#include <stdexcept>
#include <utility>

namespace rockstack::python {

namespace py = pybind11;

void add_errors(py::module_& core) {
  // Kept for as long as the interpreter lives, as a translator has no end.
  core.attr("InputError") = py::module_::import("rockstack.errors").attr("InputError");
  static const py::handle input_error = py::object(core.attr("InputError")).release();
  py::register_exception_translator([](std::exception_ptr failure) {
    try {
      if (failure) std::rethrow_exception(std::move(failure));
    } catch (const std::invalid_argument& error) {
      PyErr_SetString(input_error.ptr(), error.what());
    }
  });
}

}  // namespace rockstack::python
