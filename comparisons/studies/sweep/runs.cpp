#include "comparisons/studies/sweep/runs.hpp"

#include <map>
#include <new>
#include <optional>
#include <utility>

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

/// Consecutive runs, whose scenes it makes one after the other.
class Runs {
 public:
  using Take = std::function<void(const RunResult&)>;

  Runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
       const Take& take)
      : ensemble_(ensemble),
        next_(first),
        last_(last),
        library_(library),
        take_(take),
        document_(ensemble.base) {}

  /// The scene of the next run that has one; of a run that has none it tells why.
  std::optional<Scene> next_scene() {
    while (next_ < last_) {
      Run run{next_++, {}};
      run.values = values_of(ensemble_, run.number);
      std::optional<Scene> scene;
      const std::string reason = failure_of([&] { scene = scene_of(run.values); });
      if (scene) {
        under_way_.emplace(begun_++, std::move(run));
        return scene;
      }
      take_({run.number, run.values, nullptr, reason});
    }
    return std::nullopt;
  }

  void take(const Solved& solved) {
    const Run run = std::move(under_way_.extract(solved.number).mapped());
    std::optional<RunOutcome> outcome;
    const std::string reason = failure_of([&] {
      if (solved.failure) std::rethrow_exception(solved.failure);
      outcome = run_outcome(solved.scene, solved.history);
    });
    take_({run.number, run.values, outcome ? &*outcome : nullptr, reason});
  }

 private:
  struct Run {
    std::size_t number;
    std::vector<Value> values;
  };

  Scene scene_of(const std::vector<Value>& values) {
    for (std::size_t v = 0; v < values.size(); ++v) set_values(document_, ensemble_.variations[v], values[v]);
    return make_scene(document_, library_);
  }

  const Ensemble& ensemble_;
  std::size_t next_, last_;
  MotionLibrary& library_;
  const Take& take_;
  SceneDocument document_;
  std::size_t begun_ = 0;
  std::map<std::size_t, Run> under_way_;  ///< by the number of the scene
};

}  // namespace

void make_runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
               const std::function<void(const RunResult&)>& take, const std::function<bool()>* unwanted) {
  Runs runs(ensemble, first, last, library, take);
  SolveOptions options = run_options(ensemble.tolerance);
  options.cancelled = unwanted;
  solve_batch([&] { return runs.next_scene(); }, options, [&](const Solved& solved) { runs.take(solved); });
}

}  // namespace rockstack
