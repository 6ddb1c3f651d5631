#include "comparisons/runs/identity.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

#include "comparisons/results/journal.hpp"
#include "engines/worker/request.hpp"

namespace rockstack {
namespace {

/// The checksum of a file's bytes, read once.
std::uint64_t file_checksum(const std::filesystem::path& file) {
  static std::map<std::filesystem::path, std::uint64_t> known;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto found = known.find(file);
  if (found != known.end()) return found->second;
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return known[file] = checksum(bytes);
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
  text +=
      fmt::format(" {} {} {} {} {} {:x} ", fmt::join(names_of(job.suite.wanted), " "), job.suite.tolerance,
                  around.runs, around.size, around.seed, file_checksum("/proc/self/exe"));
  return fmt::format("{:016x}", checksum(text + to_bytes(Request{request})));
}

std::optional<RunMetrics> finished_run(const std::filesystem::path& run_folder, const std::string& identity) {
  std::ifstream stream(run_folder / "summary.json");
  const auto summary = nlohmann::ordered_json::parse(stream, nullptr, false);
  if (!summary.is_object() || summary.value("identity", "") != identity) return {};
  const RunMetrics row = metrics_from(summary);
  return row.status == RunStatus::done ? std::optional(row) : std::nullopt;
}

}  // namespace rockstack
