#include "comparisons/suites/shipped.hpp"

#include <fmt/format.h>

#include <array>
#include <system_error>

#include "analytic/scene/input/fields.hpp"
#include "comparisons/measures/results/build.hpp"
#include "engines/worker/installation.hpp"

namespace rockstack {
namespace {

/// What comes with the program: its folder, what one is, and what takes it.
struct Kind {
  const char *folder, *name, *command;
};
constexpr std::array kinds{Kind{"scenes", "a scene", "solve"}, Kind{"suites", "a suite", "compare"},
                           Kind{"ensembles", "an ensemble", "sweep"},
                           Kind{"cylinders", "a cylinder", "round"},
                           Kind{"studies/lessons", "a lesson", "teach"}};

/// Says what an input is that a command does not take.
std::string what_it_is(const std::string& input) {
  std::error_code ignored;
  for (const Kind& kind : kinds)
    if (std::filesystem::exists(find_file(input, kind.folder), ignored))
      return fmt::format("this is {}, which `rockstack {}` takes", kind.name, kind.command);
  return "";
}

}  // namespace

std::filesystem::path shipped(const std::string& kind) {
  return (in_build_tree() ? std::filesystem::path(build::tree) : own_folder() / build::installed) / kind;
}

std::vector<std::string> shipped_names(const std::string& kind, const std::string& ending) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shipped(kind)))
    if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

std::filesystem::path find_file(const std::string& input, const std::string& kind,
                                const std::filesystem::path& folder) {
  std::error_code ignored;  // a link may lead in a circle
  const std::string name = input + ".toml";
  std::filesystem::path given = folder / input, own = shipped(kind) / name;
  if (std::filesystem::is_regular_file(given, ignored)) return given;
  if (std::filesystem::exists(own, ignored)) return own;
  for (const auto& below :
       {std::filesystem::path("canon") / name, input / std::filesystem::path("suite.toml")})
    if (std::filesystem::exists(shipped(kind) / below, ignored)) return shipped(kind) / below;
  return given;
}

std::filesystem::path input_file(const std::string& input, const std::vector<std::string>& asked) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const std::string& kind : asked) {
    std::filesystem::path file = find_file(input, kind);
    if (std::filesystem::exists(file, ignored)) return file;
    for (std::string& name : shipped_names(kind)) names.push_back(std::move(name));
  }
  if (const std::string other = what_it_is(input); !other.empty()) {
    std::vector<std::string> wanted;
    for (const Kind& kind : kinds)
      if (std::ranges::find(asked, kind.folder) != asked.end()) wanted.emplace_back(kind.name);
    throw InputError(fmt::format("{}: must be {}, {}", input, fmt::join(wanted, " or "), other));
  }
  throw InputError(fmt::format("{}: must be a file or a name from `rockstack list`, nothing is there{}",
                               input, did_you_mean(input, names)));
}

std::filesystem::path named_file(const Node& node, const std::string& kind,
                                 const std::filesystem::path& folder) {
  std::filesystem::path file = find_file(text(node), kind, folder);
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) return file;
  throw wrong_value(node, fmt::format("a file or a name from `rockstack list {}`, none is at {}", kind,
                                      one_line(file.string())));
}

}  // namespace rockstack
