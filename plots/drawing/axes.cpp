#include "plots/drawing/axes.hpp"

#include <fmt/core.h>

#include <numbers>

#include "plots/data/run_files.hpp"

namespace rockstack::plots {
namespace {

/// What stands between powers of ten where these alone are too few, from coarse to fine.
const std::vector<std::vector<double>> finer_multiples{
    {1, 3}, {1, 2, 5}, {1, 2, 3, 5, 7}, {1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6, 7, 8, 9}};

/// These multiples of powers of ten, as far as they lie between two values.
std::vector<double> between_decades(const std::vector<double>& multiples, double low, double high) {
  constexpr double rounding = 1e-9;
  std::vector<double> places;
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) <= high; ++power)
    for (const double times : multiples)
      if (const double place = times * std::pow(10, power);
          place >= low * (1 - rounding) && place <= high * (1 + rounding))
        places.push_back(place);
  return places;
}

/// The first and the last place whose numbers stay clear of the axis' ends and of each other, a number being
/// that share of the axis; else `fallback`.
std::vector<double> outermost(std::vector<double> places, double low, double high, double share,
                              const std::vector<double>& fallback) {
  const double margin = std::pow(high / low, share / 3);
  std::erase_if(places, [&](double place) { return place < low * margin || place > high / margin; });
  if (places.empty() || places.back() / places.front() < std::pow(high / low, share)) return fallback;
  return {places.front(), places.back()};
}

/// "2·10^{-3}", as gnuplot's enhanced text.
std::string in_decades(double value) {
  constexpr double rounding = 1e-9;
  const int power = static_cast<int>(std::floor(std::log10(value) + rounding));
  const double times = value / std::pow(10, power);
  return fmt::format("{}10^{{{}}}", times < 1 + rounding ? "" : fmt::format("{:.2g}·", times), power);
}

/// Numbers up the left edge in units of a power of ten, which stands in the panel's corner: with exponents of
/// their own they would push the axis' words out of the figure.
std::string tics_in_units(double low, double high, double step) {
  constexpr double rounding = 1e-9;
  const double power = std::floor(std::log10(std::max(std::abs(low), std::abs(high))) + rounding);
  const double unit = std::pow(10, power);
  std::vector<std::string> tics;
  for (double k = std::ceil(low / step - rounding); k <= high / step + rounding; ++k)
    tics.push_back(fmt::format("'{:.4g}' {}", k == 0 ? 0 : k * step / unit, plain(k * step)));
  return fmt::format(
      "set ytics ({})\nset label '×10^{{{:.0f}}}' at graph 0, graph 1 left offset 0.5,-0.9 front\n",
      joined_texts(tics, std::identity(), ", "), power);
}

bool is_across(const std::string& axis) {
  return axis.front() == 'x';
}

/// Between the numbers of an axis of that many pixels: 1, 2 or 5 times a power of ten.
double linear_step(const std::string& axis, double low, double high, double pixels) {
  const double room = is_across(axis) ? 70 : 30;  // of a number
  const double least = (high - low) * room / pixels;
  const double power = std::pow(10, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double times : {5.0, 2.0, 1.0})
    if (times * power >= least) step = times * power;
  return step;
}

constexpr auto shade = "#ECECEC";

/// The first time from which on no angle is further from its last than that, s.
double end_of_motion(const History& history, double tolerance) {
  if (history.size() == 0) return 0;
  const auto last = history.angles_at(history.size() - 1);
  const auto is_near = [&](double a, double b) { return !(std::abs(a - b) > tolerance); };
  std::size_t row = history.size();
  while (row > 0 && std::ranges::equal(history.angles_at(row - 1), last, is_near)) --row;
  return history.times[std::min(row, history.size() - 1)];
}

}  // namespace

std::string logarithmic_tics(const std::string& axis, double low, double high, double pixels) {
  const double room = is_across(axis) ? 75 : 26;  // of a number
  const auto most = static_cast<std::size_t>(std::max(2.0, pixels / room));
  constexpr std::size_t enough = 3;
  std::vector<double> chosen = between_decades({1}, low, high);
  if (chosen.size() >= enough) {
    const std::size_t stride = (chosen.size() + most - 1) / most;
    return fmt::format("set format {0} '10^{{%T}}'\nset {0}tics {1}, {2}\n{3}", axis, plain(chosen.front()),
                       plain(std::pow(10, static_cast<double>(stride))),
                       stride > 1 ? fmt::format("unset m{}tics\n", axis) : "");
  }
  for (const std::vector<double>& times : finer_multiples) {
    const std::vector<double> finer = between_decades(times, low, high);
    if (chosen.size() >= enough) break;
    if (finer.size() <= most)
      chosen = finer;
    else if (chosen.size() < 2)
      chosen = outermost(finer, low, high, room / pixels, chosen);
  }
  constexpr double overhang = 12;  // pixels by which a number at the end is too wide for a figure's edge
  if (is_across(axis))
    std::erase_if(chosen,
                  [&](double place) { return place > high / std::pow(high / low, overhang / pixels); });
  const auto tic = [](double place) { return fmt::format("'{}' {}", in_decades(place), plain(place)); };
  return fmt::format("set {}tics ({})\n", axis, joined_texts(chosen, tic, ", "));
}

std::string linear_tics(const std::string& axis, double low, double high, double pixels) {
  const double step = linear_step(axis, low, high, pixels);
  constexpr double least_plain = 1e-4, most_plain = 1e6;  // beyond them gnuplot's numbers have exponents
  if (axis == "y" && (step < least_plain || std::max(std::abs(low), std::abs(high)) >= most_plain))
    return tics_in_units(low, high, step);
  return fmt::format("set {}tics {}\n", axis, plain(step));
}

AngleUnit angle_unit(double largest, PrintStyle::Unit asked) {
  constexpr std::array units{AngleUnit{"rad", 1}, AngleUnit{"mrad", 1e3},
                             AngleUnit{"deg", 180 / std::numbers::pi}, AngleUnit{"µrad", 1e6}};
  constexpr double small = 0.01, tiny = 1e-5;
  if (asked != PrintStyle::Unit::automatic) return units.at(static_cast<std::size_t>(asked) - 1);
  return largest >= small || largest == 0 ? units[0] : largest >= tiny ? units[1] : units[3];
}

void scale(std::vector<Curve>& curves, double by) {
  for (Curve& curve : curves)
    for (double& value : curve.values) value *= by;
}

std::size_t longest_tic(double low, double high, double pixels) {
  const double step = linear_step("y", low, high, pixels);
  std::size_t longest = 0;
  for (double k = std::ceil(low / step); k <= std::floor(high / step); ++k)
    longest = std::max(longest, fmt::format("{:.6g}", k * step).size());
  return longest;
}

std::string linear_range(const std::string& axis, double low, double high, double pixels) {
  return fmt::format("set {}range [{}:{}]\n", axis, plain(low), plain(high)) +
         linear_tics(axis, low, high, pixels);
}

std::string logarithmic_range(const std::string& axis, double low, double high, double pixels) {
  return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\n", axis, plain(low), plain(high)) +
         logarithmic_tics(axis, low, high, pixels);
}

TimeAxis time_axis(const ComparedScene& scene, const std::vector<Run>& runs) {
  constexpr double room = 1.08, least = 1e-9;
  double tolerance = 0;
  if (const auto first = runs.empty() ? nullptr : history_of(runs.front()); first && !first->angles.empty()) {
    const auto [low, high] = std::ranges::minmax_element(first->angles);
    tolerance = 0.01 * (*high - *low);
  }
  double moves = 0, end = least;
  for (const Run& run : runs) {
    const auto history = history_of(run);
    moves = std::max(moves, end_of_motion(*history, tolerance));
    if (!history->times.empty()) end = std::max(end, history->times.back());
  }
  if (moves > 0) end = std::min(end, room * moves);
  return scene.horizon() < scene.duration ? TimeAxis{end, scene.horizon()} : TimeAxis{.end = end};
}

Curve thin(const Curve& curve, const TimeAxis& axis, std::size_t bins) {
  return thin(axis.begin > 0 ? from_time(curve, axis.begin) : curve, axis.end, bins);
}

std::string shade_beyond(const TimeAxis& axis) {
  if (!axis.is_shaded()) return "";
  return fmt::format(
      "set object rectangle from {}, graph 0 to graph 1, graph 1 fillcolor rgb '{}' fillstyle solid noborder "
      "behind\n",
      plain(axis.horizon), shade);
}

std::string time_range(const TimeAxis& axis, double room) {
  return fmt::format("set xrange [{}:{}]\n", plain(axis.begin), plain(room * axis.end)) + shade_beyond(axis);
}

void explain_shade(const TimeAxis& axis, Legend& legend) {
  if (axis.is_shaded())
    legend.emplace_back(fmt::format("with boxes fillstyle solid 1 noborder lc rgb '{}'", shade),
                        "beyond the horizon of predictability");
}

}  // namespace rockstack::plots
