#pragma once

#include <map>
#include <string>
#include <vector>

#include "engines/engine.hpp"
#include "engines/worker/worker_engine.hpp"

namespace rockstack {

/// One of many runs that ask the same question: the scene differs in the sixth digit, the step (s) by up to
/// 3 %.
struct Draw {
  Scene scene;
  double dt = 0;
};

/// Replicates, the same on every call.
std::vector<Draw> replicates(const Scene& scene, double dt, int runs = 21);

struct Quartiles {
  double lower = 0, median = 0, upper = 0;
};

/// Precondition: not empty.
Quartiles quartiles(const std::vector<double>& values);

/// The engine linked into this program as "ode:step", or nullptr where it was switched off.
const Engine* linked(const std::string& name);

/// Parameters with some of them changed. @throws std::out_of_range for one that is not there.
Parameters with(Parameters parameters, const Parameters& changes);

/// The library's own settings but for those that suit rocking: overlaps are pushed out gently or beside the
/// velocities, and iterations are enough. Written out here, so that tuning moves no finding.
Parameters gentle(const WorkerEngine& engine);
Parameters gentle(const Engine& engine);

/// Largest difference of any angle from the exact motion under law "consistent", rad; a run that fails or
/// ends early, as a block topples, is off by π.
double error(const Engine& engine, const Draw& draw, const Parameters& parameters);

/// Error against angles at every step, the start first.
double error_of(const Draw& draw, const std::vector<double>& angles);

/// error() of every draw.
std::vector<double> errors(const Engine& engine, const std::vector<Draw>& draws,
                           const Parameters& parameters);

/// A block of slenderness 0.197, released at half of that.
Scene slender_block(double duration);

/// Masses and moments of inertia of a block, multiplied.
void scale_mass(Block& block, double factor);

}  // namespace rockstack
