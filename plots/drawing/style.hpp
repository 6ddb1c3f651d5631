#pragma once

#include <map>
#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

/// How one solver appears in every figure: its colour tells it on a screen, its mark and dash in grey.
struct Style {
  std::string colour;  ///< #rrggbb
  int mark = 0;        ///< gnuplot's point type with the inside left open; the filled one is the next
  std::string dash;    ///< gnuplot's dash type
  /// Settings of its runs in which single parameters differ from their set, in order.
  std::vector<std::string> changed = {};
};

/// A style for each solver of some runs, by solver_name().
using Styles = std::map<std::string, Style>;

/// Solvers that have a style of their own keep it in every comparison; others get spare ones in the order of
/// the runs.
Styles assign_styles(const std::vector<Run>& runs);

/// A tint for the band of patterns, pale enough for black letters; repeats after a while.
std::string pattern_tint(std::size_t index);

/// Of the exact motion, which lies under all others.
inline constexpr auto exact_style = "with lines lw 5 lc rgb '#9A9A9A'";

/// "with …" for a run's curve: that of the exact motion, or linespoints with a few marks; `order` sets marks
/// of neighbouring curves apart.
std::string curve_style(const Styles& styles, const Run& run, std::size_t order);

/// A line across the panel at the model error of a fit: dashed where the bounds tell it from none, dotted
/// where they do not, empty where it is none.
std::string floor_line(const Fit& fit, const std::string& colour);

/// gnuplot's point type for a solver with some settings: open for its defaults, filled for a set of its own,
/// a star, a cross or a plus by turns where single parameters differ from their set.
int mark_of(const Style& style, const std::string& settings);

/// The dash type of a line for some settings: dots for defaults, dashes of three kinds by turns where single
/// parameters differ from their set, else `whole`.
std::string dash_of(const Style& style, const std::string& settings, const std::string& whole);

/// "with points …", filled or open.
std::string mark_style(const Style& style, bool filled, double size);

}  // namespace rockstack::plots
