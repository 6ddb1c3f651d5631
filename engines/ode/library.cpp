#include "engines/ode/library.hpp"

#include <fmt/format.h>
#include <ode/ode.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace rockstack {
namespace {

thread_local std::size_t messages = 0;

std::string text_of(const char* format, std::va_list arguments) {
  std::array<char, 512> buffer{};
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  return buffer.data();
}

/// ODE ends the process when this returns, so it must throw.
void stop(int number, const char* format, std::va_list arguments) {
  throw std::runtime_error(fmt::format("ode: error {}: {}", number, text_of(format, arguments)));
}

/// ODE goes on with what its solver has so far.
void note(int, const char*, std::va_list) {
  ++messages;
}

}  // namespace

void initialise_ode() {
  static const bool ready = [] {
    dSetErrorHandler(stop);
    dSetDebugHandler(stop);
    dSetMessageHandler(note);
    return dInitODE2(0) != 0;
  }();
  if (!ready || dAllocateODEDataForThread(dAllocateMaskAll) == 0) {
    throw std::runtime_error("ode: the library could not be initialised");
  }
}

std::size_t ode_messages() {
  return messages;
}

}  // namespace rockstack
