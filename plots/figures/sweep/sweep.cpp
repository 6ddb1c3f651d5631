#include "plots/figures/sweep/sweep.hpp"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/figures/sweep/drawings.hpp"

namespace rockstack::plots {
namespace {

using Json = nlohmann::json;

SweepFacts read_facts(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": cannot be read");
  try {
    const Json json = Json::parse(stream);
    const Json& summary = json.at("summary");
    return {json.at("title"), axis_title(summary.at("intensity").get<std::string>())};
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

bool has_sweep(const std::filesystem::path& results) {
  return std::filesystem::exists(results / "sweep.json");
}

void draw_sweep(const std::filesystem::path& results) {
  const SweepFacts facts = read_facts(results / "sweep.json");
  const auto figures = results / "figures";
  const auto there = [&](const char* name) { return std::filesystem::exists(results / name); };
  std::filesystem::create_directories(figures);
  if (there("fragility.csv")) draw(fragility(results, facts), figures / "fragility");
  if (there("incremental.csv")) draw(incremental(results, facts), figures / "incremental");
  if (there("overturning.csv")) draw(overturning(results, facts), figures / "overturning");
}

}  // namespace rockstack::plots
