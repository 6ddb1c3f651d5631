#include "comparisons/studies/impact_laws/study.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "rockstack_comparisons_texts.hpp"

namespace rockstack {
namespace {

void add_header(CsvWriter& csv, std::string_view columns) {
  for (const Paragraph& column : paragraphs(columns)) csv.add(column.name);
  csv.end_line();
}

Json definitions(std::string_view columns) {
  Json json;
  for (const Paragraph& column : paragraphs(columns)) json[column.name] = column.words;
  return json;
}

/// One row a case, engine and time step.
std::string verdicts_csv(const std::vector<ImpactCase>& cases) {
  CsvWriter csv;
  add_header(csv, verdict_columns_txt);
  for (const ImpactCase& question : cases) {
    const Disagreement& found = question.disagreement;
    for (const EngineVerdict& verdict : question.verdicts) {
      const bool failed = !verdict.failure.empty();
      const auto cell = [&](double value) { return failed ? "" : number_text(value); };
      const auto spaced = [](const auto& values) { return fmt::format("{}", fmt::join(values, " ")); };
      csv.line(question.name, name(found.kind), verdict.engine, verdict.solver, verdict.settings, verdict.dt,
               failed ? "failed" : "done", verdict.failure, name(found.paper), name(found.consistent),
               failed ? "" : name(verdict.pattern), verdict.follows, cell(verdict.from_paper),
               cell(verdict.from_consistent), spaced(question.before), spaced(question.paper),
               spaced(question.consistent), spaced(verdict.rates));
    }
  }
  return csv.text();
}

Json case_json(const ImpactCase& question) {
  const Scene& scene = question.scene;
  Json blocks = Json::array();
  for (const Block& block : scene.blocks)
    blocks.push_back({{"width", 2 * block.half_width},
                      {"height", 2 * block.half_height},
                      {"mass", block.mass},
                      {"inertia", block.inertia}});
  return {{"name", question.name},
          {"clearness", question.disagreement.clearness},
          {"impact_time", question.time},
          {"duration", scene.duration},
          {"blocks", blocks},
          {"angles", scene.initial.angles},
          {"velocities", scene.initial.velocities}};
}

/// Engine runs together: which law's pattern they show, and how far their velocities are from either.
struct EngineTally {
  Json of;  ///< what they have in common
  int consistent = 0, paper = 0, neither = 0, failed = 0;
  std::vector<double> from_paper = {}, from_consistent = {};  ///< of those that did not fail

  int runs() const { return consistent + paper + neither + failed; }

  void add(const EngineVerdict& verdict) {
    if (!verdict.failure.empty()) {
      ++failed;
      return;
    }
    ++(verdict.follows == "consistent" ? consistent : verdict.follows == "paper" ? paper : neither);
    from_paper.push_back(verdict.from_paper);
    from_consistent.push_back(verdict.from_consistent);
  }

  /// As a row of a table.
  Json row() const {
    Json row = of;
    row.update({{"runs", runs()},
                {"consistent", consistent},
                {"paper", paper},
                {"neither", neither},
                {"failed", failed}});
    const bool any = !from_paper.empty();
    row["median_from_paper"] = any ? Json(median(from_paper)) : Json();
    row["median_from_consistent"] = any ? Json(median(from_consistent)) : Json();
    row["largest_from_consistent"] = any ? Json(std::ranges::max(from_consistent)) : Json();
    return row;
  }
};

/// Tallies of runs that have the same `of`, in order of appearance.
template <class Of>
std::vector<EngineTally> tallies(const std::vector<ImpactCase>& cases, const Of& of) {
  std::vector<EngineTally> list;
  for (const ImpactCase& question : cases)
    for (const EngineVerdict& verdict : question.verdicts) {
      const Json own = of(question, verdict);
      found_or_added(list, [&](const EngineTally& known) { return known.of == own; }, {own}).add(verdict);
    }
  return list;
}

double percent_of(int part, int whole) {
  return whole > 0 ? 100.0 * part / whole : 0;
}

Json kind_row(const ImpactShare& kind) {
  return {{"blocks", kind.blocks},
          {"kind", name(kind.kind)},
          {"impacts", kind.impacts},
          {"differ", kind.differ},
          {"differ_percent", percent_of(kind.differ, kind.impacts)},
          {"none", kind.none},
          {"none_percent", percent_of(kind.none, kind.impacts)}};
}

Json pair_row(const Disagreement& found) {
  return {{"kind", name(found.kind)},
          {"paper", name(found.paper)},
          {"consistent", name(found.consistent)},
          {"count", found.count},
          {"clearness", found.clearness}};
}

Json verdict_set(const ImpactCase&, const EngineVerdict& verdict) {
  return {{"engine", verdict.engine},
          {"solver", verdict.solver},
          {"settings", verdict.settings},
          {"dt", verdict.dt}};
}

/// A state by its name, and its top block: height over width, and mass over that of the block below.
Json case_state(const ImpactCase& question, const EngineVerdict&) {
  const std::vector<Block>& blocks = question.scene.blocks;
  const Block &top = blocks.back(), &below = blocks.end()[-2];
  return {{"case", question.name},
          {"aspect_ratio", top.half_height / top.half_width},
          {"mass_ratio", top.mass / below.mass}};
}

/// How often the laws differ for stacks of so many blocks, and after which kinds most.
std::string stacks_sentence(int blocks, std::vector<ImpactShare> kinds) {
  std::erase_if(kinds, [&](const ImpactShare& kind) { return kind.blocks != blocks; });
  const std::size_t count = kinds.size();
  int impacts = 0, differ = 0, none = 0;
  for (const ImpactShare& kind : kinds) impacts += kind.impacts, differ += kind.differ, none += kind.none;
  const auto share = [](const ImpactShare& kind) { return percent_of(kind.differ, kind.impacts); };
  std::erase_if(kinds, [](const ImpactShare& kind) { return kind.differ == 0; });
  std::ranges::stable_sort(kinds, std::greater(), share);
  const auto words = mapped(kinds, [&](const ImpactShare& kind) {
    return fmt::format("{} ({:.1f} %)", name(kind.kind), share(kind));
  });
  return fmt::format(
      "Stacks of {} blocks: the laws have different patterns after {:.1f} % of {} impacts, in "
      "{} of {}{}{}; after {:.1f} % no pattern is consistent.",
      blocks, percent_of(differ, impacts), impacts, kinds.size(), counted(count, "kind"),
      kinds.empty() ? "" : ", most often after ", joined_up_to(3, words), percent_of(none, impacts));
}

Json results_json(const ImpactLawStudy& study, const ImpactLawResults& results, const std::string& command) {
  Json json{{"title", study.title}, {"study", "impact-laws"}, {"headline", headline(study, results)}};
  json["tables"] = mapped(tables(results), &ResultTable::file);
  json["tables"].push_back("impact-laws-engines.csv");
  json["suite_file"] = study.text;
  json["definitions"] = {{"impact-laws.csv", definitions(share_columns_txt)},
                         {"impact-laws-engines.csv", definitions(verdict_columns_txt)}};
  json["disagreements"] = mapped(results.laws.disagreements, pair_row);
  json["cases"] = mapped(results.cases, case_json);
  json["engines"] = mapped(study.engines.series, [](const EngineSeries& series) {
    return Json{{"engine", series.engine->name},
                {"solver", series.engine->solver},
                {"settings", series.settings},
                {"parameters", series.parameters}};
  });
  json["left_out"] = study.engines.left_out;
  json["environment"] = environment(mapped(study.engines.series, &EngineSeries::engine));
  json["command"] = command;
  return json;
}

}  // namespace

ImpactLawResults run_study(const ImpactLawStudy& study) {
  ImpactLawResults results{study_impact_laws(study.draws), {}};
  results.cases = clear_cases(results.laws.disagreements, study.least_clearness);
  for (ImpactCase& question : results.cases)
    for (const EngineSeries& series : study.engines.series)
      for (const double dt : series.steps) question.verdicts.push_back(ask_engine(question, series, dt));
  return results;
}

std::vector<ImpactShare> shares_by_kind(const std::vector<ImpactShare>& shares) {
  std::vector<ImpactShare> kinds;
  for (const ImpactShare& share : shares) {
    if (kinds.empty() || kinds.back().kind != share.kind) kinds.push_back({share.blocks, share.kind});
    kinds.back().impacts += share.impacts;
    kinds.back().differ += share.differ;
    kinds.back().none += share.none;
  }
  return kinds;
}

std::vector<std::string> headline(const ImpactLawStudy& study, const ImpactLawResults& results) {
  std::vector<std::string> sentences;
  if (const auto all = tallies(results.cases, [](const auto&...) { return Json(); }); !all.empty()) {
    const EngineTally& runs = all.front();
    std::ptrdiff_t nearer = 0;
    for (std::size_t i = 0; i < runs.from_paper.size(); ++i)
      nearer += static_cast<std::ptrdiff_t>(runs.from_consistent[i] < runs.from_paper[i]);
    sentences.push_back(
        fmt::format("Where the laws differ, in {}, engines take the pattern of law consistent in {} of {}, "
                    "that of law paper in {}, and their velocities are nearer to law consistent's in {}.",
                    counted(results.cases.size(), "state"), runs.consistent,
                    counted(static_cast<std::size_t>(runs.runs()), "run"), runs.paper, nearer));
  } else {
    sentences.emplace_back("No engine was asked.");
  }
  const std::vector<ImpactShare> kinds = shares_by_kind(results.laws.shares);
  for (const int blocks : study.draws.blocks) sentences.push_back(stacks_sentence(blocks, kinds));
  return sentences;
}

std::vector<ResultTable> tables(const ImpactLawResults& results) {
  std::vector<ResultTable> list{
      {"impact-laws-kinds.csv", mapped(shares_by_kind(results.laws.shares), kind_row)},
      {"impact-laws-answers.csv", mapped(results.laws.disagreements, pair_row)},
      {"impact-laws-sets.csv", mapped(tallies(results.cases, verdict_set), std::mem_fn(&EngineTally::row))},
      {"impact-laws-states.csv", mapped(tallies(results.cases, case_state), std::mem_fn(&EngineTally::row))}};
  std::erase_if(list, [](const ResultTable& one) { return one.rows.empty(); });
  return list;
}

std::string shares_csv(const std::vector<ImpactShare>& shares) {
  CsvWriter csv;
  add_header(csv, share_columns_txt);
  for (const ImpactShare& share : shares)
    csv.line(share.blocks, name(share.kind), share.aspect_ratio.from, share.aspect_ratio.to,
             share.mass_ratio.from, share.mass_ratio.to, share.drawn, share.impacts, share.differ, share.none,
             share.several, share.missed);
  return csv.text();
}

void write_results(const ImpactLawStudy& study, const ImpactLawResults& results,
                   const std::filesystem::path& folder, const std::string& command) {
  write_file(folder / "impact-laws.csv", shares_csv(results.laws.shares));
  write_file(folder / "impact-laws-engines.csv", verdicts_csv(results.cases));
  for (const ResultTable& one : tables(results)) write_file(folder / one.file, csv_of(one.rows));
  write_file(folder / "impact-laws.json", results_json(study, results, command).dump(2) + "\n");
}

}  // namespace rockstack
