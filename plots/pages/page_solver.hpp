#pragma once

#include <string_view>

namespace rockstack::plots {

/// What pages hold that solve, compressed by gzip and in base 64: the solver as WebAssembly, and the script
/// of an engine; empty where this build has none. comparisons/interfaces/web makes both.
extern const std::string_view solver_wasm, engine_package;

}  // namespace rockstack::plots
