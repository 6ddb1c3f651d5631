#include "comparisons/runs/run_files.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "comparisons/results/files.hpp"

namespace rockstack {

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
  return nlohmann::json::from_msgpack(message).get<RunFiles>();
}

}  // namespace rockstack
