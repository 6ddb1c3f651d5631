#pragma once

#include <fmt/core.h>

#include "comparisons/measures/results/print_style.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/series.hpp"

namespace rockstack::plots {

struct Figure;

/// How many pixels are an inch on paper where the letters of axes have a style's size there: they are drawn
/// in 14 pt of a screen, 96 dots an inch.
inline double pixels_per_inch(const PrintStyle& style) {
  return 14 * 96 / style.font_size;
}

/// The smallest letters of a style, in points of a screen: 6 pt on paper, in SVG as well, whose letters are
/// smaller by a sixteenth; or those of axes where these are smaller.
inline double least_size(const PrintStyle& style) {
  constexpr double least = 6 * 16.0 / 15;
  return 14 * std::min(1.0, least / style.font_size);
}

/// How wide a figure for print is, pixels.
inline double print_width(const PrintStyle& style) {
  constexpr double millimetres = 25.4;
  return style.width / millimetres * pixels_per_inch(style);
}

/// What any figure is drawn as.
struct Subject {
  const Figure& figure;
  const PrintStyle* print = nullptr;  ///< where it is for print

  /// A sheet with a title, the figure's question and the answer; in print of the style's width, without
  /// question and answer, and with a title where the style has titles.
  Sheet sheet(const std::string& heading, const Legend& legend, const std::string& answer,
              double width = full_width) const;
  /// How high a panel is, pixels, that is `usual` on a page.
  double height(double usual) const {
    return print == nullptr ? usual : std::min(usual, 0.62 * (print_width(*print) - narrow_left));
  }
  /// The unit of angles up to a size, rad.
  AngleUnit unit(double largest) const {
    return angle_unit(largest, print == nullptr ? PrintStyle::Unit::automatic : print->unit);
  }
};

/// What a figure of one scene is drawn of.
struct SceneSubject : Subject {
  const Comparison& comparison;
  const ComparedScene& scene;
  bool on_slide = false;  ///< whether a slide shows it: without words above, in large letters

  /// A sheet with the scene's title, the figure's question and the answer.
  Sheet sheet(const Legend& legend, const std::string& answer) const;
  /// The scene's title over the reason why there is nothing to show.
  Drawing nothing(const std::string& reason) const { return empty_sheet(scene.heading, reason); }

  /// The exact run and the engines' runs that figures over time show, these only with all of some files.
  RunSelection shown(const std::vector<std::string>& files = {}) const;
  /// An axis as far as it is asked for. @throws InputError where that begins behind its end.
  TimeAxis asked(TimeAxis axis) const;
  /// The time that some motions take, as far as it is asked for.
  TimeAxis time_axis(const std::vector<Run>& runs) const { return asked(plots::time_axis(scene, runs)); }
  /// And what its shade means as an entry of the legend.
  TimeAxis time_axis(const std::vector<Run>& runs, Legend& legend) const;
  /// How high a panel is, pixels, that is `usual` where all panels together are `all`.
  double height(double usual, double all) const {
    return on_slide ? usual / all * slide_panels : Subject::height(usual);
  }
};

/// What a figure of all scenes of a comparison is drawn of.
struct ComparisonSubject : Subject {
  const Comparison& comparison;
};

/// What a figure of a folder that is no comparison is drawn of.
struct FolderSubject : Subject {
  const fs::path& folder;
  double width = full_width;  ///< pixels

  /// A sheet with a title, the figure's question and the answer, or of a narrow one the legend alone.
  Sheet sheet(const std::string& heading, const Legend& legend, const std::string& answer) const;
  /// Whether its curves are told as numbers: once of a figure that a page has wide and narrow.
  bool tells() const { return print != nullptr || width == full_width; }
};

/// By what stands behind the figure's name in that of its file; a single drawing has nothing there.
using Drawings = std::map<std::string, Drawing>;

/// The part that stands in the place of the single drawing on a narrow screen.
inline constexpr auto narrow_part = "narrow";

/// What a figure has besides: whether it is drawn once more, as narrow as narrow_width; whether it is drawn
/// for print alone; and which keys of a style have a meaning for it.
enum Trait : unsigned { narrow = 1, print_alone = 2, over_time = 4, in_angles = 8, of_panels = 16 };

struct SceneFigure {
  Drawing (*draw)(const SceneSubject&);
  bool (*needs)(const ComparedScene&);  ///< whether a scene's results have what it shows
  unsigned traits = 0;
};

struct ComparisonFigure {
  Drawings (*draw)(const ComparisonSubject&);
  unsigned traits = 0;
};

struct FolderFigure {
  Drawings (*draw)(const FolderSubject&);
  const char* needs;  ///< a table of results, as table_file() finds it, or another file
  unsigned traits = 0;
};

/// One kind of figure.
struct Figure {
  std::string name;         ///< part of the file's name
  std::string title;        ///< heading on a page
  std::string question;     ///< that it answers
  std::string explanation;  ///< how to read it
  std::variant<SceneFigure, ComparisonFigure, FolderFigure> of;

  bool has(Trait trait) const {
    return std::visit([&](const auto& one) { return (one.traits & trait) != 0; }, of);
  }
};

/// All figures, in the order of pages.
const std::vector<Figure>& figures();

/// The figures that a scene's results have data for; on pages, or in print.
std::vector<const Figure*> figures_of(const ComparedScene& scene, bool in_print = false);

/// The figure that a file is of, by its name without folder and ending; null where nobody draws such a file.
const Figure* figure_in(const std::string& stem);

/// Where a figure of a scene lies, without .png, .svg or .pdf.
inline fs::path figure_stem(const fs::path& results, const ComparedScene& scene, const Figure& figure) {
  return results / "figures" / (scene.alone ? figure.name : scene.name + "." + figure.name);
}

/// Draws all figures of a comparison, or of one motion, as results/figures/<scene>.<figure>.png, .svg and
/// .pdf.
/// @throws InputError naming the file that is missing or malformed; std::runtime_error where gnuplot fails.
void draw_figures(const fs::path& results, const Comparison& comparison);

/// Draws the figures of what is neither, whose files are there, as results/figures/<figure>.png, .svg and
/// .pdf.
void draw_figures(const fs::path& results);

/// What has been drawn for print.
struct PrintedFigures {
  std::vector<fs::path> stems;        ///< without .pdf, .svg, .png or .csv
  std::vector<std::string> left_out;  ///< with the reasons
};

/// Draws the figures of a folder for print as results/paper/<figure>.pdf and the like: those that the style
/// names, or all for which what it asks has a meaning.
/// @throws InputError with what there is, where there is no such figure or panel, or nothing of the time
/// asked for.
PrintedFigures print_figures(const fs::path& results, const PrintStyle& style);

/// Draws those that the suite of some results asks for, if any.
PrintedFigures print_figures(const fs::path& results, const Comparison& comparison);

// What figures are drawn with besides the skeletons of plots/drawing.

/// The exact run, where there is one, before those of the engines.
inline std::vector<Run> all_runs(const RunSelection& shown) {
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  return runs;
}

/// The marks of runs, of a size; of too many for one panel nothing.
inline Legend mark_legend(const std::vector<Run>& runs, double size) {
  return legend_of(runs, [&](const Run& run, std::size_t) { return mark_style(run, size); });
}

/// Ranges and numbers of a panel over two logarithmic axes, by its width and height in pixels.
std::function<std::string(double, double)> logarithmic_axes(const Extent& across, const Extent& up);

/// Lines of numbers as a data block that plot commands call $name.
using Numbers = std::vector<std::vector<double>>;
std::string number_block(const std::string& name, const Numbers& lines);

/// A column of such lines over the first, as tables of figures have it.
DrawnCurve drawn_curve(const std::string& words, const Numbers& lines, std::size_t column = 1);

/// Plot elements, each of data blocks of its own.
class Plots {
 public:
  /// `stem` begins the names of the blocks.
  Plots(Sheet& sheet, std::string stem) : sheet_(sheet), stem_(std::move(stem)) {}
  /// Draws lines of numbers once a style, "using 1:2 with …".
  void add(const Numbers& lines, const std::vector<std::string>& styles);
  const std::vector<std::string>& list() const { return list_; }

 private:
  Sheet& sheet_;
  std::string stem_;
  std::vector<std::string> list_;
};

/// Words beside whole numbers from `first` on, or down where `step` is −1, as in "set ytics (…)".
std::string word_tics(const std::vector<std::string>& words, int first = 0, int step = 1);

/// The settings of the panel over time that has the numbers of those above it.
inline constexpr auto time_numbers = "set format x '%g'\nset xlabel 'time (s)'\n";

}  // namespace rockstack::plots
