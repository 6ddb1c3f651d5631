#include "comparisons/studies/fit/fit.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

struct FitArguments {
  std::string scene;
  std::filesystem::path out;
  std::vector<std::string> vary;  ///< varied_key() of each
};

std::vector<TableCells> parameter_lines(const Fit& found) {
  const auto cell = [](double value) { return std::isfinite(value) ? number_text(value, 6) : std::string(); };
  std::vector<TableCells> lines{{"parameter", "value", "from (95 %)", "to (95 %)"}};
  for (const FittedParameter& one : found.parameters)
    lines.push_back(
        {is_clock(one.parameter) ? std::string(clock_key) + " (s)" : axis_title(one.parameter.key),
         cell(one.value), cell(one.lower), cell(one.upper)});
  return lines;
}

int run_fit(const FitArguments& arguments, const Common& common) {
  const std::vector<VariedKey> parameters =
      mapped(arguments.vary, [](const std::string& text) { return varied_key("--vary", text); });
  const SceneDocument document = read_document(input_file(arguments.scene, {"scenes"}), common.overrides);
  if (!document.measured) throw missing_key(document.root, "measured", "given, a table of what was measured");
  MotionLibrary library;
  const Scene scene = make_scene(document, library);
  const Measurement measured = read_measurement(document.measured.value(), document.folder, scene);
  const ResultsFolder folder(arguments.out, Results::fit, subject_of(arguments.scene), common.replace);
  warn_of_sizes(scene, common);
  const Fit found = fit(document, measured, parameters);
  write_fit(scene.title, measured, found, arguments.out, common.command);
  const Json json = fit_json(scene.title, measured, found, common.command);
  if (common.prints_documents()) print_table(parameter_lines(found), common.table);
  if (print_json(json, common)) {
    for (const Json& sentence : json.at("headline")) fmt::print("{}\n", sentence.get<std::string>());
    std::string changes;
    for (const FittedParameter& one : found.parameters)
      if (!is_clock(one.parameter))
        changes += " --set " + shell_word(fmt::format("{}={}", one.parameter.key, one.value));
    fmt::print("\nrockstack solve {}{}\n", shell_word(arguments.scene), changes);
  }
  show_report(arguments.out, common);
  return 0;
}

void add_fit(CLI::App& command, FitArguments& arguments) {
  command.add_option("scene", arguments.scene, "scene file with a table [measured]")->required();
  command
      .add_option("--vary", arguments.vary, "key of the scene and its range, KEY=LOW:HIGH; may be repeated")
      ->required()
      ->allow_extra_args(false);
  add_results(command, arguments.out, [&] { return arguments.scene; });
}

}  // namespace

Command fit_command() {
  return with_tables(
      make_command("fit", "find what a test does not tell of its scene, such as a ratio of restitution",
                   add_fit, run_fit));
}

}  // namespace rockstack
