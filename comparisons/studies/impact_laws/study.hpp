#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analytic/scene/input/fields.hpp"
#include "comparisons/studies/impact_laws/engines.hpp"

namespace rockstack {

/// What a suite file with `study = "impact-laws"` asks for.
struct ImpactLawStudy {
  std::string title;
  std::string text;  ///< the file as it was read
  ImpactDraws draws;
  double least_clearness = 0.1;  ///< of the disagreements that engines are asked about
  std::vector<EngineSeries> series;
};

/// @throws InputError with file:line, key, value and what is allowed.
ImpactLawStudy read_impact_law_study(const std::filesystem::path& file);

/// A case and what every engine of the study made of it.
struct AskedCase {
  ImpactCase question;
  std::vector<EngineVerdict> verdicts;
};

struct ImpactLawResults {
  ImpactLaws laws;
  std::vector<AskedCase> cases;
};

ImpactLawResults run_study(const ImpactLawStudy& study);

/// A kind's shares over the whole grid.
struct KindShare {
  std::string kind;
  int impacts = 0, differ = 0, none = 0;
};

std::vector<KindShare> shares_by_kind(const std::vector<ImpactShare>& shares);

/// Over all cases, how often one engine at one time step shows which law's pattern.
struct EngineTally {
  std::string engine;  ///< with its solver
  double dt = 0;       ///< s
  int consistent = 0, paper = 0, neither = 0, failed = 0;
};

std::vector<EngineTally> tallies(const std::vector<AskedCase>& cases);

/// One row a cell and kind.
std::string shares_csv(const std::vector<ImpactShare>& shares);

/// One row a case, engine and time step.
std::string verdicts_csv(const std::vector<AskedCase>& cases);

/// Writes impact-laws.csv, impact-laws-engines.csv and impact-laws.json into a folder.
/// @throws std::runtime_error where a file cannot be written.
void write_results(const ImpactLawStudy& study, const ImpactLawResults& results,
                   const std::filesystem::path& folder, const std::string& command);

// The keys of a study of impact laws; its engines are as in a suite.

inline constexpr KeyTable impact_law_keys{
    "",
    "a study of impact laws, which is run as a suite is: how often do they differ?",
    {{"study", "\"impact-laws\"", "", "\"impact-laws\"", required_key, "what the file is"},
     {"title", "\"Laws\"", "", "a text", required_key, "heads figures"},
     {"seed", "1", "", "a whole number from 0 to 2⁵³", "1", "of drawn impacts"},
     {"samples", "400", "", "a whole number from 1 to 10⁶", "400", "impacts in each cell, for each kind"},
     {"cells", "8", "", "a whole number from 1 to 100", "8", "along either axis of the grid"},
     {"blocks", "[2, 3]", "", "of 2, 3", "[2, 3]", "in a stack"},
     {"aspect_ratio", "[0.25, 8.0]", "", "two numbers > 0", "[0.25, 8]",
      "height over width of the top block"},
     {"mass_ratio", "[0.05, 20.0]", "", "two numbers > 0", "[0.05, 20]", "of a block to the one below"},
     {"base_aspect_ratio", "[0.25, 8.0]", "", "two numbers > 0", "[0.25, 8]",
      "height over width of the others"},
     {"width_ratio", "[0.3, 1.0]", "", "two numbers > 0", "[0.3, 1]", "of a block to the one below"},
     {"largest_angle", "0.3", "rad", "> 0, up to 0.78", "0.3", "of an open interface that does not impact"},
     {"speed", "[0.05, 0.5]", "√(g/height)", "two numbers > 0", "[0.05, 0.5]",
      "largest relative rate before"},
     {"least_clearness", "0.1", "", "> 0", "0.1", "of the cases that engines are asked"},
     {"engines", "", "", "tables [[engines]], as in a suite", "none: the laws alone", "which are asked"}}};

inline constexpr std::initializer_list<const KeyTable*> impact_law_tables{&impact_law_keys};

}  // namespace rockstack
