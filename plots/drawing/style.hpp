#pragma once

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// How one series, an engine with its solver and settings, appears in every figure. It depends on nothing
/// but their names, so that a colour and a mark mean the same wherever they are.
struct Style {
  std::string colour;  ///< #rrggbb of the solver, dark enough for words on white
  int mark = 0;        ///< gnuplot's point type: open for defaults, filled for a set, else a cross of a kind
  std::string dash;    ///< gnuplot's dash type
};

/// The style of a run's series; its time step does not count.
Style style_of(const Run& run);

/// A colour, #rrggbb, of which white takes a part: 1 is the colour itself, 0 white.
std::string paler(const std::string& colour, double strength);

/// Style of the exact motion, which lies under all others.
inline constexpr auto exact_style = "with lines lw 5 lc rgb '#9A9A9A'";

/// Colour of the series that a panel shows in order to compare with its own.
inline constexpr auto context_colour = "#D4D4D4";

/// Style of the lines behind the data.
inline constexpr auto grid_lines = "set grid lt 1 dt solid lw 1 lc rgb '#E4E4E4'\n";

/// The plot element of a line at zero.
inline constexpr auto zero_line = "0 with lines lw 1.5 lc rgb '#000000' notitle";
inline constexpr auto tolerance_style = "lw 2 dt (5,8) lc rgb '#666666'";

/// "with …" for a run's curve: that of the exact motion, or linespoints with a few marks; `order` sets marks
/// of neighbouring curves apart.
std::string curve_style(const Run& run, std::size_t order);

/// "with points …" for a run's marks.
std::string mark_style(const Run& run, double size);

/// The model error of a fit as a line across the panel: dashed where bounds tell it from none, else dotted.
std::string floor_plot(const StepFit& fit, const std::string& colour);

}  // namespace rockstack::plots
