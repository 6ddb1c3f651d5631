#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr std::array colours{"#000000", "#0072B2", "#C04A00", "#117733",
                             "#882255", "#806600", "#332288", "#AA4499"};

/// A row of branches.csv and its motion. Numbers that it does not have are NaN.
struct BranchRow {
  double parent, start, like, like_from, end;
  std::string takes, words;  ///< words: how it ends
  History history;
};

std::string end_words(const CsvLine& line) {
  if (line.text("like").empty()) return line.text("ends");
  return fmt::format("{}, {} {}", line.text("ends"),
                     line.text("mirrored") == "true" ? "mirror image of" : "as", line.text("like"));
}

std::vector<BranchRow> read_branches(const fs::path& folder) {
  std::vector<BranchRow> rows;
  for (CsvLine line(folder / "branches.csv"); line.next();)
    rows.push_back({line.value("parent"), line.value("time"), line.value("like"), line.value("like_from"),
                    line.value("end_time"), line.text("takes"), end_words(line),
                    read_history(rows.empty() ? folder : folder / "branches" / line.text("branch"))});
  return rows;
}

std::string colour_of(std::size_t branch) {
  return colours.at(branch % colours.size());
}

/// An angle from where the branch starts.
Numbers angle_of(const BranchRow& row, int block, double end, std::size_t bins) {
  Curve curve;
  for (std::size_t i = 0; i < row.history.size(); ++i)
    if (!(row.history.times[i] < row.start))
      curve.add(row.history.times[i], row.history.angles_at(i)[static_cast<std::size_t>(block)]);
  const Curve thinned = thin(curve, end, bins);
  Numbers lines;
  for (std::size_t i = 0; i < thinned.size(); ++i) lines.push_back({thinned.times[i], thinned.values[i]});
  return lines;
}

/// A line a branch, down from that of its parent, broken where it is like another one.
void add_tree(Sheet& sheet, const std::vector<BranchRow>& rows, const std::string& range) {
  Plots tree(sheet, "tree");
  std::string labels;
  const auto label = [&](const std::string& words, double time, double row, const std::string& place) {
    labels += fmt::format("set label {} at {}, {} {} noenhanced\n", in_quotes(words), plain(time), plain(row),
                          place);
  };
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BranchRow& row = rows[i];
    const auto level = static_cast<double>(i + 1);
    const double start = std::isnan(row.start) ? 0 : row.start;
    const double own_end = std::isnan(row.like_from) ? row.end : std::clamp(row.like_from, start, row.end);
    const std::string line = fmt::format("using 1:2 with lines lc rgb '{}' lw ", colour_of(i));
    if (!std::isnan(row.parent)) tree.add({{start, row.parent}, {start, level}}, {line + "1.5"});
    if (own_end > start) tree.add({{start, level}, {own_end, level}}, {line + "3"});
    if (row.end > own_end) tree.add({{own_end, level}, {row.end, level}}, {line + "3 dt (4,4)"});
    label(row.words, row.end, level, "left offset 0.6,0");
    if (!row.takes.empty()) label(row.takes, start, level, "left offset 0.4,0.55");
    numbers.push_back(fmt::format("branch {}", i + 1));
  }
  const auto size = static_cast<double>(rows.size());
  sheet.panel(34 * (size + 0.4), 16,
              range + time_numbers + labels +
                  fmt::format("set yrange [{}:0.3]\nset ytics ({})\n", size + 0.7, word_tics(numbers, 1)),
              tree.list());
}

}  // namespace

Drawings branches(const FolderSubject& subject) {
  const std::vector<BranchRow> rows = read_branches(subject.folder);
  Legend legend;
  for (std::size_t i = 0; i < std::min(rows.size(), colours.size()); ++i)
    legend.emplace_back(fmt::format("with lines lw 3 lc rgb '{}'", colour_of(i)),
                        fmt::format("branch {}", i + 1));
  const auto unlike = std::ranges::count_if(rows, [](const BranchRow& row) { return std::isnan(row.like); });
  Sheet sheet =
      subject.sheet(read_json(subject.folder / "summary.json").at("title"), legend,
                    fmt::format("{} branches, {} of them unlike all before them", rows.size(), unlike));
  constexpr double room = 1.2;  // of time, for words behind the end
  double end = 0;
  for (const BranchRow& row : rows) end = std::max(end, row.end);
  const std::string range = fmt::format("set xrange [0:{}]\n", plain(room * (end > 0 ? end : 1)));
  const int blocks = rows.front().history.blocks;
  const std::size_t bins = bins_for(rows.size() * static_cast<std::size_t>(blocks));
  for (int k = 0; k < blocks; ++k) {
    Plots angles(sheet, fmt::format("angle_{}", k));
    DrawnPanel told{"time (s)", angle_name(k + 1) + " (rad)"};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Numbers angle = angle_of(rows[i], k, end, bins);
      angles.add(angle, {fmt::format("using 1:2 with lines lw 2 lc rgb '{}'", colour_of(i))});
      told.curves.push_back(drawn_curve(fmt::format("branch {}", i + 1), angle));
      told.curves.back().colour = colour_of(i);
    }
    sheet.tell(std::move(told));
    sheet.panel(subject.height(panel_height(blocks + 1)), 26,
                range + without_horizontal_labels + grid_lines +
                    fmt::format("set ylabel '{} (rad)' offset 0.5\n", angle_name(k + 1)),
                angles.list());
  }
  add_tree(sheet, rows, range);
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
