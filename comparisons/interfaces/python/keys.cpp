#include "comparisons/interfaces/python/keys.hpp"

#include "analytic/scene/input/scene_keys.hpp"
#include "comparisons/studies/sweep/ensemble_keys.hpp"
#include "comparisons/suites/suite_keys.hpp"

namespace rockstack::python {
namespace {

namespace py = pybind11;

py::list rows(std::initializer_list<const KeyTable*> tables) {
  py::list list;
  for (const KeyTable* table : tables) {
    for (const InputKey& key : table->keys)
      list.append(py::dict(py::arg("table") = table->header, py::arg("key") = key.name,
                           py::arg("unit") = key.unit, py::arg("range") = key.range,
                           py::arg("default") = key.standard, py::arg("meaning") = key.meaning,
                           py::arg("example") = key.example));
  }
  return list;
}

}  // namespace

void add_keys(py::module_& core) {
  core.def("keys", [] {
    return py::dict(py::arg("scene") = rows(scene_tables), py::arg("suite") = rows(suite_tables),
                    py::arg("ensemble") = rows(ensemble_tables));
  });
}

}  // namespace rockstack::python
