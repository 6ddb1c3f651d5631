#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/print_style.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/figures/figure.hpp"
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

struct PlotArguments {
  std::filesystem::path results;
  std::vector<std::pair<std::string, std::string>> print;  ///< keys of [figures] with their texts
};

#ifdef ROCKSTACK_WITH_PLOTS
void print_for_paper(const PlotArguments& arguments, const Common& common) {
  const plots::PrintedFigures printed =
      plots::print_figures(arguments.results, read_print_style(style_table(arguments.print)));
  const auto stems = mapped(printed.stems, [](const std::filesystem::path& stem) { return stem.string(); });
  if (!print_json({{"figures", stems}, {"left_out", printed.left_out}}, common)) return;
  for (const std::string& reason : printed.left_out) fmt::print("left out: {}\n", reason);
  for (const std::string& stem : stems) fmt::print("{}.pdf, .svg, .png and .csv\n", one_line(stem));
}
#endif

int run_plot(const PlotArguments& arguments, const Common& common) {
  refuse_overrides(common, "figures are of results that are there");
  const FolderLock lock(arguments.results);
#ifdef ROCKSTACK_WITH_PLOTS
  if (!arguments.print.empty()) {
    print_for_paper(arguments, common);
    return 0;
  }
  plots::show(arguments.results);
  print_report(arguments.results, common);
  return 0;
#else
  static_cast<void>(common);
  throw InputError(
      fmt::format("plot {}: must be asked of a build with ROCKSTACK_PLOTS=ON", arguments.results.string()));
#endif
}

std::string option_name(std::string key) {
  std::ranges::replace(key, '_', '-');
  return key;
}

/// An option a key of [figures], which needs --style; one that may be none is a flag.
void add_plot(CLI::App& command, PlotArguments& arguments) {
  command.add_option("folder", arguments.results, "folder with results")->required();
  for (const InputKey& key : print_keys.keys) {
    const std::string name = key.name;
    const auto set = [&arguments, name](const std::string& value) {
      arguments.print.emplace_back(name, value);
    };
    const bool flag = std::string_view(key.example) == "\"none\"";
    CLI::Option* option =
        flag
            ? command.add_flag_callback(
                  "--no-" + name, [set] { set("none"); }, "without the title of the scene")
            : command.add_option_function<std::string>(
                  "--" + option_name(name), set,
                  fmt::format("{}: {}{}{}", key.meaning, key.unit, *key.unit == '\0' ? "" : ", ", key.range));
    if (name != print_keys.keys.front().name) option->needs("--style");
  }
}

}  // namespace

Command plot_command() {
  return make_command("plot", "draw figures and the report from a results folder, or figures for print",
                      add_plot, run_plot);
}

}  // namespace rockstack
