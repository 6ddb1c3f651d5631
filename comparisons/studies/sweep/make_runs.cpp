#include "comparisons/studies/sweep/make_runs.hpp"

#include <new>

#include "analytic/solve_batch.hpp"

namespace rockstack {
namespace {

/// What `part` throws, as a text; empty where it throws nothing.
template <class Part>
std::string failure_of(const Part& part) {
  try {
    part();
    return {};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

void make_runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
               const std::function<void(const RunResult&)>& take, const std::function<bool()>* cancelled) {
  struct Run {
    std::size_t number;
    std::vector<Value> values;
  };
  std::map<std::size_t, Run> under_way;  // by the number of the scene
  SceneDocument document = ensemble.base;
  std::size_t next = first, begun = 0;
  // The scene of the next run that has one; of a run that has none it tells why.
  const auto next_scene = [&]() -> std::optional<Scene> {
    while (next < last) {
      Run run{next, values_of(ensemble, next)};
      ++next;
      std::optional<Scene> scene;
      const std::string reason = failure_of([&] {
        for (std::size_t v = 0; v < run.values.size(); ++v)
          set_values(document, ensemble.variations[v], run.values[v]);
        scene = make_scene(document, library);
      });
      if (scene) {
        under_way.emplace(begun++, std::move(run));
        return scene;
      }
      take({run.number, run.values, nullptr, reason});
    }
    return std::nullopt;
  };
  SolveOptions options = run_options(ensemble.tolerance);
  options.cancelled = cancelled;
  options.validity = ensemble.demands;
  solve_batch(next_scene, options, [&](const Solved& solved) {
    const Run run = std::move(under_way.extract(solved.number).mapped());
    std::optional<RunOutcome> outcome;
    const std::string reason = failure_of([&] {
      if (solved.failure) std::rethrow_exception(solved.failure);
      outcome = run_outcome(solved.scene, solved.history);
    });
    take({run.number, run.values, outcome ? &*outcome : nullptr, reason});
  });
}

}  // namespace rockstack
