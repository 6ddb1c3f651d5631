#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/studies/impact_laws/study.hpp"

namespace rockstack {
namespace {

std::string range_text(const Range& range) {
  return "[" + number_text(range.from) + ", " + number_text(range.to) + "]";
}

/// A key of two numbers, with those that impacts are drawn from where it is left out.
Key<ImpactLawStudy> range_key(const char* name, const char* example, const char* unit, const char* meaning,
                              Range ImpactDraws::*range) {
  return {{name, example, unit, "two numbers > 0", range_text(ImpactDraws().*range), meaning},
          [=](const Node& node, ImpactLawStudy& study) {
            const std::vector<double> values = numbers(node);
            if (values.size() != 2 || !(values[0] > 0) || !(values[0] < values[1]))
              throw wrong_value(node, "two numbers > 0, the smaller one first");
            study.draws.*range = {values[0], values[1]};
          }};
}

/// Angles below the least at which any block has toppled, π/4.
CheckedNumber open_angles() {
  constexpr double most = 0.78;
  return {"> 0, up to " + number_text(most), "a number", [](const Node& node) {
            if (!(number(node) > 0 && node.number <= most))
              throw wrong_value(node, "a number > 0 and at most " + number_text(most));
            return node.number;
          }};
}

std::vector<int> read_blocks(const Node& array) {
  const char* allowed = "an array of 2 and 3";
  std::vector<int> blocks;
  entries(array, allowed);
  for (const double value : numbers(array)) {
    if (value != 2 && value != 3) throw wrong_value(array, allowed);
    blocks.push_back(static_cast<int>(value));
  }
  return blocks;
}

}  // namespace

const KeysOf<ImpactLawStudy> impact_law_keys{
    "",
    "a study of impact laws, which is run as a suite is: how often do they differ?",
    {{"study", "\"impact-laws\"", "", "\"impact-laws\"", required_key, "what the file is"},
     {"title", "\"Laws\"", "", "a text", required_key, "heads figures", &ImpactLawStudy::title},
     {"seed", "1", "", whole_numbers(0, largest_seed), "of drawn impacts",
      part(&ImpactLawStudy::draws, &ImpactDraws::seed)},
     {"samples", "400", "", whole_numbers(1, 1e6), "impacts in each cell, for each kind",
      part(&ImpactLawStudy::draws, &ImpactDraws::samples)},
     {"cells", "8", "", whole_numbers(1, 100), "along either axis of the grid",
      part(&ImpactLawStudy::draws, &ImpactDraws::cells)},
     {{"blocks", "[2, 3]", "", "of 2, 3", "[2, 3]", "in a stack"},
      [](const Node& node, ImpactLawStudy& study) { study.draws.blocks = read_blocks(node); }},
     range_key("aspect_ratio", "[0.25, 8.0]", "", "height over width of the top block",
               &ImpactDraws::aspect_ratio),
     range_key("mass_ratio", "[0.05, 20.0]", "", "of a block to the one below", &ImpactDraws::mass_ratio),
     range_key("base_aspect_ratio", "[0.25, 8.0]", "", "height over width of the others",
               &ImpactDraws::base_aspect_ratio),
     range_key("width_ratio", "[0.3, 1.0]", "", "of a block to the one below", &ImpactDraws::width_ratio),
     {"largest_angle", "0.3", "rad", open_angles(), "of an open interface that does not impact",
      part(&ImpactLawStudy::draws, &ImpactDraws::largest_angle)},
     range_key("speed", "[0.05, 0.5]", "√(g/height)", "largest relative rate before", &ImpactDraws::speed),
     {"least_clearness", "0.1", "", numbers_above_zero(), "of the cases that engines are asked",
      &ImpactLawStudy::least_clearness},
     {"engines", "", "", "tables [[engines]], as in a suite", "none: the laws alone", "which are asked"}}};

ImpactLawStudy read_impact_law_study(const std::filesystem::path& file) {
  const Node root = read_toml(file);
  const Node& study_name = required(root, "study", "\"stability\" or \"impact-laws\"");
  if (text(study_name) != "impact-laws") throw wrong_value(study_name, "\"stability\" or \"impact-laws\"");
  ImpactLawStudy study;
  read_members(root, impact_law_keys, study);
  study.text = file_text(file);
  study.engines = read_engines(root, file.parent_path());
  const Node* clearness = find(root, "least_clearness");
  if (clearness != nullptr && find(root, "engines") == nullptr)
    throw wrong_value(*clearness, "left out where there are no [[engines]], which are asked these cases");
  return study;
}

}  // namespace rockstack
