#include "plots/pages/pages.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/statistics/quantile.hpp"
#include "plots/data/law_results.hpp"
#include "plots/data/selection.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/impact_law_summary.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/templates.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;
using Cells = std::vector<std::string>;

std::string whole(double count) {
  return fmt::format("{:.0f}", count);
}

std::string percent(double share) {
  return fmt::format("{:.2f}", share);
}

std::string by_blocks(const LawCell& cell, const std::string& rest) {
  return fmt::format("{};{}", cell.blocks, rest);
}

/// The cells of a share, after those that its name holds, set apart by semicolons.
std::string share_row(const Cells& columns, const LawShare& share) {
  Cells cells;
  std::istringstream names(share.of);
  for (std::string name; std::getline(names, name, ';');) cells.push_back(name);
  for (const double count : {share.impacts, share.differ}) cells.push_back(whole(count));
  cells.push_back(percent(share.differ_percent()));
  cells.push_back(whole(share.none));
  cells.push_back(percent(share.none_percent()));
  return table_row(columns, cells);
}

std::string kinds_table(const std::vector<LawCell>& cells) {
  const Cells columns{"blocks", "kind", "impacts", "laws differ", "differ (%)", "none", "none (%)"};
  std::string rows;
  for (const LawShare& share :
       shares_by(cells, [](const LawCell& cell) { return by_blocks(cell, cell.kind); }))
    rows += share_row(columns, share);
  return table(columns, rows);
}

std::string stacks_table(const std::vector<LawCell>& cells) {
  const Cells columns{"blocks",      "of the top block", "from", "to",      "impacts",
                      "laws differ", "differ (%)",       "none", "none (%)"};
  std::string rows;
  for (const LawShare& share : shares_by(cells, [](const LawCell& cell) {
         return by_blocks(
             cell, fmt::format("height over width;{};{}", cell.aspect_ratio_from, cell.aspect_ratio_to));
       }))
    rows += share_row(columns, share);
  for (const LawShare& share : shares_by(cells, [](const LawCell& cell) {
         return by_blocks(cell, fmt::format("mass;{};{}", cell.mass_ratio_from, cell.mass_ratio_to));
       }))
    rows += share_row(columns, share);
  return table(columns, rows);
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

Cells followed_by(Cells columns, const Cells& others) {
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

std::string solvers_table(const std::vector<LawRun>& runs) {
  const Cells columns = followed_by({"solver", "time step (s)"}, tally_columns);
  std::string rows;
  for (const LawTally& tally : tallies_by(runs, [](const LawRun& one) {
         return fmt::format("{};{}", line_label(one.run), value_of(one.run.dt));
       })) {
    const std::size_t end = tally.of.find(';');
    rows += table_row(columns, with_tally({tally.of.substr(0, end), tally.of.substr(end + 1)}, tally));
  }
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
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
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

std::string details_of(const std::vector<std::pair<std::string, Facts>>& parts) {
  std::string text;
  for (const auto& [name, facts] : parts)
    text += element("details", element("summary", escaped(name)) + definition_list(facts)) + "\n";
  return text;
}

std::string definitions_of(const LawResults& results) {
  std::string text;
  for (const auto& [file, facts] : results.definitions)
    text += element("h3", escaped(file)) + definition_list(facts);
  return text;
}

std::string content(const fs::path& folder, const LawResults& results) {
  return filled_in(impact_laws_html,
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
                    {"parameters", details_of(results.engines)},
                    {"definitions", definitions_of(results)},
                    {"command", escaped(results.command)},
                    {"environment", definition_list(results.environment)}});
}

}  // namespace

void write_impact_law_report(const std::filesystem::path& results) {
  const LawResults read = read_law_results(results);
  write_file(results / "report.html", page({read.title, "report", content(results, read)}));
}

}  // namespace rockstack::plots
