#include "plots/data/law_results.hpp"

#include <fmt/core.h>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

void read_cells(const fs::path& file, LawResults& results) {
  for (CsvLine row(file); row.next();)
    results.cells.push_back({row.whole(row.index("blocks"), 1, max_blocks), row.text("kind"),
                             row.value("aspect_ratio_from"), row.value("aspect_ratio_to"),
                             row.value("mass_ratio_from"), row.value("mass_ratio_to"), row.value("impacts"),
                             row.value("differ"), row.value("none")});
}

void read_runs(const fs::path& file, LawResults& results) {
  CsvLine row(file);
  results.columns = row.names();
  while (row.next()) {
    LawRun& one = results.runs.emplace_back();
    one.run.scene = row.text("case");
    one.run.engine = row.text("engine");
    one.run.solver = row.text("solver");
    one.run.settings = row.text("settings");
    one.run.status = row.text("status") == "done" ? RunStatus::done : RunStatus::failed;
    one.run.reason = row.text("reason");
    one.run.dt = row.value("dt");
    one.cells = row.cells();
    one.follows = row.text("follows");
    one.from_paper = row.value("from_paper");
    one.from_consistent = row.value("from_consistent");
  }
}

/// The entry of that name, added at the end where there is none.
template <class Entry>
Entry& entry_of(std::vector<Entry>& list, const std::string& name) {
  return found_or_added(list, [&](const Entry& entry) { return entry.of == name; }, {name});
}

void add(LawTally& tally, const LawRun& one) {
  if (!one.run.done()) {
    ++tally.failed;
    return;
  }
  ++(one.follows == "consistent" ? tally.consistent : one.follows == "paper" ? tally.paper : tally.neither);
  tally.from_paper.push_back(one.from_paper);
  tally.from_consistent.push_back(one.from_consistent);
  if (tally.farthest == nullptr || one.from_consistent > tally.farthest->from_consistent)
    tally.farthest = &one;
}

}  // namespace

LawResults read_law_results(const fs::path& results) {
  LawResults read;
  read_json(results / "impact-laws.json", [&](const Json& json) {
    read.states = json.at("cases").size();
    read.left_out = json.at("left_out").get<std::vector<std::string>>();
  });
  read_cells(results / "impact-laws.csv", read);
  read_runs(results / "impact-laws-engines.csv", read);
  return read;
}

std::vector<LawShare> shares_by(const std::vector<LawCell>& cells,
                                const std::function<std::string(const LawCell&)>& name) {
  std::vector<LawShare> list;
  for (const LawCell& cell : cells) {
    LawShare& share = entry_of(list, name(cell));
    share.impacts += cell.impacts;
    share.differ += cell.differ;
    share.none += cell.none;
  }
  return list;
}

std::vector<LawTally> tallies_by(const std::vector<LawRun>& runs,
                                 const std::function<std::string(const LawRun&)>& name) {
  std::vector<LawTally> list;
  for (const LawRun& one : runs) add(entry_of(list, name(one)), one);
  return list;
}

}  // namespace rockstack::plots
