#include "analytic/solve_batch.hpp"

#include <memory>

#include "analytic/batch/lane.hpp"
#include "analytic/solve.hpp"

namespace rockstack {
namespace {

using Deliver = std::function<void(Solved&&)>;

Solved alone(std::size_t number, const Scene& scene, const SolveOptions& options) {
  try {
    return {number, scene, solve(scene, options), nullptr};
  } catch (const std::exception&) {
    return {number, scene, {}, std::current_exception()};
  }
}

/// Scenes of N blocks and one kind of equations that are solved side by side.
template <std::size_t N>
class Lanes {
 public:
  using MakeSteps = void (*)(StepRows<N>&);

  /// Keeps references to `options` and `deliver`.
  Lanes(bool linear, MakeSteps make_steps, const SolveOptions& options, const Deliver& deliver)
      : make_steps_(make_steps), options_(options), deliver_(deliver) {
    rows_.linear = linear;
    rows_.forces = options.validity;
  }

  /// Goes on with the others until there is room.
  void add(std::size_t number, Scene&& scene) {
    while (busy_ == batch_lanes) advance_all();
    std::size_t lane = 0;
    while (runs_[lane]) ++lane;
    Run& run = *(runs_[lane] = std::make_unique<Run>(Run{number, std::move(scene), {}}));
    ++busy_;
    rows_.busy[lane] = 1;
    attempt(lane, [&] {
      validate(run.scene);
      run.lane.emplace(run.scene, options_);
      stop_if_cancelled(options_.cancelled);
      return run.lane->start(rows_, lane);
    });
  }

  void finish() {
    while (busy_ > 0) advance_all();
  }

 private:
  struct Run {
    std::size_t number;
    Scene scene;
    std::optional<Lane<N>> lane;
  };

  void advance_all() {
    make_steps_(rows_);
    for (std::size_t lane = 0; lane < batch_lanes; ++lane) {
      if (!runs_[lane] || (rows_.walked[lane] > 0 && options_.cancelled == nullptr)) continue;
      attempt(lane, [&] {
        stop_if_cancelled(options_.cancelled);
        return runs_[lane]->lane->advance(rows_, lane);
      });
    }
  }

  /// A part of a run that tells whether there is more.
  template <class Part>
  void attempt(std::size_t lane, const Part& part) {
    Run& run = *runs_[lane];
    try {
      if (part()) return;
    } catch (const IllConditioned&) {
      return end(lane, alone(run.number, run.scene, options_));  // in wider numbers
    } catch (const std::runtime_error& failure) {
      const Unfinished unfinished(failure.what(), run.lane->so_far(rows_, lane));
      return end(lane, {run.number, run.scene, {}, std::make_exception_ptr(unfinished)});
    } catch (const std::exception&) {
      return end(lane, {run.number, run.scene, {}, std::current_exception()});
    }
    end(lane, {run.number, run.scene, std::move(*run.lane).history(), nullptr});
  }

  void end(std::size_t lane, Solved&& solved) {
    const std::unique_ptr<Run> run = std::move(runs_[lane]);
    --busy_;
    rows_.busy[lane] = 0;
    deliver_(std::move(solved));
  }

  MakeSteps make_steps_;
  const SolveOptions& options_;
  const Deliver& deliver_;
  std::array<std::unique_ptr<Run>, batch_lanes> runs_;
  std::size_t busy_ = 0;
  StepRows<N> rows_;
};

/// None for one scene after the other.
const StepKernels* kernels(InstructionSet set) {
  const auto& sets = instruction_sets();
  if (std::find(sets.begin(), sets.end(), set) == sets.end())
    throw std::invalid_argument("instruction set " + name(set) + ": not of this machine or build");
#ifdef ROCKSTACK_WITH_INSTRUCTION_SETS
  if (set == InstructionSet::sse2) return &sse2_kernels;
  if (set == InstructionSet::avx2) return &avx2_kernels;
  if (set == InstructionSet::avx512) return &avx512_kernels;
#endif
  return nullptr;
}

}  // namespace

std::string name(InstructionSet set) {
  static constexpr std::array names{"scalar", "SSE2", "AVX2", "AVX-512"};
  return names[static_cast<std::size_t>(set)];
}

const std::vector<InstructionSet>& instruction_sets() {
  static const std::vector<InstructionSet> sets = [] {
    std::vector<InstructionSet> result{InstructionSet::scalar};
#ifdef ROCKSTACK_WITH_INSTRUCTION_SETS
    if (__builtin_cpu_supports("sse2")) result.push_back(InstructionSet::sse2);
    if (__builtin_cpu_supports("avx2")) result.push_back(InstructionSet::avx2);
    if (__builtin_cpu_supports("avx512f")) result.push_back(InstructionSet::avx512);
#endif
    return result;
  }();
  return sets;
}

void solve_batch(const std::function<std::optional<Scene>()>& next, const SolveOptions& options,
                 const Deliver& deliver, InstructionSet set) {
  const StepKernels* made_by = kernels(set);
  // A batch keeps no samples.
  if (options.integrator != Integrator::taylor || !options.sample_times.empty()) made_by = nullptr;
  std::size_t number = 0;
  if (made_by == nullptr) {
    while (std::optional<Scene> scene = next()) deliver(alone(number++, *scene, options));
    return;
  }
  Lanes<1> one[]{{false, made_by->one_block, options, deliver}, {true, made_by->one_block, options, deliver}};
  Lanes<2> two[]{{false, made_by->two_blocks, options, deliver},
                 {true, made_by->two_blocks, options, deliver}};
  Lanes<3> three[]{{false, made_by->three_blocks, options, deliver},
                   {true, made_by->three_blocks, options, deliver}};
  for (; std::optional<Scene> scene = next(); ++number) {
    const std::size_t kind = scene->equations == Equations::linear ? 1 : 0;
    // Kernels know pivots alone, no levers, no walls, and the ground's acceleration.
    const bool by_itself = scene->equations == Equations::small_angle || leaves_pivots(scene->law) ||
                           scene->wall.side != 0 || has_applied_forces(*scene);
    const std::size_t blocks = by_itself ? 0 : scene->blocks.size();
    if (blocks == 1)
      one[kind].add(number, std::move(*scene));
    else if (blocks == 2)
      two[kind].add(number, std::move(*scene));
    else if (blocks == 3)
      three[kind].add(number, std::move(*scene));
    else
      deliver(alone(number, *scene, options));
  }
  for (Lanes<1>& lanes : one) lanes.finish();
  for (Lanes<2>& lanes : two) lanes.finish();
  for (Lanes<3>& lanes : three) lanes.finish();
}

}  // namespace rockstack
