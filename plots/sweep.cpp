#include "plots/sweep.hpp"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "analytic/scene/input_error.hpp"
#include "plots/sweep_drawings.hpp"

namespace rockstack {
namespace {

using Json = nlohmann::json;

plots::SweepFacts read_facts(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": cannot be read");
  try {
    const Json json = Json::parse(stream);
    const Json& summary = json.at("summary");
    return {json.at("title"), plots::axis_title(summary.at("intensity").get<std::string>())};
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

bool has_sweep(const std::filesystem::path& results) {
  return std::filesystem::exists(results / "sweep.json");
}

void draw_sweep(const std::filesystem::path& results) {
  const plots::SweepFacts facts = read_facts(results / "sweep.json");
  const auto figures = results / "figures";
  const auto there = [&](const char* name) { return std::filesystem::exists(results / name); };
  std::filesystem::create_directories(figures);
  if (there("fragility.csv")) plots::draw(plots::fragility(results, facts), figures / "fragility");
  if (there("incremental.csv")) plots::draw(plots::incremental(results, facts), figures / "incremental");
  if (there("overturning.csv")) plots::draw(plots::overturning(results, facts), figures / "overturning");
}

}  // namespace rockstack
