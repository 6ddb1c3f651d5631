#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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

}  // namespace rockstack
