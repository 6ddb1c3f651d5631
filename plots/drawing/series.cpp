#include "plots/drawing/series.hpp"

#include <fmt/core.h>

#include "plots/data/selection.hpp"

namespace rockstack::plots {
namespace {

constexpr auto exact_context = "with lines lw 3 lc rgb '#BDBDBD'";

void append(const std::vector<std::string>& from, std::vector<std::string>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

/// A rectangle in pixels that is taken by a mark, a word or a piece of a line.
struct Box {
  double left, right, low, high;

  bool meets(const Box& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

Box around(double x, double y, double half) {
  return {x - half, x + half, y - half, y + half};
}

bool meets_any(const Box& box, const std::vector<Box>& others) {
  return std::ranges::any_of(others, [&](const Box& other) { return box.meets(other); });
}

/// What lines pass through, as boxes beside each other.
std::vector<Box> line_boxes(const LabelledPanel& panel) {
  constexpr double step = 4, half = 2;
  std::vector<Box> boxes;
  for (const std::vector<LabelledMark>& line : panel.lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double across = line[i].x - line[i - 1].x, up = line[i].y - line[i - 1].y;
      const int parts = 1 + static_cast<int>(std::hypot(across, up) / step);
      for (int part = 0; part <= parts; ++part)
        boxes.push_back(
            around(line[i - 1].x + across * part / parts, line[i - 1].y + up * part / parts, half));
    }
  return boxes;
}

constexpr double half_height = 8;  ///< of a word

double width_of(const LabelledMark& mark) {
  return 9.5 * static_cast<double>(mark.word.size()) + 4;
}

/// Where a label stands: at the first of four corners of a mark that is free of all boxes.
std::optional<Box> free_corner(const LabelledPanel& panel, const LabelledMark& mark,
                               const std::vector<Box>& taken, const std::vector<Box>& lines) {
  const double width = width_of(mark);
  constexpr double aside = 11, rise = 12;
  for (const double side : {1.0, -1.0})
    for (const double lift : {rise, -rise}) {
      const double near = mark.x + side * aside, far = near + side * width;
      const Box box{std::min(near, far), std::max(near, far), mark.y + lift - half_height,
                    mark.y + lift + half_height};
      const bool inside = box.left > 0 && box.right < panel.width && box.low > 0 && box.high < panel.height;
      if (inside && !meets_any(box, taken) && !meets_any(box, lines)) return box;
    }
  return std::nullopt;
}

/// What one panel of few series is set to, but for the words along its left edge.
std::string few_settings(const SeriesPanel& panel, double width) {
  return "set format x '%g'\n" + panel.axes(width, panel.height) +
         (panel.numbered ? fmt::format("set xlabel {}\n", in_quotes(panel.across))
                         : without_horizontal_labels);
}

/// All words where the panel is high enough for them.
const std::string& words_up(const Sheet& sheet, const SeriesPanel& panel) {
  constexpr double letter = 10.5;  // pixels
  const bool fits = letter * static_cast<double>(panel.up.size()) < panel.height;
  return sheet.width() == full_width || (sheet.printed() && fits) ? panel.up : panel.short_up;
}

/// The series of runs that have a curve, which the sheet tells.
std::vector<Series> curve_series(Sheet& sheet, const SeriesPanel& panel, const std::vector<Run>& runs,
                                 const std::vector<Curve>& curves, const std::string& stem,
                                 std::optional<double> together) {
  std::vector<Series> series;
  DrawnPanel drawn{panel.across, panel.up, panel.logarithmic};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].size() == 0) continue;
    const std::string name = fmt::format("{}_{}", stem, i), colour = style_of(runs[i]).colour;
    sheet.data(data_block(name, curves[i]));
    drawn.curves.push_back({run_label(runs[i]), colour, curves[i]});
    // Marks of neighbours are set apart by their order.
    Series& one =
        series.emplace_back(Series{line_label(runs[i]), colour, {plot_of(name, curve_style(runs[i], i))}});
    if (runs[i].exact())
      one.context = {plot_of(name, exact_context)};
    else
      one.alone = {
          plot_of(name, fmt::format("with lines lw {} lc rgb '{}'", together.value_or(1.5), colour))};
    if (together && !runs[i].exact())
      one.context = {plot_of(name, fmt::format("with lines lw 1 lc rgb '{}'", context_colour))};
  }
  sheet.tell(std::move(drawn));
  return series;
}

constexpr double grid_gap = 22, words_middle = 16;  ///< pixels

/// How the panels of a grid stand, pixels.
struct Grid {
  std::size_t columns;
  double left;  ///< of each column, for numbers and words
  double width, height;

  Grid(const std::vector<GridPanel>& panels, double whole) : columns(panels.size() < two_columns ? 1 : 2) {
    constexpr double lowest = 140, highest = 420;
    const double count = static_cast<double>(columns), shape = columns == 1 && panels.size() > 1 ? 0.4 : 0.6;
    const double no_higher = std::clamp(shape * whole / count, lowest, highest);
    std::size_t letters = 1;
    for (const GridPanel& panel : panels)
      letters = std::max(letters, longest_tic(panel.up.low, panel.up.high, no_higher));
    left = 48 + 10.5 * static_cast<double>(letters);
    width = (whole - full_width * (1 - right_edge) - count * left) / count;
    height = std::clamp(shape * width, lowest, highest);
  }
};

}  // namespace

bool are_many(const std::vector<Run>& runs) {
  return static_cast<std::size_t>(std::ranges::count_if(runs, [](const Run& run) { return !run.exact(); })) >
         most_series;
}

Extent extent_of(const std::vector<Run>& runs, const std::vector<Curve>& curves, double room, double least) {
  Extent all, exact;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (const double value : curves[i].values) {
      all.add(value);
      if (runs[i].exact()) exact.add(value);
    }
  if (const double span = exact.high - exact.low; span > least)
    all = {std::max(all.low, exact.low - room * span), std::min(all.high, exact.high + room * span)};
  if (all.low > all.high) all = {0, 0};
  return all.wider(std::max(0.08 * (all.high - all.low), least));
}

void add_series(Sheet& sheet, const SeriesPanel& panel, const std::vector<Series>& series, bool many) {
  std::vector<std::string> plots = panel.under;
  if (!many) {
    for (const Series& one : series) append(one.plots, plots);
    append(panel.over, plots);
    const double width = sheet.width();
    sheet.row(panel.height, panel.space,
              {{few_settings(panel, sheet.panel_width()) +
                    fmt::format("set ylabel {} noenhanced offset 0.5\n", in_quotes(words_up(sheet, panel))) +
                    panel.few,
                plots}},
              1, panel.left * full_width / width);
    return;
  }
  std::vector<Series> shown = series;
  std::erase_if(shown, [](const Series& one) { return one.alone.empty(); });
  for (const Series& one : series) append(one.context, plots);
  const auto settings = [&](double width, double height) { return panel.axes(width, height) + panel.many; };
  add_multiples(sheet, shown, plots, settings, panel.across, panel.short_up, panel.left);
}

void add_curves(Sheet& sheet, const SeriesPanel& panel, const std::vector<Run>& runs,
                const std::vector<Curve>& curves, const std::string& stem, std::optional<double> together) {
  add_series(sheet, panel, curve_series(sheet, panel, runs, curves, stem, together), are_many(runs));
}

void add_grid(Sheet& sheet, std::vector<GridPanel> panels, const std::vector<Run>& runs) {
  const Grid grid(panels, sheet.width());
  for (std::size_t from = 0; from < panels.size(); from += grid.columns) {
    std::vector<SidePanel> cells;
    for (std::size_t i = from; i < std::min(from + grid.columns, panels.size()); ++i) {
      SeriesPanel& panel = panels[i].panel;
      panel.height = grid.height;
      panel.numbered = i + grid.columns >= panels.size();
      std::vector<std::string> plots = panel.under;
      for (const Series& one : curve_series(sheet, panel, runs, panels[i].curves, panels[i].stem, {}))
        append(one.plots, plots);
      append(panel.over, plots);
      // Words stand in one line, whatever the numbers beside them.
      cells.push_back(
          {few_settings(panel, grid.width) +
               fmt::format(
                   "unset ylabel\nset label 3 {} noenhanced rotate by 90 at graph {}, graph 0.5 center\n",
                   in_quotes(panel.short_up), plain((words_middle - grid.left) / grid.width)),
           plots});
    }
    sheet.row(grid.height, grid_gap, cells, grid.columns, grid.left / sheet.width(),
              grid.left / sheet.width());
  }
}

std::vector<std::string> take_out_hidden(std::vector<Run>& runs, std::vector<std::vector<Curve>*> panels) {
  constexpr double line = 2e-3;  // how thick one is, as a share of a panel
  std::vector<std::string> labels;
  for (std::size_t i = runs.size(); i-- > 1;) {
    const auto hides = [&](const std::vector<Curve>* curves) {
      return lies_on((*curves)[i], curves->front(), line);
    };
    const auto shows = [&](const std::vector<Curve>* curves) {
      return (*curves)[i].size() > 0 && curves->front().size() > 0;
    };
    const bool hidden = std::ranges::any_of(panels, shows) && std::ranges::all_of(panels, hides);
    if (!runs.front().exact() || !runs[i].is_variant() || !hidden) continue;
    labels.push_back(run_label(runs[i]));
    const auto at = static_cast<std::ptrdiff_t>(i);
    runs.erase(runs.begin() + at);
    for (std::vector<Curve>* curves : panels) curves->erase(curves->begin() + at);
  }
  return labels;
}

Series mark_series(const Run& run, const std::string& block, double size) {
  return {line_label(run),
          style_of(run).colour,
          {plot_of(block, mark_style(run, size))},
          {plot_of(block, mark_style(run, 1.1))},
          {plot_of(block, fmt::format("with points pt 7 ps 0.6*mark lc rgb '{}'", context_colour))}};
}

std::string context_marks(Sheet& sheet, const std::vector<std::vector<double>>& marks) {
  constexpr double end = 1.001;
  std::string text = "$all << END\n";
  for (const std::vector<double>& mark : marks)
    text += fmt::format("{:.6g} {:.6g}\n{:.6g} {:.6g}\n\n", mark[0], mark[1], end * mark[0], mark[1]);
  sheet.data(text + "END\n");
  return plot_of("all", fmt::format("with lines lw 4 lc rgb '{}'", context_colour));
}

Legend legend_of(const std::vector<Run>& runs,
                 const std::function<std::string(const Run&, std::size_t)>& style) {
  Legend legend;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (runs[i].exact() || !are_many(runs)) legend.emplace_back(style(runs[i], i), run_label(runs[i]));
  return legend;
}

std::string marks_note(const std::vector<Run>& runs) {
  const auto have = [&](const char* settings) {
    return std::ranges::find(runs, settings, &Run::settings) != runs.end();
  };
  return have("default") && have("tuned") ? "filled marks: tuned settings; open marks: defaults" : "";
}

std::string placed_labels(const LabelledPanel& panel) {
  constexpr double half_mark = 7;
  std::vector<Box> taken;
  for (const std::vector<LabelledMark>& line : panel.lines)
    for (const LabelledMark& mark : line) taken.push_back(around(mark.x, mark.y, half_mark));
  for (const LabelledMark& word : panel.words)
    taken.push_back({word.x, word.x + width_of(word), word.y - half_height, word.y + half_height});
  const std::vector<Box> crossed = line_boxes(panel);
  std::string text;
  for (const std::vector<LabelledMark>& line : panel.lines)
    for (const LabelledMark& mark : line) {
      std::optional<Box> box = free_corner(panel, mark, taken, crossed);
      if (!box) box = free_corner(panel, mark, taken, {});
      if (!box) continue;
      const bool right = box->left > mark.x;
      taken.push_back(*box);
      text += fmt::format("set label '{}' at graph {}, graph {} {} font ',11' textcolor rgb '{}' front\n",
                          mark.word, plain((right ? box->left : box->right) / panel.width),
                          plain((box->low + box->high) / 2 / panel.height), right ? "left" : "right",
                          mark.colour);
    }
  return text;
}

}  // namespace rockstack::plots
