#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "comparisons/measures/results/csv.hpp"
#include "plots/drawing/maps.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/studies/sweep_facts.hpp"

namespace rockstack::plots {
namespace {

/// What may become of a stack, as columns of modes.csv.
const std::vector<MapKind>& mode_kinds() {
  static const std::vector<MapKind> list{{"rest", "#FFFFFF", "rest"},
                                         {"slide", "#FEE391", "slide"},
                                         {"rock", "#C6DBEF", "rock"},
                                         {"slide_rock", "#6A9FB5", "slide-rock"},
                                         {"free_flight", "#B9A3D0", "free flight"},
                                         {"topple", "#9E2A2B", "topple"},
                                         {"fall", "#F2A65A", "fall off"},
                                         {"failed", "#808080", "could not be solved"}};
  return list;
}

/// The columns of every kind; without a column of that name, as of ends that no motion begins with, zeros.
std::vector<std::vector<double>> mode_counts(const std::filesystem::path& file, const std::string& prefix) {
  const Table table = read_table(file);
  std::vector<std::vector<double>> list;
  for (const MapKind& kind : mode_kinds()) {
    const std::string name = std::string(kind.name) == "failed" ? "failed" : prefix + kind.name;
    const bool there = std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
    list.push_back(there ? read_columns(file, {name})[0] : std::vector<double>(table.rows.size(), 0));
  }
  return list;
}

/// "Of 3024 runs 610 rest, …", without what does not happen.
std::string answer(const std::vector<std::vector<double>>& counts) {
  constexpr std::array words{"rest", "slide", "rock", "slide and rock", "fly", "topple", "fall off", "fail"};
  double all = 0;
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double count = std::accumulate(counts[k].begin(), counts[k].end(), 0.0);
    all += count;
    if (count > 0) text += fmt::format("{}{:.0f} {}", text.empty() ? "" : ", ", count, words.at(k));
  }
  return fmt::format("Of {:.0f} runs {}", all, text);
}

}  // namespace

Drawings modes(const FolderSubject& subject) {
  const std::filesystem::path& results = subject.folder;
  const SweepFacts facts = sweep_facts(results);
  const std::filesystem::path file = results / "modes.csv";
  const auto places = read_columns(file, {"intensity", "friction"});
  if (places[0].empty()) return {{"", empty_sheet(facts.title, "There are no runs.")}};
  CellMap onset =
      cell_map("onset", counted_cells(places[0], places[1], mode_counts(file, "onset_")), mode_kinds());
  const auto motions = mode_counts(file, "");
  const CellMap whole = cell_map("whole", counted_cells(places[0], places[1], motions), mode_kinds());
  std::vector<bool> there = onset.there;
  for (std::size_t k = 0; k < there.size(); ++k) there[k] = there[k] || whole.there[k];
  Legend legend = map_legend(mode_kinds(), there);
  if (facts.struck) {
    const char* style = "with lines lw 3 lc rgb '#000000'";
    onset.data += fmt::format("$boundaries << END\n{}END\n",
                              initiation_boundaries(*facts.struck, onset.bounds.right, onset.bounds.high));
    onset.elements.push_back(fmt::format("$boundaries {} notitle", style));
    legend.emplace_back(style, "boundaries of Shenton 1996");
  }
  Sheet sheet = subject.sheet(facts.title, legend, answer(motions));
  sheet.data(onset.data + whole.data);
  constexpr double titles = 18;
  sheet.leave_room_above(titles);
  const std::string axes =
      map_axes(onset) + fmt::format("set xlabel {} noenhanced\n", in_quotes(facts.intensity));
  sheet.row(
      460, 0,
      {{axes + "set title 'onset' offset 0,-0.7\nset ylabel 'friction coefficient'\n", onset.elements},
       {axes + "set title 'whole motion' offset 0,-0.7\nset ylabel ''\nset format y ''\n", whole.elements}},
      2, left_edge);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
