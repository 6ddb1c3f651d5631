#include "comparisons/interfaces/python/module.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <exception>
#include <future>

#include "analytic/scene/input/scene_keys.hpp"
#include "comparisons/measures/results/build.hpp"
#include "comparisons/studies/sweep/ensemble.hpp"
#include "comparisons/suites/shipped.hpp"
#include "comparisons/suites/suite_keys.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack::python {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds pause{50};

bool signal_raised() {
  const py::gil_scoped_acquire lock;
  return PyErr_Occurred() != nullptr || PyErr_CheckSignals() != 0;
}

void tell(const ToldProgress& progress) {
  if (progress.tell.is_none()) return;
  const py::gil_scoped_acquire lock;
  try {
    progress.tell(progress.done.load(), progress.total.load());
  } catch (py::error_already_set& error) {
    error.restore();
  }
}

/// Lets what is thrown for wrong input arrive as rockstack.InputError, with its text.
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

py::list rows(std::initializer_list<const KeyTable*> tables) {
  using namespace py::literals;
  py::list list;
  for (const KeyTable* table : tables)
    for (const InputKey& key : table->keys)
      list.append(py::dict("table"_a = table->header, "key"_a = key.name, "unit"_a = key.unit,
                           "range"_a = key.range, "default"_a = key.default_value, "meaning"_a = key.meaning,
                           "example"_a = key.example));
  return list;
}

py::dict keys() {
  return py::dict(py::arg("scene") = rows(scene_tables), py::arg("suite") = rows(suite_tables),
                  py::arg("ensemble") = rows(ensemble_tables));
}

}  // namespace

std::function<bool()> interrupts() {
  return [asked = 0U, next = Clock::now() + pause]() mutable {
    constexpr unsigned steps_between_looks = 64;  // a look at the clock takes as long as some steps
    if (++asked % steps_between_looks != 0 || Clock::now() < next) return false;
    next = Clock::now() + pause;
    return signal_raised();
  };
}

void beside_interpreter(const std::function<void(const std::function<bool()>& stopped)>& work,
                        const ToldProgress& progress) {
  std::atomic<bool> stop = false;
  {
    const py::gil_scoped_release free;
    std::future<void> end = std::async(std::launch::async, [&] {
      try {
        work([&] { return stop.load(); });
      } catch (const Cancelled&) {
        return;  // what has raised is thrown below
      }
    });
    while (end.wait_for(pause) != std::future_status::ready) {
      if (stop) continue;
      tell(progress);
      stop = signal_raised();
    }
    if (!stop) return end.get();
    end.wait();
  }
  throw py::error_already_set();
}

}  // namespace rockstack::python

// What the package `rockstack` in this folder is written over: no more than Python needs to be told, without
// words.
PYBIND11_MODULE(_core, core) {
  using namespace rockstack;
  core.attr("version") = build::version;
  core.def("programs", &worker_folder);
  core.def("shipped_names", &shipped_names, pybind11::arg("kind"), pybind11::arg("ending") = ".toml");
  core.def("shipped", &shipped);
  core.def("keys", &python::keys);
  python::add_errors(core);
  for (const auto add : {python::add_scene, python::add_motion, python::add_solve, python::add_ground,
                         python::add_sweep, python::add_round, python::add_engines, python::add_player})
    add(core);
}
