#pragma once

#include <string>

namespace rockstack {

/// Why an engine with one of its solvers and a parameter set cannot pass a check, or an empty text.
std::string known_limit(const std::string& engine, const std::string& solver, const std::string& settings,
                        const std::string& check);

}  // namespace rockstack
