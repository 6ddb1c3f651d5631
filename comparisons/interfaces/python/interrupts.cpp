#include "comparisons/interfaces/python/interrupts.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <thread>

namespace rockstack::python {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds pause{50};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool signal_raised() {
  const py::gil_scoped_acquire lock;
  return PyErr_Occurred() != nullptr || PyErr_CheckSignals() != 0;
}

}  // namespace

Interrupts::Interrupts() : next_(now() + std::chrono::duration<double>(pause).count()) {}

bool Interrupts::operator()() {
  constexpr unsigned steps_between_looks = 64;  // a look at the clock takes as long as some steps
  if (++asked_ % steps_between_looks != 0 || now() < next_) return false;
  next_ = now() + std::chrono::duration<double>(pause).count();
  return signal_raised();
}

void beside_interpreter(const std::function<void(const std::atomic<bool>& stop)>& work) {
  std::atomic<bool> stop = false;
  {
    const py::gil_scoped_release free;
    std::future<void> end = std::async(std::launch::async, [&] {
      try {
        work(stop);
      } catch (const Unwanted&) {
        return;  // what has raised is thrown below
      }
    });
    while (end.wait_for(pause) != std::future_status::ready)
      if (!stop) stop = signal_raised();
    if (!stop) return end.get();
    end.wait();
  }
  throw py::error_already_set();
}

}  // namespace rockstack::python
