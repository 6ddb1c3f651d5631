#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"

// What the ground does: under a scene, and by a record.

namespace rockstack::plots {
namespace {

constexpr auto line_style = "with lines lw 1.5 lc rgb '#0B4F8A'";
constexpr auto ground_grid = "set grid lt 1 dt solid lw 1 lc rgb '#DADADA'\n";

/// A mark where a curve is furthest from zero; its words in the other right corner, that far from the edge.
std::string peak_mark(double value, double time, const std::string& unit, double from_edge) {
  constexpr auto colour = "#B03A00";
  return fmt::format(
      "set label '' at {}, {} point pt 6 ps 1.4*mark lc rgb '{}' front\n"
      "set label {} noenhanced at graph 0.985, graph {} right textcolor rgb '{}' front font ',12'\n",
      plain(time), plain(value), colour, in_quotes(fmt::format("{:.4g} {} at {:.4g} s", value, unit, time)),
      value > 0 ? from_edge : 1 - from_edge, colour);
}

/// The range of a panel on both sides of zero.
double reach_of(double largest) {
  return 1.12 * std::max(largest, 1e-12);
}

void add_axis(Sheet& sheet, const std::string& name, const Curve& curve, const TimeAxis& axis, bool last) {
  const Curve shown = thin(curve, axis, bins_for(2));
  const auto at = std::ranges::max_element(shown.values, {}, [](double value) { return std::abs(value); });
  const double peak = *at, reach = reach_of(std::abs(peak)),
               time = shown.times[static_cast<std::size_t>(at - shown.values.begin())];
  constexpr double height = 220;
  sheet.data(data_block(name, shown));
  sheet.tell({"time (s)", name + " (m/s²)", false, {{name, "#1A1A1A", shown}}});
  sheet.panel(height, 16,
              ground_grid + time_range(axis) + linear_range("y", -reach, reach, height) +
                  fmt::format("set ylabel '{} (m/s²)' offset 0.5\n", name) +
                  (last ? time_numbers : without_horizontal_labels) + peak_mark(peak, time, "m/s²", 0.1),
              {plot_of(name, line_style)});
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

/// A panel of a record over time, with the significant duration shaded.
void add_over_time(Sheet& sheet, double height, const std::string& name, const Curve& curve,
                   const Json& significant, const std::string& settings) {
  sheet.data(data_block(name, thin(curve, curve.times.back(), 1500)));
  sheet.panel(
      height, 16,
      ground_grid +
          fmt::format(
              "set xrange [0:{}]\nset object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '#EEF1DC' "
              "fillstyle solid noborder behind\n",
              plain(curve.times.back()), plain(significant.at("begin")), plain(significant.at("end"))) +
          settings,
      {plot_of(name, line_style)});
}

void add_history(Sheet& sheet, const std::string& name, const std::string& base, const Json& facts,
                 const Curve& curve) {
  constexpr double height = 175;
  const Json& peak = facts.at("peak_" + name);
  const double largest = curve.largest();
  const Scale scale = scale_of(largest);
  const double reach = reach_of(largest) * scale.factor;
  const std::string unit = scale.prefix + base;
  add_over_time(sheet, height, name, scaled(curve, scale.factor), facts.at("significant_5_95"),
                without_horizontal_labels + fmt::format("set ylabel '{} ({})' offset 0.5\n", name, unit) +
                    linear_range("y", -reach, reach, height) +
                    peak_mark(peak.at("value").get<double>() * scale.factor, peak.at("time"), unit, 0.12));
}

void add_husid(Sheet& sheet, const Json& facts, double duration, const Curve& shares) {
  const std::string label = fmt::format("5–95 %: {:.3g} s; Arias intensity {:.3g} m/s", duration,
                                        facts.at("arias_intensity").get<double>());
  add_over_time(sheet, 130, "husid", shares, facts.at("significant_5_95"),
                time_numbers +
                    fmt::format("set yrange [0:1]\nset ytics 0.25\nset ylabel 'share of ∫a² dt' offset 0.5\n"
                                "set label {} noenhanced at graph 0.985, graph 0.12 right font ',12' front\n",
                                in_quotes(label)));
}

void add_spectrum(Sheet& sheet, const Json& facts, const Curve& spectrum) {
  const double gravity = facts.at("gravity"), damping = facts.at("spectrum_damping");
  const Scale scale = scale_of(spectrum.largest() / gravity);
  const Curve shown = scaled(spectrum, scale.factor / gravity);
  sheet.data(data_block("spectrum", shown));
  sheet.panel(
      260, 96,
      fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [0:{}]\nset ytics autofreq\n",
                  plain(shown.times.front()), plain(shown.times.back()),
                  plain(1.1 * std::max(shown.largest(), 1e-12))) +
          "unset object\nset grid xtics ytics mxtics lt 1 dt solid lw 1 lc rgb '#DADADA', lt 1 dt solid lw 1 "
          "lc rgb '#EEEEEE'\nset format x '%g'\nset xlabel 'period (s)'\n" +
          fmt::format("set ylabel 'pseudo-acceleration ({}g)' offset 0.5\n"
                      "set label '{:g} % damped' noenhanced at graph 0.985, graph 0.93 right font ',12'\n",
                      scale.power, 100 * damping),
      {plot_of("spectrum", line_style)});
}

}  // namespace

Drawing ground_motion(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const auto columns = read_columns(scene.ground_motion, {"time", "horizontal", "vertical"});
  const Curve horizontal{columns[0], columns[1]}, vertical{columns[0], columns[2]};
  const double peak = std::max(horizontal.largest(), vertical.largest());
  if (peak == 0) return subject.nothing("the ground stands still");
  const double end = columns[0].back();
  const TimeAxis axis =
      subject.asked(scene.horizon() < scene.duration ? TimeAxis{end, scene.horizon()} : TimeAxis{.end = end});
  Legend legend;
  explain_shade(axis, legend);
  Sheet sheet = subject.sheet(
      legend, fmt::format("At most {:.4g} m/s², {:.3g} times gravity", peak, peak / scene.gravity));
  if (horizontal.largest() > 0) add_axis(sheet, "horizontal", horizontal, axis, vertical.largest() == 0);
  if (vertical.largest() > 0) add_axis(sheet, "vertical", vertical, axis, true);
  return sheet.finish();
}

Drawings record(const FolderSubject& subject) {
  const fs::path& results = subject.folder;
  const auto columns =
      read_columns(results / "record.csv", {"time", "acceleration", "velocity", "displacement", "husid"});
  const auto spectrum = read_columns(results / "spectrum.csv", {"period", "pseudo_acceleration"});
  if (columns[0].empty() || spectrum[0].empty()) throw InputError(results.string() + ": holds no samples");
  return read_json(results / "record.json", [&](const Json& facts) {
    const Json& span = facts.at("significant_5_95");
    const double duration = span.at("end").get<double>() - span.at("begin").get<double>();
    const double peak = std::abs(facts.at("peak_acceleration").at("value").get<double>());
    const std::string record = fs::path(facts.at("file").get<std::string>()).filename().string();
    const std::string channel = facts.at("channel");
    Sheet sheet = subject.sheet(
        channel == "1" ? record : record + ", channel " + channel, {},
        fmt::format("Peak {:.3g} m/s², {:.3g} s between 5 and 95 % of its energy", peak, duration));
    add_history(sheet, "acceleration", "m/s²", facts, {columns[0], columns[1]});
    add_history(sheet, "velocity", "m/s", facts, {columns[0], columns[2]});
    add_history(sheet, "displacement", "m", facts, {columns[0], columns[3]});
    add_husid(sheet, facts, duration, {columns[0], columns[4]});
    add_spectrum(sheet, facts, {spectrum[0], spectrum[1]});
    return Drawings{{"", sheet.finish()}};
  });
}

}  // namespace rockstack::plots
