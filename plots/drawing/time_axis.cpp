#include "plots/drawing/time_axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "plots/data/run_files.hpp"

namespace rockstack::plots {
namespace {

constexpr auto shade = "#ECECEC";
constexpr double small_part = 0.01;

/// How far apart the least and the greatest of all angles are, rad.
double range_of(const History& history) {
  if (history.angles.empty()) return 0;
  const auto [low, high] = std::minmax_element(history.angles.begin(), history.angles.end());
  return *high - *low;
}

/// The first time from which on no angle is further from its last than that, s.
double end_of_motion(const History& history, double tolerance) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  std::size_t row = history.size();
  const auto rests = [&](std::size_t at) {
    for (std::size_t k = 0; k < blocks; ++k)
      if (std::abs(history.angles[at * blocks + k] - history.angles[(history.size() - 1) * blocks + k]) >
          tolerance)
        return false;
    return true;
  };
  while (row > 0 && rests(row - 1)) --row;
  return history.size() == 0 ? 0 : history.times[std::min(row, history.size() - 1)];
}

double last_time(const History& history) {
  return history.times.empty() ? 0 : history.times.back();
}

}  // namespace

TimeAxis time_axis(const ComparedScene& scene, const std::vector<Run>& runs) {
  constexpr double room = 1.08, least = 1e-9;
  const double tolerance = runs.empty() ? 0 : small_part * range_of(*history_of(runs.front()));
  double moves = 0, end = least;
  for (const Run& run : runs) {
    const auto history = history_of(run);
    moves = std::max(moves, end_of_motion(*history, tolerance));
    end = std::max(end, last_time(*history));
  }
  if (moves > 0) end = std::min(end, room * moves);
  return scene.horizon() < scene.duration ? TimeAxis{end, scene.horizon()} : TimeAxis{.end = end};
}

std::string time_range(const TimeAxis& axis, double room) {
  std::string text = fmt::format("set xrange [0:{}]\n", plain(room * axis.end));
  if (axis.is_shaded())
    text += fmt::format(
        "set object rectangle from {}, graph 0 to graph 1, graph 1 fillcolor rgb '{}' fillstyle solid "
        "noborder behind\n",
        plain(axis.horizon), shade);
  return text;
}

void explain_shade(const TimeAxis& axis, Legend& legend) {
  if (axis.is_shaded())
    legend.emplace_back(fmt::format("with boxes fillstyle solid 1 noborder lc rgb '{}'", shade),
                        "beyond the horizon of predictability");
}

}  // namespace rockstack::plots
