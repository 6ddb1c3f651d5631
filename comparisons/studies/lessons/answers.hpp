#pragma once

#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {

/// An engine's answer to a scene, made in passing. `changes` go on top of the named set of parameters.
/// @throws InputError where this build leaves the engine out, std::runtime_error where the run fails.
History answer(const std::string& engine, const std::string& settings, const Scene& scene, double dt,
               const Parameters& changes = {});

/// The exact answer, sampled every `interval` s.
History exact_answer(const Scene& scene, double interval = 1e-3);

/// The row of a suite's run; one where that run is not done has no numbers.
/// @throws std::logic_error where the suite has no such run.
const RunMetrics& find_run(const std::vector<RunMetrics>& rows, const std::string& engine,
                           const std::string& settings, double dt);

/// The first event of a kind, or nullptr.
const Event* first_event(const History& history, EventKind kind);

/// Where sampled motion first passes that size of relative angle at an interface (from 1), s; negative where
/// it never does.
double first_gap(const History& history, int interface, double size);

}  // namespace rockstack
