#include "comparisons/studies/fit/fit.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {

int fit_command(const FitArguments& arguments, const Common& common) {
  std::vector<FitParameter> parameters;
  for (const std::string& each : arguments.vary) parameters.push_back(fit_parameter(each));
  const SceneDocument document = read_document(input_file(arguments.scene, {"scenes"}), common.overrides);
  if (!document.measured) throw missing_key(document.root, "measured", "given, a table of what was measured");
  MotionLibrary library;
  const Scene scene = make_scene(document, library);
  const Measurement measured = read_measurement(document.measured.value(), document.folder, scene);
  const ResultsFolder folder(arguments.out, Results::fit);
  const Fit found = fit(document, measured, parameters);
  write_fit(scene.title, measured, found, arguments.out, common.command);
  if (common.json) fmt::print("{}\n", fit_json(scene.title, measured, found, common.command).dump(2));
  if (common.talks()) {
    std::string changes;
    for (const FittedParameter& one : found.parameters) {
      fmt::print("{:<32} {:.6g}  95 %: {:.6g} to {:.6g}\n", one.parameter.key, one.value, one.lower,
                 one.upper);
      changes += " --set " + shell_word(fmt::format("{}={}", one.parameter.key, one.value));
    }
    for (const std::string& sentence : meaning(found, measured)) fmt::print("{}\n", sentence);
    fmt::print("\nrockstack solve {}{}\n", shell_word(arguments.scene), changes);
  }
  show_report(arguments.out, common);
  return 0;
}

}  // namespace rockstack
