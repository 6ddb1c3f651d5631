#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "plots/data/selection.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

/// One of the parts of a difference.
struct Part {
  const char* name;
  const char* colour;
  double Run::*size;
};

constexpr std::array parts_of_difference{Part{"contact model", "#4477AA", &Run::model_difference},
                                         Part{"contact softness", "#CCBB44", &Run::softness_difference},
                                         Part{"time step", "#AA3377", &Run::step_difference}};

/// What a logarithmic axis does not reach stands on its left edge.
constexpr double least_part = 1e-9;  // rad

std::vector<StepLine> split_lines(const Comparison& comparison, const std::string& scene) {
  std::vector<StepLine> lines;
  for (StepLine line : step_lines(comparison, scene)) {
    std::erase_if(line, [](const Run& run) { return std::isnan(run.step_difference); });
    if (!line.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

/// The largest, the middle and the smallest of the time steps; or all, where there are fewer.
std::vector<double> chosen_steps(const std::vector<StepLine>& lines) {
  std::set<double> all;
  for (const StepLine& line : lines)
    for (const Run& run : line) all.insert(run.dt);
  std::vector<double> steps(all.rbegin(), all.rend());
  if (steps.size() > 3) steps = {steps.front(), steps[steps.size() / 2], steps.back()};
  return steps;
}

/// Where panels begin, beside the longest words, as a share of the figure's width.
double left_of(const std::vector<StepLine>& lines) {
  constexpr double character = 0.0072, beside = 0.025, most = 0.6;
  double left = left_edge;
  for (const StepLine& line : lines)
    left = std::max(left, character * static_cast<double>(line_label(line).size()) + beside);
  return std::min(left, most);
}

/// The bars of one step: left end, row, right end, lower and upper edge of each.
std::vector<std::string> bars(Sheet& sheet, const std::vector<StepLine>& lines, double dt, std::size_t at) {
  std::vector<std::string> plots;
  for (std::size_t p = 0; p < parts_of_difference.size(); ++p) {
    const Part& part = parts_of_difference[p];
    const std::string name = fmt::format("part_{}_{}", at, p);
    std::string block = "$" + name + " << END\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Run& run : lines[i]) {
        if (run.dt != dt) continue;
        const double top = static_cast<double>(i) - 0.36 + 0.24 * static_cast<double>(p);
        block += fmt::format("{} {} {} {} {} {}\n", plain(least_part), plain(top + 0.12), plain(least_part),
                             plain(std::max(run.*part.size, least_part)), plain(top), plain(top + 0.24));
      }
    sheet.data(block + "END\n");
    plots.push_back(
        fmt::format("${} with boxxyerror fs solid noborder lc rgb '{}' notitle", name, part.colour));
  }
  return plots;
}

std::string row_tics(const std::vector<StepLine>& lines, bool first) {
  std::string tics;
  for (std::size_t i = 0; i < lines.size(); ++i)
    tics += fmt::format("{}{} {}", i > 0 ? ", " : "", in_quotes(first ? line_label(lines[i]) : ""), i);
  return fmt::format("set ytics ({}) noenhanced font ',11'\n", tics);
}

double largest_part(const std::vector<StepLine>& lines) {
  double largest = 10 * least_part;
  for (const StepLine& line : lines)
    for (const Run& run : line)
      for (const Part& part : parts_of_difference) largest = std::max(largest, run.*part.size);
  return largest;
}

/// How many of the runs have that part as their largest.
std::size_t led_by(const std::vector<StepLine>& lines, const Part& led) {
  std::size_t count = 0;
  for (const StepLine& line : lines)
    count += static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [&](const Run& run) {
      return std::all_of(parts_of_difference.begin(), parts_of_difference.end(), [&](const Part& part) {
        return part.size == led.size || run.*part.size < run.*led.size;
      });
    }));
  return count;
}

}  // namespace

Drawing split_parts(const Comparison& comparison, const ComparedScene& scene) {
  const std::vector<StepLine> lines = split_lines(comparison, scene.name);
  if (lines.empty()) return empty_sheet(heading(scene), "No engine run of this scene that is split.");
  Legend legend;
  for (const Part& part : parts_of_difference)
    legend.emplace_back(fmt::format("with lines lw 8 lc rgb '{}'", part.colour), part.name);
  std::string answer;
  for (const Part& part : parts_of_difference)
    answer += fmt::format("{}{} in {}", answer.empty() ? "" : ", ", part.name, led_by(lines, part));
  Sheet sheet(heading(scene), legend, "What is a difference made of? The largest part, runs: " + answer);
  const std::vector<double> steps = chosen_steps(lines);
  const double high = 1.5 * largest_part(lines), left = left_of(lines);
  const double width = (right_edge - left) * 1200 / static_cast<double>(steps.size());
  std::vector<SidePanel> cells;
  for (std::size_t i = 0; i < steps.size(); ++i)
    cells.push_back({fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [{}:-0.7]\n"
                                 "set grid x lt 1 dt solid lw 1 lc rgb '#E4E4E4'\nset xlabel 'step {}'\n",
                                 plain(least_part), plain(high), static_cast<double>(lines.size()) - 0.3,
                                 duration_text(steps[i])) +
                         row_tics(lines, i == 0) + logarithmic_tics("x", least_part, high, width),
                     bars(sheet, lines, steps[i], i)});
  sheet.row(34 * static_cast<double>(lines.size()) + 30, 0, cells, cells.size(), left);
  sheet.note("RMS of each part over all samples and blocks (rad); as histories the three add up", "#000000");
  if (const std::string note = draws_note(comparison, scene.name); !note.empty())
    sheet.note("medians over replicates", "#000000");
  return sheet.finish();
}

}  // namespace rockstack::plots
