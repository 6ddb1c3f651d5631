#include <fmt/format.h>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"

namespace rockstack {

CLI::Validator one_of(const std::vector<std::string>& words) {
  const CLI::IsMember listed(words);
  const auto check = [listed, words](std::string& given) {
    const std::string complaint = listed(given);
    return complaint.empty() ? complaint : complaint + did_you_mean(given, words);
  };
  return {check, listed.get_description()};
}

std::filesystem::path default_results(const std::string& command, const std::filesystem::path& input) {
  return std::filesystem::path("rockstack-results") / folder_name(command + "-" + input.stem().string());
}

void add_results(CLI::App& command, std::filesystem::path& out, std::function<std::string()> input,
                 const char* more) {
  const std::string name = command.get_name();
  command
      .add_option(
          "--out", out,
          fmt::format("folder for results{}; left out: {}", more, default_results(name, "INPUT").string()))
      ->check([](const std::string& text) { return std::string(text.empty() ? "must be a folder" : ""); });
  command.parse_complete_callback([name, &out, input = std::move(input)] {
    if (out.empty()) out = default_results(name, input());
  });
}

void add_plots(CLI::App& command, bool& plots) {
  command.add_flag_callback(
      "--no-plots", [&plots] { plots = false; }, "leave out the figure and the page with the player");
}

void add_settings(CLI::App& command, std::vector<std::string>& settings) {
  command.add_option("--settings", settings, "parameter sets; left out: both")
      ->delimiter(',')
      ->check(one_of({"default", "tuned"}));
}

}  // namespace rockstack
