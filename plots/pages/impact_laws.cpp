#include <map>
#include <numeric>
#include <sstream>

#include "comparisons/measures/statistics/samples.hpp"
#include "plots/data/law_results.hpp"
#include "plots/pages/sections.hpp"
#include "plots/pages/show.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;
using Cells = std::vector<std::string>;

std::string whole(double count) {
  return fmt::format("{:.0f}", count);
}

/// The parts of a name that semicolons set apart.
Cells parts_of(const std::string& name) {
  Cells parts;
  std::istringstream names(name);
  for (std::string part; std::getline(names, part, ';');) parts.push_back(part);
  return parts;
}

Cells followed_by(Cells columns, const Cells& others) {
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

const Cells share_columns{"impacts", "laws differ", "differ (%)", "none", "none (%)"};

/// Rows of cells together that have the same number of blocks and the same other name: its parts, then
/// counts.
template <class Name>
std::string share_rows(const Cells& columns, const std::vector<LawCell>& cells, const Name& name) {
  const auto percent = [](double share) { return fmt::format("{:.2f}", share); };
  std::string rows;
  for (const LawShare& share :
       shares_by(cells, [&](const LawCell& cell) { return fmt::format("{};{}", cell.blocks, name(cell)); }))
    rows += table_row(columns,
                      followed_by(parts_of(share.of),
                                  {whole(share.impacts), whole(share.differ), percent(share.differ_percent()),
                                   whole(share.none), percent(share.none_percent())}));
  return rows;
}

std::string kinds_table(const std::vector<LawCell>& cells) {
  const Cells columns = followed_by({"blocks", "kind"}, share_columns);
  return table(columns, share_rows(columns, cells, [](const LawCell& cell) { return cell.kind; }));
}

std::string stacks_table(const std::vector<LawCell>& cells) {
  const Cells columns = followed_by({"blocks", "of the top block", "from", "to"}, share_columns);
  const auto slenderness = [](const LawCell& cell) {
    return fmt::format("height over width;{};{}", cell.aspect_ratio_from, cell.aspect_ratio_to);
  };
  const auto mass = [](const LawCell& cell) {
    return fmt::format("mass;{};{}", cell.mass_ratio_from, cell.mass_ratio_to);
  };
  return table(columns, share_rows(columns, cells, slenderness) + share_rows(columns, cells, mass));
}

std::string pairs_table(const std::vector<LawPair>& pairs) {
  const Cells columns{"kind", "law paper", "law consistent", "impacts", "clearness"};
  std::string rows;
  for (const LawPair& pair : pairs)
    rows += table_row(columns, {pair.kind, pair.paper, pair.consistent, whole(pair.count),
                                fmt::format("{}", pair.clearness)});
  return table(columns, rows);
}

/// What tables of runs have after the columns that name them.
const Cells tally_columns{"runs",
                          "consistent",
                          "paper",
                          "neither",
                          "failed",
                          "median from consistent",
                          "median from paper",
                          "largest from consistent"};

Cells with_tally(Cells names, const LawTally& tally) {
  for (const int count : {tally.runs(), tally.consistent, tally.paper, tally.neither, tally.failed})
    names.push_back(std::to_string(count));
  const bool any = tally.farthest != nullptr;
  names.push_back(any ? fmt::format("{}", median(tally.from_consistent)) : "");
  names.push_back(any ? fmt::format("{}", median(tally.from_paper)) : "");
  names.push_back(any ? fmt::format("{}", tally.farthest->from_consistent) : "");
  return names;
}

std::string solvers_table(const std::vector<LawRun>& runs) {
  const Cells columns = followed_by({"solver", "time step (s)"}, tally_columns);
  std::string rows;
  for (const LawTally& tally : tallies_by(runs, [](const LawRun& one) {
         return fmt::format("{};{}", line_label(one.run), value_of(one.run.dt));
       }))
    rows += table_row(columns, with_tally(parts_of(tally.of), tally));
  return table(columns, rows);
}

std::string states_table(const LawResults& results) {
  const Cells columns =
      followed_by({"state", "height over width of the top block", "its mass over that below"}, tally_columns);
  std::map<std::string, LawTally> tallies;
  for (LawTally& tally : tallies_by(results.runs, [](const LawRun& one) { return one.run.scene; }))
    tallies.emplace(tally.of, std::move(tally));
  std::string rows;
  for (const LawState& state : results.states)
    rows += table_row(columns, with_tally({state.name, fmt::format("{}", state.aspect_ratio),
                                           fmt::format("{}", state.mass_ratio)},
                                          tallies[state.name]));
  return table(columns, rows);
}

/// "0.1234 -0.5678" of numbers with many digits.
std::string rounded(const std::string& numbers) {
  std::istringstream stream(numbers);
  std::string text;
  for (double value = 0; stream >> value;) text += (text.empty() ? "" : " ") + fmt::format("{:.4g}", value);
  return text;
}

/// What is compared stands side by side; a file of other columns has them at the end.
std::vector<std::size_t> order_of(const Cells& columns) {
  const Cells first{"case",       "engine",      "solver",          "settings",
                    "dt",         "follows",     "pattern",         "paper",
                    "consistent", "from_paper",  "from_consistent", "before",
                    "rates",      "rates_paper", "rates_consistent"};
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](std::size_t i) { return std::find(first.begin(), first.end(), columns[i]); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
  return order;
}

std::string runs_table(const LawResults& results) {
  const std::set<std::string> lists{"before", "rates", "rates_paper", "rates_consistent"};
  const std::vector<std::size_t> order = order_of(results.columns);
  Cells columns;
  for (const std::size_t i : order) columns.push_back(results.columns[i]);
  std::string rows;
  for (const LawRun& one : results.runs) {
    Cells cells;
    for (const std::size_t i : order)
      cells.push_back(lists.contains(results.columns[i]) ? rounded(one.cells[i]) : one.cells[i]);
    rows += table_row(columns, cells, one.run.done() ? "" : " class=\"failed\"");
  }
  return table(columns, rows);
}

std::string maps(const fs::path& results, const std::vector<LawCell>& cells) {
  std::set<int> blocks;
  for (const LawCell& cell : cells) blocks.insert(cell.blocks);
  std::string text;
  for (const int count : blocks)
    text += drawn_figure(results, fmt::format("impact-laws.{}-blocks", count), fmt::format("laws-{}-", count),
                         fmt::format("Where the laws differ for {} blocks", count));
  return text;
}

/// Facts under names: of each, what `titled` makes of them.
template <class Titled>
std::string facts_under(const std::vector<std::pair<std::string, Facts>>& parts, const Titled& titled) {
  std::string text;
  for (const auto& [name, facts] : parts) text += titled(escaped(name), definition_list(facts));
  return text;
}

std::string content(const fs::path& folder, const LawResults& results) {
  return filled_in(
      impact_laws_html,
      {{"title", escaped(results.title)},
       {"answer", answer_box(law_answer(results))},
       {"law_summary", sentence_list(law_summary(results))},
       {"engine_summary", sentence_list(engine_summary(results))},
       {"maps", maps(folder, results.cells)},
       {"kinds", kinds_table(results.cells)},
       {"stacks", stacks_table(results.cells)},
       {"pairs", pairs_table(results.pairs)},
       {"engine_figure", drawn_figure(folder, "impact-laws.engines", "laws-engines-",
                                      "How far every engine run is from either law")},
       {"solvers", solvers_table(results.runs)},
       {"states", states_table(results)},
       {"runs", runs_table(results)},
       {"suite", escaped(results.suite_file)},
       {"parameters", facts_under(results.engines,
                                  [](const auto& name, const auto& facts) { return details(name, facts); })},
       {"definitions",
        facts_under(results.definitions,
                    [](const auto& name, const auto& facts) { return element("h3", name) + facts; })},
       {"command", escaped(results.command)},
       {"environment", definition_list(results.environment)}});
}

}  // namespace

void write_impact_law_report(const std::filesystem::path& results) {
  const LawResults read = read_law_results(results);
  write_file(results / "report.html", page({read.title, "report", content(results, read)}));
}

}  // namespace rockstack::plots
