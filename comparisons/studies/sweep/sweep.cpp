#include "comparisons/studies/sweep/sweep.hpp"

#include "analytic/scene/input/page_scene.hpp"
#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"

namespace rockstack {
namespace {

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
  for (const RunColumn& column : run_columns(ensemble)) json["columns"][column.name] = column.meaning;
  json["environment"] = environment({});
  return json;
}

/// @returns the headline.
std::vector<std::string> write_results(const Ensemble& ensemble, const std::filesystem::path& folder) {
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

/// What a journal is known by.
std::string identity_of_runs(const Ensemble& ensemble, RunsFormat format, MotionLibrary& library) {
  std::string known = identity(ensemble, library) + std::to_string(block_size(run_count(ensemble)));
  for (const RunColumn& column : run_columns(ensemble)) known += "\n" + column.name;
  return format == RunsFormat::npz ? known + "\nas columns" : known;
}

/// Whether a folder's runs.npz has all runs.
bool holds_columns(const std::filesystem::path& folder, RunsFormat format, const std::string& known) {
  const std::filesystem::path file = folder / "runs.npz";
  if (!std::filesystem::exists(file)) return false;
  if (format != RunsFormat::npz || npz_comment(file) != job_line(known)) throw other_job(folder);
  return true;
}

/// Makes the blocks that a journal does not have.
void make_blocks(const Ensemble& ensemble, Journal& journal, RunsFormat format, MotionLibrary& library,
                 Executor& executor, const SweepOptions& options, SweepResult& result) {
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
  executor.run(blocks, {[&](std::size_t block) { return journal_part(ensemble, block, library, format); },
                        [&](std::size_t block, const std::string& text) {
                          journal.append(block, text);
                          result.done += length_of(block, result.runs);
                          options.progress(result.done, begun_with, result.runs);
                        },
                        options.stopped});
  result.computed = result.done - begun_with;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void count_failed(const std::filesystem::path& folder, SweepResult& result) {
  for (TableRows row(folder / "runs.csv", {"status"}); row.next();) result.failed += row.text(0) == "failed";
  if (result.failed == 0) return;
  TableRows row(failures_file(folder), {reason_column});
  while (result.reason.empty() && row.next()) result.reason = row.text(0);
}

}  // namespace

SweepResult sweep(const Ensemble& ensemble, MotionLibrary& library, Executor& executor,
                  const SweepOptions& options) {
  SweepResult result{.runs = run_count(ensemble)};
  const RunsFormat format = options.format.value_or(usual_format(result.runs));
  const std::string known = identity_of_runs(ensemble, format, library);
  if (holds_columns(options.folder, format, known)) {
    result.done = result.runs;
    options.progress(result.done, result.done, result.runs);
  } else {
    Journal journal(options.folder, known);
    make_blocks(ensemble, journal, format, library, executor, options, result);
    if (!result.finished()) return result;
    write_runs(ensemble, journal, options.folder, format, job_line(known));
  }
  if (format == RunsFormat::npz)
    std::filesystem::remove(options.folder / "runs.journal");  // all of it is there
  result.headline = write_results(ensemble, options.folder);
  count_failed(options.folder, result);
  const Json timing{{"command", options.command},
                    {"workers", executor.description()},
                    {"runs_computed", result.computed},
                    {"seconds", result.seconds}};
  if (result.computed > 0) write_file(options.folder / "timing.json", timing.dump(2) + "\n");
  return result;
}

}  // namespace rockstack
