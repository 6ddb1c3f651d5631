#include "plots/data/law_results.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analytic/scene/pattern.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// The cells of one row by the names of their columns.
class Row {
 public:
  Row(const Table& table, std::size_t index, const fs::path& file)
      : table_(table), index_(index), file_(file) {}

  std::string text(const char* name) const { return table_.rows[index_][column(table_, name, file_)]; }
  double value(const char* name) const { return number(text(name), place(), name); }
  int blocks() const { return whole_number(text("blocks"), place(), "blocks", 1, max_blocks); }
  RunStatus named_status() const { return text("status") == "done" ? RunStatus::done : RunStatus::failed; }

 private:
  std::string place() const { return fmt::format("{}:{}", file_.string(), index_ + 2); }

  const Table& table_;
  std::size_t index_;
  const fs::path& file_;
};

void read_cells(const fs::path& file, LawResults& results) {
  const Table table = read_table(file);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row row(table, i, file);
    results.cells.push_back({row.blocks(), row.text("kind"), row.value("aspect_ratio_from"),
                             row.value("aspect_ratio_to"), row.value("mass_ratio_from"),
                             row.value("mass_ratio_to"), row.value("impacts"), row.value("differ"),
                             row.value("none")});
  }
}

void read_runs(const fs::path& file, LawResults& results) {
  const Table table = read_table(file);
  results.columns = table.columns;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const Row row(table, i, file);
    LawRun one;
    one.run.scene = row.text("case");
    one.run.engine = row.text("engine");
    one.run.solver = row.text("solver");
    one.run.settings = row.text("settings");
    one.run.status = row.named_status();
    one.run.reason = row.text("reason");
    one.run.dt = row.value("dt");
    one.cells = table.rows[i];
    one.follows = row.text("follows");
    one.from_paper = row.value("from_paper");
    one.from_consistent = row.value("from_consistent");
    results.runs.push_back(std::move(one));
  }
}

LawState state_of(const Json& json) {
  const Json& blocks = json.at("blocks");
  const Json& top = blocks.at(blocks.size() - 1);
  const Json& below = blocks.at(blocks.size() - 2);
  return {json.at("name").get<std::string>(), top.at("height").get<double>() / top.at("width").get<double>(),
          top.at("mass").get<double>() / below.at("mass").get<double>()};
}

void read_description(const Json& json, LawResults& results) {
  results.title = json.at("title").get<std::string>();
  results.command = json.at("command").get<std::string>();
  results.suite_file = json.at("suite_file").get<std::string>();
  for (const auto& [file, columns] : json.at("definitions").items())
    results.definitions.emplace_back(file, facts_of(columns));
  results.environment = facts_of(json.at("environment"));
  results.left_out = json.at("left_out").get<std::vector<std::string>>();
  for (const Json& engine : json.at("engines"))
    results.engines.emplace_back(
        fmt::format("{}:{}, {}", engine.at("engine").get<std::string>(),
                    engine.at("solver").get<std::string>(), engine.at("settings").get<std::string>()),
        facts_of(engine.at("parameters")));
  for (const Json& pair : json.at("disagreements"))
    results.pairs.push_back({pair.at("kind").get<std::string>(), pair.at("paper").get<std::string>(),
                             pair.at("consistent").get<std::string>(), pair.at("count").get<double>(),
                             pair.at("clearness").get<double>()});
  for (const Json& state : json.at("cases")) results.states.push_back(state_of(state));
}

/// The entry of that name, added at the end where there is none.
template <class Entry>
Entry& entry_of(std::vector<Entry>& list, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const Entry& entry) { return entry.of == name; });
  if (found != list.end()) return *found;
  list.emplace_back();
  list.back().of = name;
  return list.back();
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
  const fs::path description = results / "impact-laws.json";
  read_json(description, [&](const Json& json) { read_description(json, read); });
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

std::string aspect_ratio_range(const LawCell& cell) {
  return fmt::format("{:.3g} to {:.3g}", cell.aspect_ratio_from, cell.aspect_ratio_to);
}

std::string mass_ratio_range(const LawCell& cell) {
  return fmt::format("{:.3g} to {:.3g}", cell.mass_ratio_from, cell.mass_ratio_to);
}

std::vector<LawTally> tallies_by(const std::vector<LawRun>& runs,
                                 const std::function<std::string(const LawRun&)>& name) {
  std::vector<LawTally> list;
  for (const LawRun& one : runs) add(entry_of(list, name(one)), one);
  return list;
}

}  // namespace rockstack::plots
