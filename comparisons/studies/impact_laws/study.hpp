#pragma once

#include "analytic/scene/input/key.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "comparisons/studies/impact_laws/laws.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {

// What engines make of an impact on which the laws differ: a short scene that starts `lead` before it and
// ends `follow` after it.

inline constexpr double lead = 5e-3;    ///< s
inline constexpr double follow = 5e-3;  ///< s

/// One engine run of a case.
struct EngineVerdict {
  std::string engine, solver, settings;
  double dt = 0;                   ///< s
  std::string failure = {};        ///< why there is no answer, or empty
  Pattern pattern = {};            ///< `follow` after the impact
  std::string follows = {};        ///< the law whose pattern that is, "consistent" or "paper", or "neither"
  std::vector<double> rates = {};  ///< mean angular velocities over the second half of `follow`, rad/s
  double from_paper = 0;           ///< largest difference of those rates from law paper's, over largest_rate
  double from_consistent = 0;      ///< likewise from law consistent's
};

/// A disagreement as a scene, with the exact solver's answer under either law.
struct ImpactCase {
  std::string name;  ///< kind and both answers, "4a-blocks.4b.3b"
  Disagreement disagreement;
  Scene scene;
  double time = 0;                                  ///< of the impact, s
  double largest_rate = 0;                          ///< relative, just before, rad/s
  std::vector<double> before = {};                  ///< angular velocities just before, rad/s
  std::vector<double> paper = {}, consistent = {};  ///< mean angular velocities, see EngineVerdict, rad/s
  std::vector<EngineVerdict> verdicts = {};         ///< of every engine of the study
};

/// Cases of the disagreements that are at least so clear, of each the clearest state; left out where the
/// scene's first event is not that impact, or another follows within `follow`.
std::vector<ImpactCase> clear_cases(const std::vector<Disagreement>& disagreements, double least_clearness);

EngineVerdict ask_engine(const ImpactCase& question, const EngineSeries& series, double dt);

/// What a suite file with `study = "impact-laws"` asks for.
struct ImpactLawStudy {
  std::string title;
  std::string text;  ///< the file as it was read
  ImpactDraws draws;
  double least_clearness = 0.1;  ///< of the disagreements that engines are asked about
  AskedEngines engines;
};

/// @throws InputError with file:line, key, value and what is allowed.
ImpactLawStudy read_impact_law_study(const std::filesystem::path& file);

/// The laws on the whole grid, and the cases on which engines were asked.
struct ImpactLawResults {
  ImpactLaws laws;
  std::vector<ImpactCase> cases;
};

ImpactLawResults run_study(const ImpactLawStudy& study);

/// Each kind's impacts over the whole grid, and how many of them differ or have no pattern.
std::vector<ImpactShare> shares_by_kind(const std::vector<ImpactShare>& shares);

/// What the study comes to, in sentences.
std::vector<std::string> headline(const ImpactLawStudy& study, const ImpactLawResults& results);

/// How often the laws differ for each kind of impact; how often which pair of answers follows it; and for
/// each engine, set and step, and each state that engines were asked, how many runs follow which law and how
/// far they are from either.
std::vector<ResultTable> tables(const ImpactLawResults& results);

/// One row a cell and kind.
std::string shares_csv(const std::vector<ImpactShare>& shares);

/// Writes impact-laws.csv, impact-laws-engines.csv, tables() and impact-laws.json into a folder.
/// @throws std::runtime_error where a file cannot be written.
void write_results(const ImpactLawStudy& study, const ImpactLawResults& results,
                   const std::filesystem::path& folder, const std::string& command);

// The keys of a study of impact laws; its engines are as in a suite.

extern const KeysOf<ImpactLawStudy> impact_law_keys;

inline constexpr std::initializer_list<const KeyTable*> impact_law_tables{&impact_law_keys};

}  // namespace rockstack
