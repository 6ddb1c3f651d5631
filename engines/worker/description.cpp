#include "engines/worker/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>

#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {
namespace {

constexpr std::size_t longest_name = 60;

bool is_word(std::string_view text, std::string_view others) {
  return !text.empty() && text.size() <= longest_name &&
         std::all_of(text.begin(), text.end(), [&](char letter) {
           const bool usual = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
           return usual || others.find(letter) != std::string_view::npos;
         });
}

bool is_line(const std::string& text) {
  return text.size() <= 200 && one_line(text) == text;
}

/// Names of the exact answer and of its variants, as rows of a comparison have them.
constexpr std::array<std::string_view, 8> taken{"exact",      "linear",     "nonlinear", "paper",
                                                "consistent", "unilateral", "compliant", "rk4"};

void require(bool holds, const char* key, const std::string& value, const std::string& allowed) {
  if (!holds) throw std::runtime_error(fmt::format("{} = {}: must be {}", key, value, allowed));
}

/// Of the settings by which this program itself goes.
void check_shaking(const Setting& setting) {
  const Setting must = shaking_setting();
  require(setting.name != must.name || (setting.whole && setting.choices == must.choices), "setting name",
          setting.name,
          fmt::format("of another one, or of the choices {}", fmt::join(must.choices, " and ")));
}

void check_setting(const Setting& setting) {
  check_shaking(setting);
  require(is_word(setting.name, "_-.ABCDEFGHIJKLMNOPQRSTUVWXYZ"), "setting name", setting.name,
          "letters, digits, '_', '-' and '.', at most 60");
  require(is_line(setting.unit), "unit", setting.name, "one line");
  require(setting.least <= setting.most, "least", setting.name, "at most `most`");
  for (const double value : {setting.standard, setting.tuned}) {
    const bool inside = value >= setting.least && value <= setting.most;
    require(inside && (!setting.whole || value == std::floor(value)), setting.name.c_str(),
            fmt::format("{}", value), "within its own range");
  }
  const auto count = static_cast<double>(setting.choices.size());
  require(setting.choices.empty() || (setting.whole && setting.least == 0 && setting.most == count - 1),
          "choices", setting.name, "the names of all whole numbers from least = 0 to most");
  for (const std::string& choice : setting.choices)
    require(is_word(choice, "_-.ABCDEFGHIJKLMNOPQRSTUVWXYZ"), "choice", choice, "a word");
}

}  // namespace

void check_descriptions(const std::vector<EngineDescription>& engines) {
  require(!engines.empty(), "engines", "[]", "a list of at least one");
  std::set<std::string> names;
  for (const EngineDescription& engine : engines) {
    require(is_word(engine.name, "-"), "name", engine.name, "small letters, digits and '-', at most 60");
    require(std::find(taken.begin(), taken.end(), engine.name) == taken.end(), "name", engine.name,
            fmt::format("another one than {}, which are not engines'", fmt::join(taken, ", ")));
    require(is_word(engine.solver, "-"), "solver", engine.solver,
            "small letters, digits and '-', at most 60");
    require(names.insert(engine.name + ":" + engine.solver).second, "solver", engine.solver,
            "another one for each of an engine's");
    require(is_line(engine.version), "version", engine.name, "one line");
    require(is_line(engine.licence), "licence", engine.name, "one line");
    const Capabilities& able = engine.capabilities;
    require(able.largest_friction >= 0, "largest_friction", fmt::format("{}", able.largest_friction),
            "a number ≥ 0");
    for (const double lead : {able.lead, able.tuned_lead})
      require(std::abs(lead) <= 1, "lead", fmt::format("{}", lead), "a number from -1 to 1");
    std::set<std::string> settings;
    for (const Setting& setting : engine.settings) {
      check_setting(setting);
      require(settings.insert(setting.name).second, "setting name", setting.name, "given once");
    }
  }
}

}  // namespace rockstack
