#include "comparisons/studies/threshold/threshold.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

struct ThresholdArguments {
  std::string scene, vary, over, outcome = "topples";
  std::size_t values = 200, over_values = 40;
  std::filesystem::path out;
};

/// Values between which the outcome changes; of a spectrum the first threshold at each value of the other
/// key.
std::vector<TableCells> threshold_lines(const ThresholdRequest& request, const Threshold& found,
                                        const std::optional<ThresholdSpectrum>& spectrum) {
  const auto cell = [](double value) { return number_text(value, 6); };
  std::vector<TableCells> lines;
  if (spectrum) {
    lines.push_back({axis_title(spectrum->over.key), axis_title(request.vary.key)});
    for (std::size_t i = 0; i < spectrum->values.size(); ++i) {
      const std::optional<double> first = spectrum->thresholds[i].first();
      lines.push_back({cell(spectrum->values[i]), first ? cell(*first) : ""});
    }
    return lines;
  }
  lines.push_back({axis_title(request.vary.key) + " from", "to", "outcome"});
  for (const OutcomeRange& range : found.ranges)
    lines.push_back({cell(range.from), cell(range.to),
                     range.happens ? request.outcome.happens : request.outcome.otherwise});
  return lines;
}

int run_threshold(const ThresholdArguments& arguments, const Common& common) {
  MotionLibrary library;
  const SceneDocument document = read_document(input_file(arguments.scene, {"scenes"}), common.overrides);
  const Scene scene = make_scene(document, library);
  const ThresholdRequest request{varied_key("--vary", arguments.vary),
                                 outcome_named(arguments.outcome, scene.blocks.size()), arguments.values};
  const std::optional<VariedKey> over =
      arguments.over.empty() ? std::nullopt : std::optional(varied_key("--over", arguments.over));
  const ResultsFolder folder(arguments.out, Results::threshold, subject_of(arguments.scene), common.replace);
  warn_of_sizes(scene, common);
  const Threshold found = threshold(document, request, library);
  std::optional<ThresholdSpectrum> spectrum;
  if (over)
    spectrum =
        threshold_spectrum(document, request, *over, arguments.over_values, library, [&](std::size_t done) {
          if (!shows_progress(common)) return;
          fmt::print(stderr, "\r\033[K[{} of {} values of {}]", done, arguments.over_values, over->key);
          std::fflush(stderr);
        });
  clear_progress(common);
  const Json json = write_threshold(scene.title, request, found, spectrum ? &*spectrum : nullptr,
                                    arguments.out, common.command);
  if (common.prints_documents()) print_table(threshold_lines(request, found, spectrum), common.table);
  if (print_json(json, common))
    for (const Json& sentence : json.at("headline")) fmt::print("{}\n", sentence.get<std::string>());
  show_report(arguments.out, common);
  return 0;
}

void add_threshold(CLI::App& command, ThresholdArguments& arguments) {
  command.add_option("scene", arguments.scene, scene_help)->required();
  command.add_option("--vary", arguments.vary, "number of the scene and its range, KEY=LOW:HIGH")->required();
  command
      .add_option("--outcome", arguments.outcome,
                  "topples, lifts, or COLUMN>NUMBER of a sweep's columns, such as peak_ratio>0.5")
      ->capture_default_str();
  command
      .add_option("--values", arguments.values, "tried at equal distances before thresholds are closed in on")
      ->check(CLI::Range(2, 1'000'000))
      ->capture_default_str();
  command.add_option("--over", arguments.over,
                     "a second number and its range: the first threshold at each of its values");
  command.add_option("--over-values", arguments.over_values, "of that number")
      ->check(CLI::Range(2, 10'000))
      ->capture_default_str();
  add_results(command, arguments.out, [&] { return arguments.scene; });
}

}  // namespace

Command threshold_command() {
  return with_tables(make_command("threshold", "find the least of a number that topples a stack",
                                  add_threshold, run_threshold));
}

}  // namespace rockstack
