#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/figure.hpp"

// Beside what a test has measured: the motions of a comparison, and a fitted one.
namespace rockstack::plots {
namespace {

std::string off_phrase(const Run& run, const std::string& unit) {
  return fmt::format("{} by {:.2g} {}", line_label(run), value_of(run.rms_test_difference), unit);
}

/// How far the exact motion and the nearest engine are off, as far as that was asked for.
std::string readings_answer(std::vector<Run> runs, const std::string& unit) {
  std::erase_if(runs, [](const Run& run) { return !run.rms_test_difference; });
  if (runs.empty()) return "Up to the horizon nothing was held against it.";
  const auto nearest = std::ranges::min_element(runs.begin() + 1, runs.end(), {}, &Run::rms_test_difference);
  return "RMS differences up to the horizon: " + off_phrase(runs.front(), unit) +
         (nearest == runs.end() ? "" : ", the nearest engine " + off_phrase(*nearest, unit));
}

constexpr auto reading_style = "with points pt 7 ps 0.5*mark lc rgb '#C2187A'";  // what a test has measured
constexpr auto model_style = "with lines lw 2 lc rgb '#0B4F8A'";

}  // namespace

Drawing readings(const SceneSubject& subject) {
  const ComparedScene& scene = subject.scene;
  const std::vector<Run> runs = all_runs(subject.shown({"readings.csv"}));
  if (runs.empty()) return subject.nothing("No run of this scene was done.");
  Legend legend = legend_of(runs, curve_style);
  legend.emplace(legend.begin(), reading_style, "measured");
  const TimeAxis axis = subject.time_axis(runs, legend);
  Sheet sheet = subject.sheet(legend, readings_answer(runs, scene.reading_unit));
  for (std::size_t k = 0; k < scene.readings.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    const auto read = [&](const Run& run, const std::string& quantity) {
      const auto columns = read_columns(run.shown_folder() / "readings.csv", {"time", quantity + number});
      return Curve{columns[0], columns[1]};
    };
    const std::vector<Curve> curves =
        mapped(runs, [&](const Run& run) { return thin(read(run, "motion_"), axis, bins_for(runs.size())); });
    Extent extent = extent_of(runs, curves, 1, 1e-6);
    const Curve seen = read(runs.front(), "measured_");
    Numbers marks;
    for (std::size_t i = 0; i < seen.size() && seen.times[i] <= axis.end; ++i) {
      if (std::isnan(seen.values[i]) || seen.times[i] < axis.begin) continue;
      marks.push_back({seen.times[i], seen.values[i]});
      extent.add(seen.values[i]);
    }
    Plots measured(sheet, "measured_" + number);
    measured.add(marks, {fmt::format("using 1:2 {}", reading_style)});
    const std::string words = fmt::format("{} ({})", scene.readings[k], scene.reading_unit);
    const auto axes = [&](double, double up) {
      return time_range(axis) + linear_range("y", extent.low, extent.high, up) + grid_lines;
    };
    const bool last = k + 1 == scene.readings.size();
    const double height = panel_height(static_cast<int>(scene.readings.size()));
    SeriesPanel panel{"time (s)", words, words, last, axes, height};
    panel.under = measured.list();
    add_curves(sheet, panel, runs, curves, "motion_" + number);
  }
  return sheet.finish();
}

Drawings fit(const FolderSubject& subject) {
  const Json json = read_json(subject.folder / "fit.json");
  const std::string unit = json.at("unit");
  Sheet sheet = subject.sheet(json.at("title"), {{reading_style, "measured"}, {model_style, "fitted"}},
                              json.at("meaning").front());
  const double horizon = json.at("horizon");
  int panels = 0;
  for (const std::string column : json.at("columns")) {
    const auto read =
        read_columns(subject.folder / "fit.csv", {"time", "measured_" + column, "fitted_" + column});
    Numbers both, off;
    for (std::size_t i = 0; i < read[0].size(); ++i) {
      if (std::isnan(read[1][i])) continue;
      both.push_back({read[0][i], read[1][i], read[2][i]});
      off.push_back({read[0][i], read[2][i] - read[1][i]});
    }
    const std::string range =
        fmt::format("set xrange [0:{0}]\nset arrow from {1}, graph 0 to {1}, graph 1 nohead dt 2\n",
                    plain(read[0].back()), plain(horizon));
    const std::string number = std::to_string(++panels);
    Plots motion(sheet, "motion_" + number), residual(sheet, "residual_" + number);
    motion.add(both, {fmt::format("using 1:2 {}", reading_style), fmt::format("using 1:3 {}", model_style)});
    residual.add(off, {fmt::format("using 1:2 {}", reading_style)});
    sheet.panel(
        300, 16,
        range + without_horizontal_labels +
            fmt::format("set ylabel {} offset 0.5\n", in_quotes(fmt::format("{} ({})", column, unit))),
        motion.list());
    sheet.panel(150, 16, range + time_numbers + fmt::format("set ylabel 'residual ({})' offset 0.5\n", unit),
                residual.list());
  }
  return {{"", sheet.finish()}};
}

}  // namespace rockstack::plots
