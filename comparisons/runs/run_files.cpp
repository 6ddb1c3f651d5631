#include "comparisons/runs/job.hpp"

#include <fmt/format.h>

#include <charconv>
#include <mutex>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {
namespace {

/// A table whose first column is an ascending time, with some rows left out.
std::string thinned(const std::string& csv, double interval) {
  std::string kept, last;
  double kept_until = -std::numeric_limits<double>::infinity();
  const double least = interval * (1 - 1e-9);  // times are rounded
  for (std::size_t begin = 0; begin < csv.size();) {
    const std::size_t end = csv.find('\n', begin) + 1;
    last = csv.substr(begin, end - begin);
    begin = end;
    double time = 0;
    const bool header = std::from_chars(last.data(), last.data() + last.size(), time).ec != std::errc();
    if (!header && time - kept_until < least) continue;
    if (!header) kept_until = time;
    kept += last;
    last.clear();
  }
  return kept + last;
}

/// Tables of a run whose rows are samples.
constexpr std::array sampled_files{"history.csv", "difference.csv", "energy.csv", "reactions.csv",
                                   "parts.csv"};

/// The checksum of a file's bytes, read once.
std::uint64_t file_checksum(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, std::uint64_t> known;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto found = known.find(file);
  if (found != known.end()) return found->second;
  return known[file] = checksum(bytes_of(file));
}

/// Infinity has no form in JSON.
Json fields_of(const Parameters& parameters) {
  Json fields = Json::object();
  for (const auto& [name, value] : parameters) fields[name] = fmt::format("{}", value);
  return fields;
}

}  // namespace

std::string bytes_of(const std::filesystem::path& file) {
  try {
    return file_text(file, largest_results);
  } catch (const InputError&) {
    return {};
  }
}

void thin_histories(RunFiles& files, double interval) {
  if (interval == 0) return;
  for (const char* name : sampled_files)
    if (const auto file = files.find(name); file != files.end())
      file->second = thinned(file->second, interval);
}

void thin_run(const std::filesystem::path& folder, double interval) {
  for (const std::filesystem::path& own : {folder, folder / shown_name})
    for (const char* name : sampled_files)
      if (std::filesystem::exists(own / name))
        write_file(own / name, thinned(bytes_of(own / name), interval));
}

void write_files(const RunFiles& files, const std::filesystem::path& folder, const std::string& last) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : files)
    if (name != last) write_file(folder / name, text);
  write_file(folder / last, files.at(last));
}

std::string pack(const RunFiles& files) {
  std::string message;
  nlohmann::json::to_msgpack(nlohmann::json(files), message);
  return message;
}

RunFiles unpack(const std::string& message) {
  return parse_bytes<nlohmann::json>(message, nlohmann::json::input_format_t::msgpack, "files of a run: ")
      .get<RunFiles>();
}

std::string identity(const Job& job) {
  Json run{scene_fields(job.scene.scene), job.dt, job.suite.repeats, job.suite.wanted.bodies,
           job.suite.softness};
  std::string text = job.variant != nullptr ? job.variant->name() : "";
  if (const auto& measured = job.scene.measured)
    run.push_back({measured->times, measured->values, measured->columns.size(), measured->first_block,
                   measured->point ? Json(*measured->point) : Json()});
  if (job.series != nullptr) {
    const WorkerEngine& engine = *job.series->engine;
    run.push_back({engine.solver, fields_of(job.series->parameters)});
    if (is_recorded(job))
      run.push_back(mapped(job.series->files->runs, &TrajectoryFile::checksum));
    else
      text = fmt::format("{:x}", file_checksum(engine.program));
  }
  const Perturbations& around = job.suite.perturbations;
  const Replicates& nearby = job.suite.replicates;  // the horizon is theirs
  text += fmt::format(" {} {} {} {} {} {} {} {} {:x} ", fmt::join(names_of(job.suite.wanted), " "),
                      job.suite.tolerance, job.suite.history_interval, around.runs, around.size, around.seed,
                      nearby.scene, nearby.seed, file_checksum(own_file()));
  return fmt::format("{:016x}", checksum(text + run.dump()));
}

std::string replicates_identity(const Job& job) {
  const Replicates replicates = replicates_of(job);
  return fmt::format("{:016x}", checksum(fmt::format("{} {} {} {} {}", identity(job), replicates.runs,
                                                     replicates.steps, replicates.scene, replicates.seed)));
}

std::map<std::string, std::string> checksums(const RunFiles& files) {
  std::map<std::string, std::string> sums;
  for (const auto& [name, text] : files)
    if (name != summary_name) sums[name] = fmt::format("{:016x}", checksum(text));
  return sums;
}

std::optional<RunMetrics> finished_run(const std::filesystem::path& run_folder, const std::string& identity) {
  const auto whole = [&](const Json& summary) -> std::optional<RunMetrics> {
    const auto row = summary.get<RunMetrics>();
    if (row.status != RunStatus::done || summary.at("identity") != identity) return {};
    for (const auto& [name, sum] : summary.at("files").get<std::map<std::string, std::string>>())
      if (fmt::format("{:016x}", checksum(bytes_of(run_folder / name))) != sum) return {};
    return row;
  };
  try {
    return read_json(run_folder / summary_name, whole);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace rockstack
