#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plots/drawing/gnuplot.hpp"
#include "plots/drawing/thinning.hpp"

namespace rockstack::plots {

/// Text as a gnuplot string, to be drawn with `noenhanced`: in single quotes, within which gnuplot runs no
/// commands and expands no macros, joined by quotes in double ones, since it loses one doubled at the front.
std::string in_quotes(const std::string& text);

/// A number that gnuplot reads, eight digits.
std::string plain(double value);

/// Lines of a data block that plot commands call $name.
std::string data_block(const std::string& name, const Curve& curve);

/// One entry of a legend: a gnuplot style ("with lines …") and its words.
using Legend = std::vector<std::pair<std::string, std::string>>;

/// A figure that grows downwards: title and legend first, then panels that share their left and right edges.
class Sheet {
 public:
  Sheet(const std::string& title, const Legend& legend);

  /// Adds a panel of that many pixels, `gap` pixels under the last; `settings` are gnuplot commands, each on
  /// a line of its own, `plots` the plot command's elements. An empty list of elements draws the bare frame.
  void panel(double height, double gap, const std::string& settings, const std::vector<std::string>& plots);

  /// Adds a line of words in a colour, #rrggbb, under the last panel's axis.
  void note(const std::string& text, const std::string& colour) { notes_.emplace_back(text, colour); }

  void data(const std::string& block) { blocks_ += block; }

  /// The drawing with room for the last panel's axis label. Precondition: there is a panel.
  Drawing finish() const;

 private:
  struct Panel {
    double top, bottom;  ///< pixels from the figure's top edge
    std::string settings, plots;
  };

  double below_ = 0;  ///< pixels used so far
  std::string title_, blocks_;
  Legend legend_;
  std::vector<Panel> panels_;
  std::vector<std::pair<std::string, std::string>> notes_;  ///< with their colours
};

/// Numbers along a logarithmic axis, "x" or "y": powers of ten, or where there are too few of them 1, 2 and 5
/// times each.
std::string logarithmic_tics(const std::string& axis, double low, double high);

/// Settings of a panel whose horizontal axis is labelled in the panel under it.
std::string without_horizontal_labels();

/// A sheet with one frame that says why there is nothing to show.
Drawing empty_sheet(const std::string& title, const std::string& text);

/// "θ₁" for block 1.
std::string angle_name(int block);

/// Height in pixels of one of `blocks` panels of equal size.
double panel_height(int blocks);

/// How many bins of time a curve may have where that many curves share a figure, so that its file stays
/// small.
std::size_t bins_for(std::size_t curves);

}  // namespace rockstack::plots
