#include "comparisons/studies/sweep/sweep.hpp"

#include <new>

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve_batch.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"

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

std::size_t length_of(std::size_t block, std::size_t runs) {
  return std::min(block_size(runs), runs - block * block_size(runs));
}

constexpr auto matrix_meaning =
    "a sample's inputs are those of A, of B, drawn independently, or of A with that key's value from B";

/// All columns of runs.csv and what they mean: the run's number, a column a variation, then what came out.
std::vector<std::pair<std::string, std::string>> run_columns(const Ensemble& ensemble) {
  std::vector<std::pair<std::string, std::string>> columns{{"run", "number of the run, from 0"}};
  for (const Variation& variation : ensemble.variations) {
    std::string meaning = "scene key";
    for (std::size_t k = 1; k < variation.keys.size(); ++k) meaning += ", also of " + variation.keys[k];
    columns.emplace_back(variation.name(), meaning);
  }
  if (!ensemble.summary.indices.empty()) columns.emplace_back(matrix_column, matrix_meaning);
  for (const OutcomeColumn& column : outcome_columns(block_count(ensemble)))
    columns.emplace_back(column.name, column.meaning);
  return columns;
}

/// All that is needed to make the runs again, and what the columns mean.
Json description(const Ensemble& ensemble, const std::filesystem::path& folder,
                 const std::vector<std::string>& headline, const std::vector<InputIndices>& indices) {
  const CutShort cut = cut_short(folder);
  Json json{{"title", ensemble.title},
            {"headline", headline},
            {"tables", {"fragility-fit.csv", "fragility.csv", "indices.csv", "incremental-fractiles.csv"}},
            {"cut_short", cut.runs},
            {"runs", run_count(ensemble)},
            {"tolerance", ensemble.tolerance},
            {"demands", ensemble.demands},
            {"samples", ensemble.samples},
            {"seed", ensemble.seed},
            {"sampling", sampling_names.at(static_cast<std::size_t>(ensemble.sampling))},
            {"scene", page_scene(ensemble.base.root)},
            {"vary", mapped(ensemble.variations, [](const Variation& one) { return json_of(one); })}};
  for (const Axis& axis : ensemble.axes) json["axes"].push_back(axis.variations);
  json["summary"] = {{"intensity", ensemble.summary.intensity},
                     {"period", ensemble.summary.period},
                     {"friction", ensemble.summary.friction},
                     {"indices", ensemble.summary.indices}};
  if (!indices.empty())
    json["indices"] = {{"headline", index_sentences(indices, axis_title(ensemble.summary.intensity))},
                       {"inputs", mapped(indices, [](const InputIndices& one) { return json_of(one); })}};
  for (const auto& [name, meaning] : run_columns(ensemble)) json["columns"][name] = meaning;
  json["environment"] = environment({});
  return json;
}

/// @returns the headline.
std::vector<std::string> write_results(const Ensemble& ensemble, const Journal& journal,
                                       const std::filesystem::path& folder) {
  write_file(folder / "runs.csv", [&](const Sink& put) {
    CsvWriter header;
    for (const auto& [name, meaning] : run_columns(ensemble)) header.add(name);
    header.end_line();
    put(header.text());
    journal.copy_to(put);
  });
  write_summaries(folder, ensemble.summary);
  std::vector<std::string> headline = sweep_headline(folder, ensemble.summary);
  std::vector<InputIndices> indices;
  if (!ensemble.summary.indices.empty()) {
    indices = input_indices(folder, ensemble.summary);
    write_indices(folder, indices);
    for (const std::string& sentence : index_sentences(indices, axis_title(ensemble.summary.intensity)))
      headline.push_back(sentence);
  }
  write_file(folder / "sweep.json", description(ensemble, folder, headline, indices).dump(2) + "\n");
  return headline;
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

std::string block_lines(const Ensemble& ensemble, std::size_t block, MotionLibrary& library) {
  const std::size_t runs = run_count(ensemble), first = block * block_size(runs);
  std::vector<CsvWriter> lines(length_of(block, runs));
  const std::vector<OutcomeColumn> columns = outcome_columns(block_count(ensemble));
  make_runs(ensemble, first, first + lines.size(), library, [&](const RunResult& result) {
    CsvWriter& line = lines[result.run - first];
    line.add(result.run);
    for (const Value& value : result.values) line.add(value.text);
    if (!ensemble.summary.indices.empty()) line.add(matrix_of(ensemble, result.run));
    for (const OutcomeColumn& column : columns) add_cell(line, column, result);
    line.end_line();
  });
  std::string text;
  for (const CsvWriter& line : lines) text += line.text();
  return text;
}

std::size_t block_size(std::size_t runs) {
  constexpr std::size_t smallest = 32;  // enough to be solved side by side
  constexpr std::size_t largest = 256, fewest_blocks = 64;
  return std::clamp(runs / fewest_blocks, smallest, largest);
}

SweepResult sweep(const Ensemble& ensemble, MotionLibrary& library, Executor& executor,
                  const SweepOptions& options) {
  SweepResult result{.runs = run_count(ensemble)};
  std::string known = identity(ensemble, library) + std::to_string(block_size(result.runs));
  for (const auto& [name, meaning] : run_columns(ensemble)) known += "\n" + name;
  Journal journal(options.folder, known);
  std::vector<std::size_t> blocks;
  for (std::size_t block = 0; block * block_size(result.runs) < result.runs; ++block) {
    if (journal.has(block))
      result.done += length_of(block, result.runs);
    else
      blocks.push_back(block);
  }
  const std::size_t begun_with = result.done;
  options.progress(result.done, begun_with, result.runs);
  const auto start = std::chrono::steady_clock::now();
  executor.run(blocks, {[&](std::size_t block) { return block_lines(ensemble, block, library); },
                        [&](std::size_t block, const std::string& lines) {
                          journal.append(block, lines);
                          result.done += length_of(block, result.runs);
                          options.progress(result.done, begun_with, result.runs);
                        },
                        options.stopped});
  result.computed = result.done - begun_with;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!result.finished()) return result;
  result.headline = write_results(ensemble, journal, options.folder);
  for (CsvLine line(options.folder / "runs.csv"); line.next();)
    if (line.text("status") == "failed" && result.failed++ == 0) result.reason = line.text("reason");
  const Json timing{{"command", options.command},
                    {"workers", executor.description()},
                    {"runs_computed", result.computed},
                    {"seconds", result.seconds}};
  if (result.computed > 0) write_file(options.folder / "timing.json", timing.dump(2) + "\n");
  return result;
}

}  // namespace rockstack
