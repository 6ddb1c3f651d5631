#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"

// What the ground does: under a scene, and by a record.

namespace rockstack::plots {
namespace {

constexpr auto line_style = "with lines lw 1.5 lc rgb '#0B4F8A' notitle";
constexpr auto ground_grid = "set grid lt 1 dt solid lw 1 lc rgb '#DADADA'\n";

/// A value with its time, to be marked.
struct Peak {
  double value = 0;
  double time = 0;  ///< s
};

Peak peak_of(const Curve& curve) {
  const auto peak = std::ranges::max_element(curve.values, {}, [](double value) { return std::abs(value); });
  return {*peak, curve.times[static_cast<std::size_t>(peak - curve.values.begin())]};
}

/// A mark where a curve is furthest from zero, and its words in the panel's other right corner, that far from
/// the edge.
std::string peak_mark(const Peak& peak, const std::string& unit, double from_edge) {
  constexpr auto colour = "#B03A00";
  return fmt::format(
      "set label '' at {}, {} point pt 6 ps 1.4*mark lc rgb '{}' front\n"
      "set label {} noenhanced at graph 0.985, graph {} right textcolor rgb '{}' front font ',12'\n",
      plain(peak.time), plain(peak.value), colour,
      in_quotes(fmt::format("{:.4g} {} at {:.4g} s", peak.value, unit, peak.time)),
      peak.value > 0 ? from_edge : 1 - from_edge, colour);
}

/// The range of a panel on both sides of zero.
double reach_of(double largest) {
  return 1.12 * std::max(largest, 1e-12);
}

std::string symmetric_range(double reach) {
  return fmt::format("set yrange [{}:{}]\n", plain(-reach), plain(reach));
}

void add_axis(Sheet& sheet, const std::string& name, const Curve& curve, const TimeAxis& axis, bool last) {
  const Peak peak = peak_of(curve);
  sheet.data(data_block(name, thin(curve, bins_for(2))));
  sheet.panel(220, 16,
              ground_grid + time_range(axis) + symmetric_range(reach_of(std::abs(peak.value))) +
                  fmt::format("set ylabel '{} (m/s²)' offset 0.5\n", name) +
                  (last ? time_numbers : without_horizontal_labels()) + peak_mark(peak, "m/s²", 0.1),
              {fmt::format("${} using 1:2 {}", name, line_style)});
}

/// What the figure of a record says beside its curves.
struct RecordFacts {
  std::string title;
  double gravity = 0, damping = 0;  ///< m/s², fraction of critical
  double begin = 0, end = 0;        ///< of the significant duration, s
  double arias_intensity = 0;       ///< m/s
  Peak acceleration, velocity, displacement;
};

RecordFacts record_facts(const Json& json) {
  const auto peak = [&](const char* key) -> Peak {
    return {json.at(key).at("value"), json.at(key).at("time")};
  };
  const auto& span = json.at("significant_5_95");
  const std::string record = std::filesystem::path(json.at("file").get<std::string>()).filename().string();
  const std::string channel = json.at("channel");
  return {.title = channel == "1" ? record : record + ", channel " + channel,
          .gravity = json.at("gravity"),
          .damping = json.at("spectrum_damping"),
          .begin = span.at("begin"),
          .end = span.at("end"),
          .arias_intensity = json.at("arias_intensity"),
          .acceleration = peak("peak_acceleration"),
          .velocity = peak("peak_velocity"),
          .displacement = peak("peak_displacement")};
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

/// A panel of a record over time.
class RecordPanels {
 public:
  RecordPanels(Sheet& sheet, const RecordFacts& facts) : sheet_(sheet), facts_(facts) {}

  void add_history(const std::string& name, const std::string& base, const Peak& peak, const Curve& curve) {
    constexpr double height = 175;
    const double largest = curve.largest();
    const Scale scale = scale_of(largest);
    const double reach = reach_of(largest) * scale.factor;
    const std::string unit = scale.prefix + base;
    add(height, name, scaled(curve, scale.factor),
        without_horizontal_labels() + fmt::format("set ylabel '{} ({})' offset 0.5\n", name, unit) +
            symmetric_range(reach) + linear_tics("y", -reach, reach, height) +
            peak_mark({peak.value * scale.factor, peak.time}, unit, 0.12));
  }

  void add_husid(const Curve& shares) {
    const std::string label = fmt::format("5–95 %: {:.3g} s; Arias intensity {:.3g} m/s",
                                          facts_.end - facts_.begin, facts_.arias_intensity);
    add(130, "husid", shares,
        time_numbers +
            fmt::format("set yrange [0:1]\nset ytics 0.25\nset ylabel 'share of ∫a² dt' offset 0.5\n"
                        "set label {} noenhanced at graph 0.985, graph 0.12 right font ',12' front\n",
                        in_quotes(label)));
  }

  void add_spectrum(const Curve& spectrum) {
    const Scale scale = scale_of(spectrum.largest() / facts_.gravity);
    const Curve shown = scaled(spectrum, scale.factor / facts_.gravity);
    sheet_.data(data_block("spectrum", shown));
    sheet_.panel(
        260, 96,
        fmt::format("set logscale x\nset xrange [{}:{}]\nset yrange [0:{}]\nset ytics autofreq\n",
                    plain(shown.times.front()), plain(shown.times.back()),
                    plain(1.1 * std::max(shown.largest(), 1e-12))) +
            "unset object\nset grid xtics ytics mxtics lt 1 dt solid lw 1 lc rgb '#DADADA', lt 1 dt solid lw 1 "
            "lc rgb '#EEEEEE'\nset format x '%g'\nset xlabel 'period (s)'\n" +
            fmt::format("set ylabel 'pseudo-acceleration ({}g)' offset 0.5\n"
                        "set label '{:g} % damped' noenhanced at graph 0.985, graph 0.93 right font ',12'\n",
                        scale.power, 100 * facts_.damping),
        {fmt::format("$spectrum using 1:2 {}", line_style)});
  }

 private:
  /// Over time, with the significant duration shaded.
  void add(double height, const std::string& name, const Curve& curve, const std::string& settings) {
    constexpr std::size_t bins = 1500;
    sheet_.data(data_block(name, thin(curve, bins)));
    sheet_.panel(
        height, 16,
        ground_grid +
            fmt::format(
                "set xrange [0:{}]\nset object rectangle from {}, graph 0 to {}, graph 1 fillcolor rgb '#EEF1DC' "
                "fillstyle solid noborder behind\n",
                plain(curve.times.back()), plain(facts_.begin), plain(facts_.end)) +
            settings,
        {fmt::format("${} using 1:2 {}", name, line_style)});
  }

  Sheet& sheet_;
  const RecordFacts& facts_;
};

}  // namespace

Drawing ground_motion(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const auto columns = read_columns(scene.ground_motion, {"time", "horizontal", "vertical"});
  const Curve horizontal{columns[0], columns[1]}, vertical{columns[0], columns[2]};
  const double peak = std::max(horizontal.largest(), vertical.largest());
  if (peak == 0) return subject.nothing("the ground stands still");
  const double end = columns[0].back();
  const TimeAxis axis =
      scene.horizon() < scene.duration ? TimeAxis{end, scene.horizon()} : TimeAxis{.end = end};
  Legend legend;
  explain_shade(axis, legend);
  Sheet sheet = subject.sheet(
      legend, fmt::format("At most {:.4g} m/s², {:.3g} times gravity", peak, peak / scene.gravity));
  if (horizontal.largest() > 0) add_axis(sheet, "horizontal", horizontal, axis, vertical.largest() == 0);
  if (vertical.largest() > 0) add_axis(sheet, "vertical", vertical, axis, true);
  return sheet.finish();
}

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
  RecordPanels panels(sheet, facts);
  panels.add_history("acceleration", "m/s²", facts.acceleration, {columns[0], columns[1]});
  panels.add_history("velocity", "m/s", facts.velocity, {columns[0], columns[2]});
  panels.add_history("displacement", "m", facts.displacement, {columns[0], columns[3]});
  panels.add_husid({columns[0], columns[4]});
  panels.add_spectrum({spectrum[0], spectrum[1]});
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
