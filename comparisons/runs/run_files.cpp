#include "comparisons/runs/run_files.hpp"

#include <charconv>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "analytic/scene/input/json_reader.hpp"
#include "comparisons/measures/results/files.hpp"

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

}  // namespace

void thin_histories(RunFiles& files, double interval) {
  if (interval == 0) return;
  for (const char* name : {"history.csv", "difference.csv", "energy.csv", "reactions.csv", "parts.csv"}) {
    if (const auto file = files.find(name); file != files.end())
      file->second = thinned(file->second, interval);
  }
}

void write_files(const RunFiles& files, const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  for (const auto& [name, text] : files) {
    if (name != summary_name) write_file(folder / name, text);
  }
  write_file(folder / summary_name, files.at(summary_name));
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

}  // namespace rockstack
