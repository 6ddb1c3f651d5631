#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/pages/show.hpp"
#endif

namespace rockstack {
namespace {

int run_plot(const std::filesystem::path& results, const Common& common) {
  refuse_overrides(common, "figures are of results that are there");
  const FolderLock lock(results);
#ifdef ROCKSTACK_WITH_PLOTS
  plots::show(results);
  print_report(results, common);
  return 0;
#else
  static_cast<void>(common);
  throw InputError(
      fmt::format("plot {}: must be asked of a build with ROCKSTACK_PLOTS=ON", results.string()));
#endif
}

void add_plot(CLI::App& command, std::filesystem::path& results) {
  command.add_option("folder", results, "folder with results")->required();
}

}  // namespace

Command plot_command() {
  return make_command("plot", "draw figures and the report from a results folder", add_plot, run_plot);
}

}  // namespace rockstack
