#include "plots/data/law_results.hpp"

#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {

LawResults read_law_results(const fs::path& results) {
  LawResults read;
  for (CsvLine row(results / "impact-laws.csv"); row.next();)
    read.cells.push_back({row.whole(row.index("blocks"), 1, max_blocks), row.text("kind"),
                          row.value("aspect_ratio_from"), row.value("aspect_ratio_to"),
                          row.value("mass_ratio_from"), row.value("mass_ratio_to"), row.value("impacts"),
                          row.value("differ"), row.value("none")});
  for (CsvLine row(results / "impact-laws-engines.csv"); row.next();) {
    LawRun& one = read.runs.emplace_back();
    one.run.scene = row.text("case");
    one.run.engine = row.text("engine");
    one.run.solver = row.text("solver");
    one.run.settings = row.text("settings");
    one.run.status = row.text("status") == "done" ? RunStatus::done : RunStatus::failed;
    one.run.reason = row.text("reason");
    one.run.dt = row.value("dt");
    one.follows = row.text("follows");
    one.from_paper = row.value("from_paper");
    one.from_consistent = row.value("from_consistent");
  }
  return read;
}

}  // namespace rockstack::plots
