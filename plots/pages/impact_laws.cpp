#include <numeric>
#include <sstream>

#include "comparisons/measures/results/csv.hpp"
#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

using Cells = std::vector<std::string>;

std::string whole(double count) {
  return fmt::format("{:.0f}", count);
}

Cells followed_by(Cells columns, const Cells& others) {
  columns.insert(columns.end(), others.begin(), others.end());
  return columns;
}

const Cells share_columns{"impacts", "laws differ", "differ (%)", "none", "none (%)"};

/// Rows of cells that have the same number of blocks and the same other name: its parts, then counts.
template <class Name>
std::string share_rows(const Cells& columns, const std::vector<LawCell>& cells, const Name& name) {
  const auto percent = [](double share) { return fmt::format("{:.2f}", share); };
  std::string rows;
  for (const LawShare& share : together_by<LawShare>(
           cells, [&](const LawCell& cell) { return fmt::format("{};{}", cell.blocks, name(cell)); }))
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

std::string pairs_table(const Json& pairs) {
  const Cells columns{"kind", "law paper", "law consistent", "impacts", "clearness"};
  return table(columns, joined_texts(pairs, [&](const Json& pair) {
                 return table_row(columns,
                                  {text_at(pair, "kind"), text_at(pair, "paper"), text_at(pair, "consistent"),
                                   whole(pair.at("count").get<double>()),
                                   fmt::format("{}", pair.at("clearness").get<double>())});
               }));
}

/// What tables of runs have after the columns that name them.
const Cells tally_columns = parts_of(
    "runs;consistent;paper;neither;failed;median from consistent;median from paper;largest from consistent");

Cells with_tally(Cells names, const LawTally& tally) {
  for (const int count : {tally.runs(), tally.consistent, tally.paper, tally.neither, tally.failed})
    names.push_back(std::to_string(count));
  if (tally.farthest == nullptr) return followed_by(names, {"", "", ""});
  for (const double number :
       {median(tally.from_consistent), median(tally.from_paper), tally.farthest->from_consistent})
    names.push_back(fmt::format("{}", number));
  return names;
}

std::string solvers_table(const std::vector<LawRun>& runs) {
  const Cells columns = followed_by({"solver", "time step (s)"}, tally_columns);
  const auto tallies = together_by<LawTally>(runs, [](const LawRun& one) {
    return fmt::format("{};{}", line_label(one.run), value_of(one.run.dt));
  });
  return table(columns, joined_texts(tallies, [&](const LawTally& tally) {
                 return table_row(columns, with_tally(parts_of(tally.of), tally));
               }));
}

std::string states_table(const std::vector<LawRun>& runs, const Json& states) {
  const Cells columns =
      followed_by({"state", "height over width of the top block", "its mass over that below"}, tally_columns);
  std::map<std::string, LawTally> tallies;
  for (const LawRun& one : runs) tallies[one.run.scene].add(one);
  return table(columns, joined_texts(states, [&](const Json& state) {
                 const std::string name = text_at(state, "name");
                 const Json& blocks = state.at("blocks");
                 const Json &top = blocks.at(blocks.size() - 1), &below = blocks.at(blocks.size() - 2);
                 const double ratio = top.at("height").get<double>() / top.at("width").get<double>(),
                              mass = top.at("mass").get<double>() / below.at("mass").get<double>();
                 return table_row(
                     columns,
                     with_tally({name, fmt::format("{}", ratio), fmt::format("{}", mass)}, tallies[name]));
               }));
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
  const Cells first = parts_of(
      "case;engine;solver;settings;dt;follows;pattern;paper;consistent;from_paper;from_consistent;before;rates;"
      "rates_paper;rates_consistent");
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::ranges::find(first, columns[i]); });
  return order;
}

std::string runs_table(const fs::path& folder) {
  const std::set<std::string> lists{"before", "rates", "rates_paper", "rates_consistent"};
  CsvLine row(folder / "impact-laws-engines.csv");
  const std::vector<std::size_t> order = order_of(row.names());
  const Cells columns = mapped(order, [&](std::size_t i) { return row.names()[i]; });
  std::string rows;
  while (row.next()) {
    const Cells cells = mapped(order, [&](std::size_t i) {
      return lists.contains(row.names()[i]) ? rounded(row.text(i)) : row.text(i);
    });
    rows += table_row(columns, cells, row.text("status") == "done" ? "" : " class=\"failed\"");
  }
  return table(columns, rows);
}

std::string maps(const fs::path& results, const std::vector<LawCell>& cells) {
  std::set<int> blocks;
  for (const LawCell& cell : cells) blocks.insert(cell.blocks);
  return joined_texts(blocks, [&](int count) {
    return drawn_figure(results, fmt::format("impact-laws.{}-blocks", count), fmt::format("laws-{}-", count),
                        fmt::format("Where the laws differ for {} blocks", count));
  });
}

std::string content(const fs::path& folder, const LawResults& results, const Json& json) {
  const std::string parameters = joined_texts(json.at("engines"), [](const Json& engine) {
    return details(escaped(solver_named(engine) + ", " + text_at(engine, "settings")),
                   definition_list(facts_of(engine.at("parameters"))));
  });
  std::string definitions;
  for (const auto& [file, columns] : json.at("definitions").items())
    definitions += element("h3", escaped(file)) + definition_list(facts_of(columns));
  return filled_in(impact_laws_html,
                   {{"title", escaped_at(json, "title")},
                    {"answer", answer_box(law_answer(results))},
                    {"law_summary", sentence_list(law_summary(results))},
                    {"engine_summary", sentence_list(engine_summary(results))},
                    {"maps", maps(folder, results.cells)},
                    {"kinds", kinds_table(results.cells)},
                    {"stacks", stacks_table(results.cells)},
                    {"pairs", pairs_table(json.at("disagreements"))},
                    {"engine_figure", drawn_figure(folder, "impact-laws.engines", "laws-engines-",
                                                   "How far every engine run is from either law")},
                    {"solvers", solvers_table(results.runs)},
                    {"states", states_table(results.runs, json.at("cases"))},
                    {"runs", runs_table(folder)},
                    {"suite", escaped_at(json, "suite_file")},
                    {"parameters", parameters},
                    {"definitions", definitions},
                    {"command", escaped_at(json, "command")},
                    {"environment", definition_list(facts_of(json.at("environment")))}});
}

}  // namespace

void write_impact_law_report(const fs::path& results, const Json& json) {
  const std::string text = content(results, read_law_results(results), json);
  write_file(results / "report.html", page(text_at(json, "title"), "report", text));
}

}  // namespace rockstack::plots
