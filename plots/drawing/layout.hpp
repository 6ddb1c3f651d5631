#pragma once

#include "plots/drawing/panel.hpp"

namespace rockstack::plots {

/// A number that gnuplot reads, eight digits.
std::string plain(double value);

/// Lines of a data block that plot commands call $name.
std::string data_block(const std::string& name, const Curve& curve);

/// An element of a plot command: the first two columns of a data block.
inline std::string plot_of(const std::string& block, const std::string& style) {
  return "$" + block + " using 1:2 " + style + " notitle";
}

/// How wide a letter of an axis is on paper, pixels.
inline constexpr double printed_letter = 11.2;

/// Lines of words as one gnuplot string.
std::string joined_lines(const std::vector<std::string>& lines);

/// How wide a figure is, pixels: on a page as wide as a desk's screen, there with a player beside it, and on
/// one as wide as a phone's; and on a slide, which leaves all panels together so many pixels up.
inline constexpr double full_width = 1200, shared_width = 960, narrow_width = 480, slide_width = 860,
                        slide_panels = 215;

/// Where panels begin and end, shares of the figure's width, unless a row or second axes say otherwise.
inline constexpr double left_edge = 0.105, right_edge = 0.975;

/// What panels narrower than a page's leave to their left for the words of their axis, pixels.
inline constexpr double narrow_left = 112;

/// A figure that grows downwards: title, the question that it answers and legend first, then panels that
/// share their left and right edges.
class Sheet {
 public:
  /// Question and answer, "How …? …", have a line each; without title or question there is no room for them.
  /// `paper`: how it is printed.
  Sheet(const std::string& title, const Legend& legend, const std::string& question = "",
        double width = full_width, const Paper& paper = {});

  double width() const { return width_; }  ///< pixels
  bool printed() const { return paper_.alone; }
  double least() const { return paper_.least; }  ///< size of letters, in points of a screen
  /// Where panels end, a share of the width: as many pixels from the edge in any.
  double right() const { return right_; }
  double panel_width() const { return 1056 - (full_width - width_); }  ///< of one that goes across, pixels

  /// Adds a panel of that many pixels, `gap` pixels under the last; `settings` are gnuplot commands, each on
  /// a line of its own, `plots` the plot command's elements. An empty list of elements draws the bare frame.
  void panel(double height, double gap, const std::string& settings, const std::vector<std::string>& plots);

  /// Adds panels side by side, as wide as one of `columns`, from `left` on and `between` apart, shares of the
  /// figure's width.
  void row(double height, double gap, const std::vector<SidePanel>& cells, std::size_t columns, double left,
           double between = 0.03);

  /// Leaves room above the next panel, pixels.
  void leave_room_above(double height) { below_ += height; }

  /// Leaves room for a second axis along the right edge of all panels that follow.
  void leave_room_beside() { right_ -= 84 / width_; }

  /// Adds a line of words, if any, in a colour, #rrggbb, under the last panel's axis.
  void note(const std::string& text, const std::string& colour = "#000000") {
    if (!text.empty()) notes_.emplace_back(text, colour);
  }

  void data(const std::string& block) { blocks_ += block; }

  /// Tells the curves of a panel as numbers.
  void tell(DrawnPanel panel) { drawn_.push_back(std::move(panel)); }

  /// The drawing with room for the last panel's axis label. Precondition: there is a panel.
  Drawing finish() const;

 private:
  struct Panel {
    double top, bottom;  ///< pixels from the figure's top edge
    double left, right;  ///< shares of the figure's width
    SidePanel cell;
  };

  std::vector<DrawnPanel> numbers() const;

  double below_ = 0;  ///< pixels used so far
  double width_, right_;
  std::vector<std::string> title_, question_;
  std::string blocks_;
  Legend legend_;
  std::vector<Panel> panels_;
  std::vector<DrawnPanel> drawn_;
  Paper paper_;
  std::vector<std::pair<std::string, std::string>> notes_;  ///< with their colours
};

/// What is drawn of a run.
struct Series {
  std::string words, colour;              ///< of its own small panel
  std::vector<std::string> plots = {};    ///< where few share a panel
  std::vector<std::string> alone = {};    ///< in a panel of its own
  std::vector<std::string> context = {};  ///< where each has a panel, in all of them
};

/// How many series one panel bears; more of them have a panel each.
inline constexpr std::size_t most_series = 6;

/// The size of their panels, pixels.
inline constexpr double multiple_width = 328, multiple_height = 160, multiples_apart = 0.03;

/// Ranges and numbers of a panel of that width and height in pixels.
using PanelSettings = std::function<std::string(double, double)>;

/// Adds a panel for each series, three in a row or as many as there are or have room from `left` on, over
/// `context`, which all of them show. `settings` are of every panel, `across` and `up` the words of the axes.
void add_multiples(Sheet& sheet, const std::vector<Series>& series, const std::vector<std::string>& context,
                   const PanelSettings& settings, const std::string& across, const std::string& up,
                   double left = left_edge);

/// How far from a whole number, of an impact or a row, a series stands, so that series do not hide each
/// other: nought where each has a panel of its own.
inline double aside(std::size_t series, std::size_t of) {
  constexpr double room = 0.6;
  return of > most_series ? 0 : room * ((static_cast<double>(series) + 0.5) / static_cast<double>(of) - 0.5);
}

/// Settings of a panel whose horizontal axis is labelled in the panel under it.
inline const std::string without_horizontal_labels =
    std::string("set xtics textcolor rgb '") + unseen + "'\nunset xlabel\n";

/// A sheet with one frame that says why there is nothing to show.
Drawing empty_sheet(const std::string& title, const std::string& text);

/// "₁" for 1.
std::string subscript(int number);

/// "θ₁" for block 1.
std::string angle_name(int block);

/// Height in pixels of one of `blocks` panels of equal size.
inline double panel_height(int blocks) {
  return std::clamp(780.0 / blocks, 110.0, 420.0);
}

/// How many bins of time a curve may have where so many share a figure, so that its file stays small.
inline std::size_t bins_for(std::size_t curves) {
  constexpr std::size_t points = 10000, most = 500, fewest = 30;
  return std::clamp(points / (2 * std::max<std::size_t>(curves, 1)), fewest, most);
}

}  // namespace rockstack::plots
