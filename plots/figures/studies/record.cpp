#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "plots/data/results.hpp"
#include "plots/drawing/axes.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr std::size_t bins = 1500;
constexpr auto line_style = "with lines lw 1.5 lc rgb '#0B4F8A' notitle";

/// A peak to be marked.
struct Mark {
  double value = 0;
  double time = 0;  ///< s
};

/// What the figure says beside its curves.
struct RecordFacts {
  std::string title;
  double gravity = 0, damping = 0;  ///< m/s², fraction of critical
  double begin = 0, end = 0;        ///< of the significant duration, s
  double arias_intensity = 0;       ///< m/s
  Mark acceleration, velocity, displacement;
};

Mark to_mark(const Json& json) {
  return {json.at("value"), json.at("time")};
}

RecordFacts record_facts(const Json& json) {
  const auto& span = json.at("significant_5_95");
  const std::string record = std::filesystem::path(json.at("file").get<std::string>()).filename().string();
  const std::string channel = json.at("channel");
  return {.title = channel == "1" ? record : record + ", channel " + channel,
          .gravity = json.at("gravity"),
          .damping = json.at("spectrum_damping"),
          .begin = span.at("begin"),
          .end = span.at("end"),
          .arias_intensity = json.at("arias_intensity"),
          .acceleration = to_mark(json.at("peak_acceleration")),
          .velocity = to_mark(json.at("peak_velocity")),
          .displacement = to_mark(json.at("peak_displacement"))};
}

double largest(const Curve& curve) {
  double value = 0;
  for (const double each : curve.values) value = std::max(value, std::abs(each));
  return value;
}

/// Weak records have small units, so that the numbers beside a panel stay short.
struct Scale {
  double factor;
  std::string prefix, power;  ///< of a unit; for one that takes no prefix
};

Scale scale_of(double largest) {
  constexpr double least = 0.1, tiny = 1e-4;
  if (largest >= least || largest == 0) return {1, "", ""};
  return largest >= tiny ? Scale{1e3, "m", "10⁻³ "} : Scale{1e6, "µ", "10⁻⁶ "};
}

Curve scaled(Curve curve, double factor) {
  for (double& value : curve.values) value *= factor;
  return curve;
}

/// A mark where a curve is furthest from zero, and its value in the panel's other right corner.
std::string peak_mark(const Mark& mark, const std::string& unit) {
  constexpr auto colour = "#B03A00";
  return fmt::format(
      "set label '' at {}, {} point pt 6 ps 1.4*mark lc rgb '{}' front\n"
      "set label {} noenhanced at graph 0.985, graph {} right textcolor rgb '{}' front font ',12'\n",
      plain(mark.time), plain(mark.value), colour,
      in_quotes(fmt::format("{:.4g} {} at {:.4g} s", mark.value, unit, mark.time)),
      mark.value > 0 ? 0.12 : 0.88, colour);
}

std::string significant_band(const RecordFacts& facts) {
  return fmt::format(
      "set object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '#EEF1DC' fillstyle solid noborder behind\n",
      plain(facts.begin), plain(facts.end));
}

std::string time_settings(const RecordFacts& facts, double last) {
  return fmt::format("set grid lt 1 dt solid lw 1 lc rgb '#DADADA'\nset xrange [0:{}]\n", plain(last)) +
         significant_band(facts);
}

void add_history(Sheet& sheet, const RecordFacts& facts, const std::string& name, const std::string& base,
                 const Mark& peak, const Curve& curve) {
  constexpr double height = 175;
  const Scale scale = scale_of(largest(curve));
  const double reach = 1.12 * std::max(largest(curve), 1e-12) * scale.factor;
  const std::string unit = scale.prefix + base;
  const std::string label = fmt::format("set ylabel '{} ({})' offset 0.5\n", name, unit);
  sheet.data(data_block(name, thin(scaled(curve, scale.factor), bins)));
  sheet.panel(height, 16,
              time_settings(facts, curve.times.back()) + without_horizontal_labels() + label +
                  fmt::format("set yrange [{}:{}]\n", plain(-reach), plain(reach)) +
                  linear_tics("y", -reach, reach, height) +
                  peak_mark({peak.value * scale.factor, peak.time}, unit),
              {fmt::format("${} using 1:2 {}", name, line_style)});
}

void add_husid(Sheet& sheet, const RecordFacts& facts, const Curve& shares) {
  sheet.data(data_block("husid", thin(shares, bins)));
  const std::string label = fmt::format("5–95 %: {:.3g} s; Arias intensity {:.3g} m/s",
                                        facts.end - facts.begin, facts.arias_intensity);
  sheet.panel(130, 16,
              time_settings(facts, shares.times.back()) +
                  "set format x '%g'\nset xlabel 'time (s)'\nset yrange [0:1]\nset ytics 0.25\n"
                  "set ylabel 'share of ∫a² dt' offset 0.5\n" +
                  fmt::format("set label {} noenhanced at graph 0.985, graph 0.12 right font ',12' front\n",
                              in_quotes(label)),
              {fmt::format("$husid using 1:2 {}", line_style)});
}

void add_spectrum(Sheet& sheet, const RecordFacts& facts, Curve spectrum) {
  const Scale scale = scale_of(largest(spectrum) / facts.gravity);
  spectrum = scaled(spectrum, scale.factor / facts.gravity);
  sheet.data(data_block("spectrum", spectrum));
  sheet.panel(
      260, 96,
      fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [0:{}]\nset ytics autofreq\n",
                  plain(spectrum.times.front()), plain(spectrum.times.back()),
                  plain(1.1 * std::max(largest(spectrum), 1e-12))) +
          "unset object\nset grid xtics ytics mxtics lt 1 dt solid lw 1 lc rgb '#DADADA', lt 1 dt solid lw 1 "
          "lc rgb '#EEEEEE'\nset format x '%g'\nset xlabel 'period (s)'\n" +
          fmt::format("set ylabel 'pseudo-acceleration ({}g)' offset 0.5\n"
                      "set label '{:g} % damped' noenhanced at graph 0.985, graph 0.93 right font ',12'\n",
                      scale.power, 100 * facts.damping),
      {fmt::format("$spectrum using 1:2 {}", line_style)});
}

}  // namespace

/// Acceleration, velocity and displacement with the significant duration, the growth of the Arias intensity,
/// and the response spectrum.
Drawings record(const FolderSubject& subject) {
  const std::filesystem::path& results = subject.folder;
  const RecordFacts facts = read_json(results / "record.json", record_facts);
  const auto columns =
      read_columns(results / "record.csv", {"time", "acceleration", "velocity", "displacement", "husid"});
  const auto spectrum = read_columns(results / "spectrum.csv", {"period", "pseudo_acceleration"});
  if (columns[0].empty() || spectrum[0].empty()) throw InputError(results.string() + ": holds no samples");
  Sheet sheet = subject.sheet(facts.title, {},
                              fmt::format("Peak {:.3g} m/s², {:.3g} s between 5 and 95 % of its energy",
                                          std::abs(facts.acceleration.value), facts.end - facts.begin));
  add_history(sheet, facts, "acceleration", "m/s²", facts.acceleration, {columns[0], columns[1]});
  add_history(sheet, facts, "velocity", "m/s", facts.velocity, {columns[0], columns[2]});
  add_history(sheet, facts, "displacement", "m", facts.displacement, {columns[0], columns[3]});
  add_husid(sheet, facts, {columns[0], columns[4]});
  add_spectrum(sheet, facts, {spectrum[0], spectrum[1]});
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
