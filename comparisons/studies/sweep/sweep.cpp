#include "comparisons/studies/sweep/sweep.hpp"

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/lists.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"

namespace rockstack {
namespace {

std::size_t length_of(std::size_t block, std::size_t runs) {
  return std::min(block_size(runs), runs - block * block_size(runs));
}

/// All that is needed to make the runs again, and what the columns mean.
Json description(const Ensemble& ensemble) {
  Json json{{"title", ensemble.title},
            {"runs", run_count(ensemble)},
            {"samples", ensemble.samples},
            {"seed", ensemble.seed},
            {"scene", page_scene(ensemble.base.root)},
            {"vary", each_of(ensemble.variations, json_of)}};
  for (const Axis& axis : ensemble.axes) json["axes"].push_back(axis.variations);
  json["summary"] = {{"intensity", ensemble.summary.intensity},
                     {"period", ensemble.summary.period},
                     {"friction", ensemble.summary.friction}};
  for (const auto& [name, meaning] : run_columns(ensemble)) json["columns"][name] = meaning;
  json["environment"] = environment({});
  return json;
}

void write_results(const Ensemble& ensemble, const Journal& journal, const std::filesystem::path& folder) {
  write_file(folder / "runs.csv", [&](const Sink& put) {
    CsvWriter header;
    for (const auto& [name, meaning] : run_columns(ensemble)) header.add(name);
    header.end_line();
    put(header.text());
    journal.copy_to(put);
  });
  write_file(folder / "sweep.json", description(ensemble).dump(2) + "\n");
  write_summaries(folder, ensemble.summary);
}

void write_timing(const SweepResult& result, const Executor& executor, const SweepOptions& options) {
  const Json json{{"command", options.command},
                  {"workers", executor.description()},
                  {"runs_computed", result.computed},
                  {"seconds", result.seconds}};
  write_file(options.folder / "timing.json", json.dump(2) + "\n");
}

}  // namespace

std::size_t block_size(std::size_t runs) {
  constexpr std::size_t smallest = 32;  // enough to be solved side by side
  constexpr std::size_t largest = 256, fewest_blocks = 64;
  return std::clamp(runs / fewest_blocks, smallest, largest);
}

SweepResult sweep(const Ensemble& ensemble, MotionLibrary& library, Executor& executor,
                  const SweepOptions& options) {
  SweepResult result{.runs = run_count(ensemble)};
  Journal journal(options.folder, identity(ensemble, library) + std::to_string(block_size(result.runs)));
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
  write_results(ensemble, journal, options.folder);
  for (CsvLine line(options.folder / "runs.csv"); line.next();)
    result.failed += line.text("status") == "failed" ? 1 : 0;
  if (result.computed > 0) write_timing(result, executor, options);
  return result;
}

}  // namespace rockstack
