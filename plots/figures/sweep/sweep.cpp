#include "plots/figures/sweep/sweep.hpp"

#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/figures/sweep/drawings.hpp"

namespace rockstack::plots {
namespace {

using Json = nlohmann::json;

/// What makes a block's motion dimensionless: it uplifts at a = g tan α and turns with p = √(3g/4R) (Housner
/// 1963, for a rectangle).
void add_scales(SweepFacts& facts, const Json& scene) {
  constexpr double standard_gravity = 9.81;  // of scenes that do not say, m/s²
  const Json blocks = scene.value("blocks", Json::array());
  if (blocks.size() != 1 || !blocks[0].contains("width") || !blocks[0].contains("height")) return;
  const double width = blocks[0].at("width").get<double>(), height = blocks[0].at("height").get<double>();
  const double gravity = scene.value("gravity", standard_gravity);
  facts.least_acceleration = gravity * width / height;
  facts.frequency_parameter = std::sqrt(3 * gravity / (4 * std::hypot(width, height) / 2));
}

SweepFacts read_facts(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": cannot be read");
  try {
    const Json json = Json::parse(stream);
    const Json& summary = json.at("summary");
    const std::string intensity = summary.at("intensity").get<std::string>();
    SweepFacts facts{json.at("title"), axis_title(intensity), 0, 0};
    if (intensity.ends_with(".peak") || intensity.ends_with(".amplitude"))
      add_scales(facts, json.value("scene", Json::object()));
    return facts;
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
