#include "comparisons/runs/identity.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "comparisons/results/files.hpp"
#include "engines/worker/request.hpp"

namespace rockstack {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The checksum of a file's bytes, read once.
std::uint64_t file_checksum(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, std::uint64_t> known;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto found = known.find(file);
  if (found != known.end()) return found->second;
  return known[file] = checksum(bytes_of(file));
}

}  // namespace

std::string identity(const Job& job) {
  RunRequest request{"", job.scene.scene, job.dt, {}, job.suite.repeats, job.suite.wanted.bodies};
  std::string text = job.variant != nullptr ? job.variant->name() : "";
  if (job.series != nullptr) {
    request.solver = job.series->engine->solver();
    request.parameters = job.series->parameters;
    text = fmt::format("{:x}", file_checksum(job.series->engine->program()));
  }
  const Perturbations& around = job.suite.perturbations;
  text += fmt::format(" {} {} {} {} {} {} {:x} ", fmt::join(names_of(job.suite.wanted), " "),
                      job.suite.tolerance, job.suite.history_interval, around.runs, around.size, around.seed,
                      file_checksum("/proc/self/exe"));
  return fmt::format("{:016x}", checksum(text + to_bytes(Request{request})));
}

std::string draws_identity(const Job& job) {
  const Draws& draws = job.suite.draws;
  return fmt::format("{:016x}", checksum(fmt::format("{} {} {} {} {}", identity(job), draws.runs, draws.steps,
                                                     draws.scene, draws.seed)));
}

Checksums checksums(const RunFiles& files) {
  Checksums sums;
  for (const auto& [name, text] : files) {
    if (name != summary_name) sums[name] = fmt::format("{:016x}", checksum(text));
  }
  return sums;
}

std::optional<RunMetrics> finished_run(const std::filesystem::path& run_folder, const std::string& identity) {
  std::ifstream stream(run_folder / summary_name);
  try {
    const auto summary = nlohmann::ordered_json::parse(stream);
    const RunMetrics row = metrics_from(summary);
    if (row.status != RunStatus::done || summary.at("identity") != identity) return {};
    for (const auto& [name, sum] : summary.at("files").get<Checksums>()) {
      if (fmt::format("{:016x}", checksum(bytes_of(run_folder / name))) != sum) return {};
    }
    return row;
  } catch (const nlohmann::json::exception&) {
    return {};
  }
}

}  // namespace rockstack
