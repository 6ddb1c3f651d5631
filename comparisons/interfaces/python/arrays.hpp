#pragma once

#include <pybind11/numpy.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rockstack::python {

using Shape = std::vector<pybind11::ssize_t>;

/// A read-only array of numbers that `owner` keeps, and which keeps `owner`.
template <class Number>
pybind11::array view(const std::vector<Number>& numbers, const Shape& shape, const pybind11::object& owner) {
  pybind11::array_t<Number> array(shape, numbers.data(), owner);
  pybind11::detail::array_proxy(array.ptr())->flags &= ~pybind11::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// An array of its own.
template <class Number>
pybind11::array_t<Number> copied(const std::vector<Number>& numbers) {
  pybind11::array_t<Number> array(static_cast<pybind11::ssize_t>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), array.mutable_data());
  return array;
}

}  // namespace rockstack::python
