#pragma once

#include "plots/drawing/axes.hpp"
#include "plots/drawing/style.hpp"

namespace rockstack::plots {

// Curves and marks of runs over the same axes: few of them share a panel, many have a small one each.

/// The axes that series share.
struct SeriesPanel {
  std::string across, up;  ///< words of the axes
  std::string short_up;    ///< of small panels
  bool numbered = true;    ///< whether the one panel of few has numbers across, or another one below it
  PanelSettings axes;
  double height = 0, space = 16;        ///< of the one panel of few, and above it, pixels
  std::vector<std::string> under = {};  ///< drawn before all series
  std::vector<std::string> over = {};   ///< and after, in the one panel of few
  std::string few = {}, many = {};      ///< further settings of the one panel, and of small ones
  double left = left_edge;              ///< where panels begin, a share of the figure's width
  bool logarithmic = false;             ///< up
};

/// Whether runs, the exact one aside, are too many for one panel.
bool are_many(const std::vector<Run>& runs);

/// All of the exact curve, and of the others what lies within `room` times its span beyond it: an engine
/// whose blocks fall over or slide away must not flatten the rest. With a margin of `least` or more; one
/// curve a run.
Extent extent_of(const std::vector<Run>& runs, const std::vector<Curve>& curves, double room, double least);

/// Adds one panel, or where they are many a small one for each series that has one.
void add_series(Sheet& sheet, const SeriesPanel& panel, const std::vector<Series>& series, bool many);

/// Adds a panel, or many, of a curve a run, of those that have one; the exact one lies under all others,
/// wherever they are. Their data blocks begin with `stem`. In panels of their own those of engines are so
/// thick as `together` says, over those of others.
void add_curves(Sheet& sheet, const SeriesPanel& panel, const std::vector<Run>& runs,
                const std::vector<Curve>& curves, const std::string& stem,
                std::optional<double> together = {});

/// One of the panels of a grid, with a curve a run.
struct GridPanel {
  SeriesPanel panel;
  Extent up;  ///< of its linear axis
  std::vector<Curve> curves;
  std::string stem;  ///< of data blocks
};

/// So many panels of a grid, and more, are in two columns.
inline constexpr std::size_t two_columns = 4;

/// Adds panels under each other, or where they are enough in two columns, those of a column with one axis
/// across.
void add_grid(Sheet& sheet, std::vector<GridPanel> panels, const std::vector<Run>& runs);

/// Takes out variants of the exact run, the first of some runs with a curve each in all panels, that lie on
/// its curves. Returns their labels.
std::vector<std::string> take_out_hidden(std::vector<Run>& runs, std::vector<std::vector<Curve>*> panels);

/// The marks of a run, of a size; smaller where it has a panel of its own.
Series mark_series(const Run& run, const std::string& block, double size);

/// The plot of marks on logarithmic axes that others are seen before, by their first two numbers. Each is a
/// short line with round ends, as many of which are one path of a picture.
std::string context_marks(Sheet& sheet, const std::vector<std::vector<double>>& marks);

/// The line in the middle of the exact curve, over all others.
inline std::string exact_core(const std::string& block) {
  return plot_of(block, "with lines lw 1 lc rgb '#000000'");
}

/// The legend of runs, by "with …" of each; of many the exact one alone.
Legend legend_of(const std::vector<Run>& runs,
                 const std::function<std::string(const Run&, std::size_t)>& style);

/// What open and filled marks mean, where runs have both; else nothing.
std::string marks_note(const std::vector<Run>& runs);

/// A mark with a word, in pixels from a panel's lower left corner.
struct LabelledMark {
  double x = 0, y = 0;
  std::string word, colour;
};

/// Where a panel has labels beside its marks.
struct LabelledPanel {
  double width = 0, height = 0;                  ///< pixels
  std::vector<std::vector<LabelledMark>> lines;  ///< marks that a line joins in their order
  std::vector<LabelledMark> words = {};          ///< that stand there already, from their place to the right
};

/// gnuplot's commands for the words beside their marks: clear of lines where there is room, and left out
/// where labels or marks are in the way.
std::string placed_labels(const LabelledPanel& panel);

}  // namespace rockstack::plots
