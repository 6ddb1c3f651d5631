#pragma once

#include <atomic>
#include <functional>

namespace rockstack::python {

/// Asked again and again by work without the interpreter's lock: true once a signal's handler has raised, as
/// Ctrl-C does. Looks at signals twenty times a second.
class Interrupts {
 public:
  Interrupts();
  bool operator()();

 private:
  unsigned asked_ = 0;
  double next_;  ///< s
};

/// What work may throw to end because it is to stop.
struct Unwanted {};

/// Does work in a thread of its own, without the interpreter's lock, and looks at signals meanwhile. Once a
/// handler has raised, `stop` becomes true, and what it has raised is thrown when the work has ended.
/// @throws what the work throws, but Unwanted.
void beside_interpreter(const std::function<void(const std::atomic<bool>& stop)>& work);

}  // namespace rockstack::python
