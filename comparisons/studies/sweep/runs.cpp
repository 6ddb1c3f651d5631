#include "comparisons/studies/sweep/sweep.hpp"

#include <new>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "rockstack_comparisons_texts.hpp"

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

OutcomeColumn::Measure demand(Demand RunOutcome::*of, double Demand::*value) {
  return [of, value](const RunOutcome& outcome) -> std::optional<double> {
    const Demand& demand = outcome.*of;
    if (!std::isfinite(demand.least_normal)) return {};
    return demand.*value;
  };
}

void add_cell(CsvWriter& line, const OutcomeColumn& column, const RunResult& result) {
  const RunOutcome* outcome = result.outcome;
  if (column.name == "status") return line.add(outcome ? "done" : "failed");
  if (column.name == "reason") return line.add(result.reason);
  if (!outcome) return line.add("");
  if (const auto* measure = std::get_if<OutcomeColumn::Measure>(&column.value)) {
    const std::optional<double> value = (*measure)(*outcome);
    line.add(value ? number_text(*value) : "");
  }
  if (const auto* count = std::get_if<OutcomeColumn::Count>(&column.value)) line.add((*count)(*outcome));
  if (const auto* mode = std::get_if<OutcomeColumn::Mode>(&column.value)) line.add(name(outcome->**mode));
}

}  // namespace

void make_runs(const Ensemble& ensemble, std::size_t first, std::size_t last, MotionLibrary& library,
               const std::function<void(const RunResult&)>& take, const std::function<bool()>* unwanted) {
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
  options.cancelled = unwanted;
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

std::vector<OutcomeColumn> outcome_columns(const Ensemble& ensemble) {
  using Measure = OutcomeColumn::Measure;
  using Count = OutcomeColumn::Count;
  const std::map<std::string, OutcomeColumn::Value> values{
      {"peak_ratio", Measure(&RunOutcome::peak_ratio)},
      {"toppled", Count(&RunOutcome::toppled)},
      {"topple_time", Measure(&RunOutcome::topple_time)},
      {"impacts", Count(&RunOutcome::impacts)},
      {"events", Count(&RunOutcome::events)},
      {"last_event_time", Measure(&RunOutcome::last_event_time)},
      {"least_normal_force", demand(&RunOutcome::force, &Demand::least_normal)},
      {"force_friction", demand(&RunOutcome::force, &Demand::friction)},
      {"least_normal_impulse", demand(&RunOutcome::impulse, &Demand::least_normal)},
      {"impulse_friction", demand(&RunOutcome::impulse, &Demand::friction)},
      {"onset", &RunOutcome::onset},
      {"motion", &RunOutcome::motion},
      {"status", {}},
      {"reason", {}},
      {"slip", Measure(&RunOutcome::slip)},
      {"lift", Measure(&RunOutcome::lift)}};
  std::vector<OutcomeColumn> columns;
  const std::size_t blocks = find(ensemble.base.root, "blocks")->children.size();
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::string number = std::to_string(k + 1);
    columns.push_back({"peak_" + number, "largest absolute angle of block " + number + ", rad",
                       Measure([k](const RunOutcome& outcome) { return outcome.peaks[k]; })});
  }
  for (const Paragraph& column : paragraphs(run_columns_txt))
    columns.push_back({column.name, column.words, values.at(column.name)});
  return columns;
}

std::vector<std::pair<std::string, std::string>> run_columns(const Ensemble& ensemble) {
  std::vector<std::pair<std::string, std::string>> columns{{"run", "number of the run, from 0"}};
  for (const Variation& variation : ensemble.variations) {
    std::string meaning = "scene key";
    for (std::size_t k = 1; k < variation.keys.size(); ++k) meaning += ", also of " + variation.keys[k];
    columns.emplace_back(variation.name(), meaning);
  }
  for (const OutcomeColumn& column : outcome_columns(ensemble))
    columns.emplace_back(column.name, column.meaning);
  return columns;
}

std::string block_lines(const Ensemble& ensemble, std::size_t block, MotionLibrary& library) {
  const std::size_t runs = run_count(ensemble), first = block * block_size(runs),
                    last = std::min(runs, first + block_size(runs));
  std::vector<CsvWriter> lines(last - first);
  const std::vector<OutcomeColumn> columns = outcome_columns(ensemble);
  make_runs(ensemble, first, last, library, [&](const RunResult& result) {
    CsvWriter& line = lines[result.run - first];
    line.add(result.run);
    for (const Value& value : result.values) line.add(value.text);
    for (const OutcomeColumn& column : columns) add_cell(line, column, result);
    line.end_line();
  });
  std::string text;
  for (const CsvWriter& line : lines) text += line.text();
  return text;
}

}  // namespace rockstack
