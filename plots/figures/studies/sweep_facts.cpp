#include "plots/figures/studies/sweep_facts.hpp"

#include "comparisons/measures/results/sentences.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

/// What makes a block's motion dimensionless: it uplifts at a = g tan α and turns with p = √(3g/4R) (Housner
/// 1963, for a rectangle).
void add_scales(SweepFacts& facts, const Json& scene) {
  const Json blocks = scene.value("blocks", Json::array());
  if (blocks.size() != 1 || !blocks[0].contains("width") || !blocks[0].contains("height")) return;
  const double width = blocks[0].at("width").get<double>(), height = blocks[0].at("height").get<double>();
  const double gravity = scene.value("gravity", Scene().gravity);
  facts.least_acceleration = gravity * width / height;
  facts.frequency_parameter = std::sqrt(3 * gravity / (4 * std::hypot(width, height) / 2));
}

/// The values of a varied key; none where it is not varied over numbers.
std::vector<double> values_of(const Json& sweep, const std::string& key) {
  for (const Json& variation : sweep.at("vary")) {
    const auto keys = variation.at("keys").get<std::vector<std::string>>();
    if (std::ranges::find(keys, key) != keys.end() && variation.contains("values"))
      return variation.at("values").get<std::vector<double>>();
  }
  return {};
}

/// The block whose onset of motion has boundaries in closed form: uniform, at rest, under rectangular pulses
/// that begin together and grow together.
std::optional<StruckBlock> struck_block(const Json& sweep) {
  const Json scene = sweep.value("scene", Json::object());
  const Json ground = scene.value("ground", Json::object());
  const Json horizontal = ground.value("horizontal", Json::object());
  const bool rectangular = horizontal.value("pulse", "") == "rectangle";
  if (!rectangular || scene.contains("initial") || scene.at("blocks").size() != 1) return std::nullopt;
  const Json& block = scene.at("blocks")[0];
  if (block.contains("inertia")) return std::nullopt;
  StruckBlock struck{block.at("height").get<double>() / block.at("width").get<double>(),
                     scene.value("gravity", Scene().gravity), 0};
  if (!ground.contains("vertical")) return struck;
  const Json& vertical = ground.at("vertical");
  const std::vector<double> across = values_of(sweep, "ground.horizontal.amplitude");
  const std::vector<double> up = values_of(sweep, "ground.vertical.amplitude");
  const bool together = vertical.value("pulse", "") == "rectangle" && across.size() == up.size() &&
                        vertical.value("start", 0.0) == horizontal.value("start", 0.0);
  if (!together) return std::nullopt;
  struck.vertical = up.back() / across.back();
  const auto in_step = [&](double a, double v) {
    return std::abs(v - struck.vertical * a) <= 1e-9 * std::abs(a);
  };
  if (!std::ranges::equal(across, up, in_step)) return std::nullopt;
  return struck;
}

/// From one acceleration to another, up to the largest friction.
template <class Friction>
std::string line(double from, double to, double largest_friction, const Friction& friction) {
  constexpr int pieces = 200;
  std::string text;
  for (int i = 0; i <= pieces; ++i) {
    const double acceleration = from + (to - from) * i / pieces;
    const double value = friction(acceleration);
    if (value <= largest_friction) text += fmt::format("{} {}\n", plain(acceleration), plain(value));
  }
  return text + "\n";
}

std::string upright(double acceleration, double from, double to) {
  return fmt::format("{0} {1}\n{0} {2}\n\n", plain(acceleration), plain(from), plain(to));
}

}  // namespace

std::string initiation_boundaries(const StruckBlock& block, double largest_acceleration,
                                  double largest_friction) {
  const double r = block.slenderness_ratio;
  const auto push = [&](double acceleration) {
    return acceleration / (block.gravity + block.vertical * acceleration);
  };
  const double flight = block.vertical < 0 ? -block.gravity / block.vertical : largest_acceleration;
  const double end = std::min(flight, largest_acceleration);
  const double tilts = block.gravity / (r - block.vertical);  // push = 1/r
  std::string text = line(0, std::min(tilts, end), largest_friction, push);
  if (tilts < end) {
    text += upright(tilts, 1 / r, largest_friction);
    text += line(tilts, end, largest_friction, [&](double) { return 1 / r; });
    // The push grows without bound towards flight.
    text += line(tilts, end - 1e-6 * (end - tilts), largest_friction,
                 [&](double acceleration) { return rocking_friction(r, push(acceleration)); });
  }
  if (flight < largest_acceleration) text += upright(flight, 0, largest_friction);
  return text;
}

SweepFacts sweep_facts(const fs::path& results) {
  return read_json(results / "sweep.json", [](const Json& json) {
    const Json& summary = json.at("summary");
    const std::string intensity = summary.at("intensity").get<std::string>();
    SweepFacts facts{json.at("title"), axis_title(intensity), 0, 0, {}};
    if (intensity.ends_with(".peak") || intensity.ends_with(".amplitude"))
      add_scales(facts, json.value("scene", Json::object()));
    facts.cut_short = json.value("cut_short", std::size_t{0});
    const Json sentences = json.value("indices", Json::object()).value("headline", Json::array());
    if (!sentences.empty()) facts.decisive = sentences[0].get<std::string>();
    facts.decisive.resize(std::min(facts.decisive.find(':'), facts.decisive.size()));
    if (intensity == "ground.horizontal.amplitude" && summary.value("friction", "") == "contact.friction")
      facts.struck = struck_block(json);
    return facts;
  });
}

std::string dimensionless_axis(const std::string& axis, double low, double high, double unit,
                               const std::string& words) {
  if (!(unit > 0)) return "";
  return fmt::format("set {0}2range [{1}:{2}]\nset {0}tics nomirror\nset {0}2tics\nset {0}2label '{3}'\n",
                     axis, plain(low / unit), plain(high / unit), words);
}

}  // namespace rockstack::plots
