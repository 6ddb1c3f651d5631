#include "analytic/scene/input/json_reader.hpp"

#include <fmt/format.h>

#include <numeric>

#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {
namespace {

/// What replicates are asked for of a job's suite: no sample is kept.
Suite without_histories(const Job& job) {
  Suite lean;
  lean.tolerance = job.suite.tolerance;
  lean.wanted = job.suite.wanted;
  lean.wanted.histories = false;
  lean.softness = job.suite.softness;
  lean.limits = job.suite.limits;
  lean.replicates = replicates_of(job);
  return lean;
}

/// One replicate; `angles` are those at rising times, row by row, up to where its motion ends.
RunMetrics make_replicate(const Job& job, int number, const std::vector<double>& times,
                          std::vector<double>& angles) {
  RunMetrics row;
  try {
    RunFiles files;
    History motion;
    row = engine_metrics(job, number, 0, files, &motion);
    for (std::size_t i = 0; motion.size() > 1 && i < times.size() && times[i] <= motion.times.back(); ++i)
      for (std::size_t k = 0; k < job.scene.scene.blocks.size(); ++k)
        angles.push_back(angle_at(motion, k, times[i]));
  } catch (const std::exception& failure) {
    row = describe(job);
    row.status = RunStatus::failed;
    row.reason = failure.what();
  }
  row.run += fmt::format("#{}", number);
  return row;
}

/// The numbers of each column that is a median over replicates, where there are some.
std::vector<std::pair<const Column&, std::vector<double>>> values_of(
    const RunMetrics& nominal, const std::vector<RunMetrics>& replicates) {
  std::vector<std::pair<const Column&, std::vector<double>>> list;
  for (const Column& column : columns()) {
    if (!column.replicated) continue;
    std::vector<double> values;
    const auto add = [&](const RunMetrics& row) {
      if (row.status != RunStatus::done) return;
      if (const Json cell = column.cell(row); cell.is_number()) values.push_back(cell.get<double>());
    };
    add(nominal);
    std::ranges::for_each(replicates, add);
    if (!values.empty()) list.emplace_back(column, std::move(values));
  }
  return list;
}

constexpr double lower = 0.25, upper = 0.75;

/// band.csv of motions at common times; those that failed have none.
std::string band_csv(const std::vector<double>& times, std::size_t blocks,
                     std::vector<std::vector<double>> motions) {
  std::erase_if(motions, [](const auto& angles) { return angles.empty(); });
  if (motions.empty()) return "";
  CsvWriter csv;
  csv.line("time", numbered_in_turn({"lower_", "upper_"}, static_cast<int>(blocks)));
  const auto shortest = std::ranges::min_element(motions, {}, &std::vector<double>::size);
  for (std::size_t i = 0; i < shortest->size() / blocks; ++i) {
    csv.add(fmt::format("{:.7g}", times[i]));
    for (std::size_t k = 0; k < blocks; ++k) {
      const auto values = mapped(motions, [&](const auto& angles) { return angles[i * blocks + k]; });
      for (const double share : {lower, upper}) csv.add(fmt::format("{:.7g}", quantile(values, share)));
    }
    csv.end_line();
  }
  return csv.text();
}

}  // namespace

bool is_replicated(const Job& job) {
  return job.series != nullptr && replicates_of(job).runs > 1;
}

MadeReplicates make_replicates(const Job& job, std::size_t threads) {
  const Suite suite = without_histories(job);
  const Job lean{suite, job.scene, job.dt, job.series, nullptr, job.horizon};
  std::vector<RunMetrics> rows(static_cast<std::size_t>(suite.replicates.runs) - 1);
  std::vector<std::size_t> parts(rows.size());
  std::iota(parts.begin(), parts.end(), 0);
  std::optional<RunMetrics> end;
  constexpr int instants = 400;
  const double duration = job.scene.scene.duration;
  const std::vector<double> times =
      job.suite.wanted.histories ? regular_times(duration / instants, duration) : std::vector<double>();
  std::vector<std::vector<double>> angles(rows.size());
  const auto compute = [&](std::size_t i) {
    rows[i] = make_replicate(lean, static_cast<int>(i) + 1, times, angles[i]);
    return std::string();
  };
  const auto deliver = [&](std::size_t i, const std::string& /*text*/) {
    const RunStatus status = rows[i].status;
    if (status == RunStatus::time_limit || status == RunStatus::memory_limit) end = rows[i];
  };
  make_threads(threads)->run(parts, {compute, deliver, [&] { return end.has_value(); }});
  for (RunMetrics& row : rows)
    if (row.run.empty()) row = *end;
  return {std::move(rows), band_csv(times, job.scene.scene.blocks.size(), std::move(angles))};
}

std::string pack_replicates(const MadeReplicates& replicates, const std::string& identity) {
  return Json{{"identity", identity}, {"draws", replicates.rows}, {"band", replicates.band}}.dump() + "\n";
}

std::optional<std::vector<RunMetrics>> unpack_replicates(const std::string& text,
                                                         const std::string& identity) {
  try {
    const Json json = parse_json(text, "draws: ");
    if (json.at("identity") != identity) return {};
    return json.at("draws").get<std::vector<RunMetrics>>();
  } catch (const InputError&) {
    return {};
  } catch (const Json::exception&) {
    return {};
  }
}

void write_replicates(const std::string& packed, const RunMetrics& nominal,
                      const std::filesystem::path& folder) {
  Json json = parse_json(packed, "draws: ");
  auto rows = json.at("draws").get<std::vector<RunMetrics>>();
  rows.insert(rows.begin(), nominal);
  write_file(folder / "draws.csv", csv_of(rows));
  if (const std::string band = json.at("band"); !band.empty()) write_file(folder / "band.csv", band);
  json.erase("band");
  write_file(folder / "draws.json", json.dump() + "\n");
}

void summarise(const std::vector<RunMetrics>& replicates, RunMetrics& nominal) {
  const auto count = [&](const auto& counts) {
    return static_cast<int>(std::ranges::count_if(replicates, counts));
  };
  nominal.draws = static_cast<int>(replicates.size()) + 1;
  nominal.draws_failed = count([](const RunMetrics& row) { return row.status != RunStatus::done; });
  nominal.draws_other_verdict = (differ(nominal.toppling_verdict) ? 1 : 0) + count([](const RunMetrics& row) {
                                  return row.status == RunStatus::done && differ(row.toppling_verdict);
                                });
  for (const auto& [column, values] : values_of(nominal, replicates)) {
    column.set(nominal, median(values));
    if (!column.quartiles) continue;
    column_named(column.name + "_lower").set(nominal, quantile(values, lower));
    column_named(column.name + "_upper").set(nominal, quantile(values, upper));
  }
}

int representative(const RunWithReplicates& row) {
  std::vector<std::pair<double, int>> errors;
  const auto add = [&](const RunMetrics& run, int number) {
    if (run.status == RunStatus::done && run.error) errors.emplace_back(*run.error, number);
  };
  add(row.nominal, 0);
  for (std::size_t i = 0; i < row.replicates.size(); ++i) add(row.replicates[i], static_cast<int>(i) + 1);
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>((errors.size() - 1) / 2);
  std::ranges::nth_element(errors, middle);
  return row.nominal.error == middle->first ? 0 : middle->second;
}

RunFiles replicate_files(const Job& job, int number) {
  RunFiles files;
  try {
    engine_metrics(job, number, 0, files);
  } catch (const std::exception&) {
    return {};
  }
  thin_histories(files, job.suite.history_interval);
  return files;
}

std::string spread_csv(const std::vector<RunWithReplicates>& rows) {
  CsvWriter csv;
  csv.line("run", "quantity", "draws", "least", "lower_quartile", "median", "upper_quartile", "greatest");
  for (const auto& [nominal, replicates, shown] : rows) {
    if (replicates.empty()) continue;
    for (const auto& [column, values] : values_of(nominal, replicates))
      csv.line(nominal.run, column.name, values.size(), quantile(values, 0), quantile(values, lower),
               median(values), quantile(values, upper), quantile(values, 1));
  }
  return csv.text();
}

}  // namespace rockstack
