#include "analytic/round/round.hpp"

#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/studies/round/study.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

struct RoundArguments {
  std::string column, threshold;
  double interval = 0.01;
  std::size_t values = 41;
  std::filesystem::path out;
};

int run_round(const RoundArguments& arguments, const Common& common) {
  MotionLibrary library;
  const SceneDocument document = read_document(input_file(arguments.column, {"cylinders"}), common.overrides);
  const RoundScene scene = make_round(document, library);
  const std::vector<double> times = regular_times(arguments.interval, scene.duration);
  const std::optional<VariedKey> vary = arguments.threshold.empty()
                                            ? std::nullopt
                                            : std::optional(varied_key("--threshold", arguments.threshold));
  const ResultsFolder folder(arguments.out, Results::round, subject_of(arguments.column), common.replace);
  const Json json = vary ? write_round_threshold(scene.title, *vary,
                                                 round_threshold(document, *vary, arguments.values, library),
                                                 arguments.out, common.command)
                         : write_round(scene, solve_round(scene, times), arguments.out, common.command);
  if (print_json(json, common)) {
    for (const Json& sentence : json.at("headline")) fmt::print("{}\n", sentence.get<std::string>());
    fmt::print("results: {}\n", one_line(arguments.out.string()));
  }
  return 0;
}

void add_round(CLI::App& command, RoundArguments& arguments) {
  command
      .add_option("column", arguments.column, "file of a cylinder, or a name from `rockstack list cylinders`")
      ->required();
  command.add_option("--threshold", arguments.threshold,
                     "the least of a number that topples it, KEY=LOW:HIGH, in space and in a plane");
  command.add_option("--values", arguments.values, "tried at equal distances before that is closed in on")
      ->check(CLI::Range(2, 1'000'000))
      ->capture_default_str();
  command.add_option("--interval", arguments.interval, "of samples, s")->capture_default_str();
  add_results(command, arguments.out, [&] { return arguments.column; });
}

}  // namespace

Command round_command() {
  return make_command("round", "solve a round column that rolls on its rim, in three dimensions", add_round,
                      run_round);
}

}  // namespace rockstack
