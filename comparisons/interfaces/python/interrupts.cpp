#include <chrono>
#include <future>
#include <thread>

#include "comparisons/interfaces/python/module.hpp"

namespace rockstack::python {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds pause{50};

bool signal_raised() {
  const py::gil_scoped_acquire lock;
  return PyErr_Occurred() != nullptr || PyErr_CheckSignals() != 0;
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

void beside_interpreter(const std::function<void(const std::atomic<bool>& stop)>& work) {
  std::atomic<bool> stop = false;
  {
    const py::gil_scoped_release free;
    std::future<void> end = std::async(std::launch::async, [&] {
      try {
        work(stop);
      } catch (const Cancelled&) {
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
