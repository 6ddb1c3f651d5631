#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analytic/scene/input/document.hpp"
#include "engines/worker/registry.hpp"

namespace rockstack {

/// One engine with one set of parameters, at several time steps.
struct EngineSeries {
  const WorkerEngine* engine = nullptr;
  std::string settings;  ///< "default" or "tuned", and what is changed of it: "tuned+erp=0.2"
  Parameters parameters;
  std::vector<double> steps;  ///< s
};

/// An engine with its "default" or "tuned" parameters, some of them changed.
/// @throws std::invalid_argument for a changed parameter that the engine does not have or take.
EngineSeries make_series(const WorkerEngine& engine, const std::string& settings, std::vector<double> steps,
                         const Parameters& changes = {});

/// Changed parameters as a command line has them, "erp=0.05" or "shaking=ground".
/// @throws InputError for a text that is not of that form, an unknown parameter, with those that there are,
/// or a value out of range.
Parameters read_parameters(const std::vector<std::string>& texts, const WorkerEngine& engine);

/// The time steps of a series that names none, s.
std::vector<double> default_steps();

/// The tables [[engines]] of a suite or study; paths of workers start from `folder`. @throws InputError with
/// file:line, key, value and what is allowed.
std::vector<EngineSeries> read_engines(const Node& root, const std::filesystem::path& folder);

}  // namespace rockstack
