#pragma once

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {

/// What the steps of a batch are computed by: one after the other, or so many side by side.
enum class InstructionSet { scalar, sse2, avx2, avx512 };

std::string name(InstructionSet set);

/// Those that this build has and this machine can, the fastest last.
const std::vector<InstructionSet>& instruction_sets();

/// What came out of one scene of a batch, which is there while it is taken.
struct Solved {
  std::size_t number = 0;  ///< of the scene, in the order they came in, from 0
  const Scene& scene;
  History history;             ///< empty where it failed
  std::exception_ptr failure;  ///< what solve() throws of it, or none
};

/// Solves one scene after the other, several side by side where they have one to three blocks; each history
/// is the one that solve() gives, to the bit. Asks `next` for scenes until it has none, some ahead of those
/// that are done; `deliver` gets what comes out, not in order. What these two throw goes through.
/// @throws std::invalid_argument for a set that is not among instruction_sets().
void solve_batch(const std::function<std::optional<Scene>()>& next, const SolveOptions& options,
                 const std::function<void(Solved&&)>& deliver,
                 InstructionSet set = instruction_sets().back());

}  // namespace rockstack
