#include "engines/engine.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

std::string range_of(const Setting& setting) {
  const std::string kind = setting.whole ? "a whole number" : "a number";
  if (setting.most == std::numeric_limits<double>::infinity())
    return fmt::format("{} from {} up", kind, setting.least);
  return fmt::format("{} from {} to {}", kind, setting.least, setting.most);
}

}  // namespace

Setting switch_setting(std::string name, double default_value, double tuned) {
  return {.name = std::move(name), .default_value = default_value, .tuned = tuned, .most = 1, .whole = true};
}

Setting count_setting(std::string name, double default_value, double tuned) {
  return {.name = std::move(name),
          .default_value = default_value,
          .tuned = tuned,
          .least = 1,
          .most = 1e6,
          .whole = true};
}

Setting shaking_setting() {
  return {.name = "shaking", .choices = {"force", "ground"}};
}

double choice_value(const std::string& engine, const Setting& setting, const std::string& choice) {
  const auto found = std::ranges::find(setting.choices, choice);
  if (found == setting.choices.end())
    throw std::invalid_argument(fmt::format(
        "{}: {} = {}: must be {}", engine, setting.name, choice,
        setting.choices.empty() ? "a number" : fmt::format("{}", fmt::join(setting.choices, " or "))));
  return static_cast<double>(found - setting.choices.begin());
}

double mass_factor(const Setup& setup, const Parameters& parameters) {
  const double wanted = parameters.at("unitMass");
  if (wanted == 0) return 1;
  double mass = 0;
  for (const Placement& block : setup.blocks) mass += block.mass;
  return wanted / mass;
}

Parameters values_of(const std::vector<Setting>& settings, double Setting::*set) {
  Parameters values;
  for (const Setting& setting : settings) values[setting.name] = setting.*set;
  return values;
}

const Setting& find_setting(const std::string& engine, const std::vector<Setting>& settings,
                            const std::string& name) {
  const auto found = std::ranges::find(settings, name, &Setting::name);
  if (found == settings.end()) {
    throw std::invalid_argument(fmt::format("{}: {}: no such parameter; there are {}", engine, name,
                                            fmt::join(mapped(settings, &Setting::name), ", ")));
  }
  return *found;
}

void check_value(const std::string& engine, const std::vector<Setting>& settings, const std::string& name,
                 double value) {
  const Setting& setting = find_setting(engine, settings, name);
  if (!setting.allows(value))
    throw std::invalid_argument(
        fmt::format("{}: {} = {}: must be {}", engine, name, value, range_of(setting)));
}

void check(const std::string& engine, const std::vector<Setting>& settings, const Parameters& given) {
  for (const auto& [name, value] : given) check_value(engine, settings, name, value);
  for (const Setting& setting : settings)
    if (!given.contains(setting.name))
      throw std::invalid_argument(
          fmt::format("{}: {} is missing: must be {}", engine, setting.name, range_of(setting)));
}

}  // namespace rockstack
