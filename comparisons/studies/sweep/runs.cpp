#include "comparisons/studies/sweep/sweep.hpp"

#include <cmath>
#include <exception>
#include <map>
#include <new>
#include <optional>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/measures/results/csv.hpp"

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

const std::vector<ColumnMeaning>& outcome_columns() {
  static const std::vector<ColumnMeaning> list{
      {"peak_ratio", "largest angle over slenderness, of the block where that is largest"},
      {"toppled", "number of the block that toppled, or fell off what it was over; 0: none"},
      {"topple_time", "when it passed its toppling angle or fell off, s; the run ends there"},
      {"impacts", "number of impacts; one that ends chatter stands for all that would follow"},
      {"events", "number of events of any kind, impacts among them"},
      {"last_event_time", "time of the last event, s"},
      {"least_normal_force", "least normal force at any interface, N; negative: the stack would lift off"},
      {"force_friction", "largest friction coefficient needed between impacts"},
      {"least_normal_impulse",
       "least normal impulse of any impact, but for chatter of less than a millionth of a fall's momentum, N "
       "s; negative: likewise"},
      {"impulse_friction", "largest friction coefficient needed by impacts"},
      {"onset", "mode in which motion begins: slide, rock, slide-rock or free flight; or rest"},
      {"motion",
       "all of the motion: topple or fall where it ends so; else rest, slide, rock, slide-rock or free flight"},
      {"status", "done or failed"},
      {"reason", "why a run failed"},
      {"slip", "largest slip left at the end at any interface, m; under law unilateral"},
      {"lift", "highest lift of any block off what is below it, m; likewise"}};
  return list;
}

std::size_t block_count(const Ensemble& ensemble) {
  return find(ensemble.base.root, "blocks")->children.size();
}

void add_outcome(CsvWriter& line, const RunOutcome& outcome) {
  const auto cell = [](bool there, double value) { return there ? number_text(value) : ""; };
  for (const double peak : outcome.peaks) line.add(number_text(peak));
  line.add(number_text(outcome.peak_ratio), outcome.toppled, cell(outcome.toppled > 0, outcome.topple_time),
           outcome.impacts, outcome.events, cell(outcome.events > 0, outcome.last_event_time));
  for (const Demand& demand : {outcome.force, outcome.impulse}) {
    const bool there = std::isfinite(demand.least_normal);
    line.add(cell(there, demand.least_normal), cell(there, demand.friction));
  }
  line.add(name(outcome.onset), name(outcome.motion), "done", "");
  for (const auto& length : {outcome.slip, outcome.lift})
    line.add(cell(length.has_value(), length.value_or(0)));
}

void add_failure(CsvWriter& line, std::size_t blocks, const std::string& reason) {
  const std::size_t status_to_lift = 4;
  const std::vector<std::string> no_cells(blocks + outcome_columns().size() - status_to_lift);
  line.add(no_cells, "failed", reason, "", "");
}

}  // namespace

void make_runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
               const std::function<void(const RunResult&)>& take, const std::function<bool()>* unwanted) {
  Runs runs(ensemble, first, last, library, take);
  SolveOptions options = run_options(ensemble.tolerance);
  options.cancelled = unwanted;
  solve_batch([&] { return runs.next_scene(); }, options, [&](const Solved& solved) { runs.take(solved); });
}

std::vector<ColumnMeaning> run_columns(const Ensemble& ensemble) {
  std::vector<ColumnMeaning> columns{{"run", "number of the run, from 0"}};
  for (const Variation& variation : ensemble.variations) {
    std::string meaning = "scene key";
    for (std::size_t k = 1; k < variation.keys.size(); ++k) meaning += ", also of " + variation.keys[k];
    columns.emplace_back(variation.name(), meaning);
  }
  for (std::size_t k = 1; k <= block_count(ensemble); ++k) {
    const std::string number = std::to_string(k);
    columns.emplace_back("peak_" + number, "largest absolute angle of block " + number + ", rad");
  }
  columns.insert(columns.end(), outcome_columns().begin(), outcome_columns().end());
  return columns;
}

std::string run_lines(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library) {
  std::vector<CsvWriter> lines(last - first);
  make_runs(ensemble, first, last, library, [&](const RunResult& result) {
    CsvWriter& line = lines[result.run - first];
    line.add(result.run);
    for (const Value& value : result.values) line.add(value.text);
    if (result.outcome != nullptr) {
      add_outcome(line, *result.outcome);
    } else {
      add_failure(line, block_count(ensemble), result.reason);
    }
    line.end_line();
  });
  std::string text;
  for (const CsvWriter& line : lines) text += line.text();
  return text;
}

}  // namespace rockstack
