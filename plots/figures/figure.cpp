#include "plots/figures/figure.hpp"

namespace rockstack::plots {

Sheet Figure::sheet(const std::string& heading, const Legend& legend, const std::string& answer) const {
  return {heading, legend, question + " " + answer};
}

Sheet FolderSubject::sheet(const std::string& heading, const Legend& legend,
                           const std::string& answer) const {
  return width < full_width ? Sheet("", legend, "", width) : figure.sheet(heading, legend, answer);
}

Sheet SceneSubject::sheet(const Legend& legend, const std::string& answer) const {
  return on_slide ? Sheet("", legend, "", slide_width) : figure.sheet(heading(scene), legend, answer);
}

Drawing SceneSubject::nothing(const std::string& reason) const {
  return empty_sheet(heading(scene), reason);
}

Shown SceneSubject::shown(const std::vector<std::string>& files) const {
  Shown shown = shown_runs(comparison, scene.name);
  std::erase_if(shown.engines, [&](const Run& run) {
    return !std::ranges::all_of(files,
                                [&](const std::string& file) { return fs::exists(run.folder / file); });
  });
  return shown;
}

TimeAxis SceneSubject::time_axis(const std::vector<Run>& runs, Legend& legend) const {
  const TimeAxis axis = plots::time_axis(scene, runs);
  explain_shade(axis, legend);
  return axis;
}

void SceneSubject::add_replicates_note(Sheet& sheet) const {
  if (const std::string note = draws_note(comparison, scene.name); !note.empty()) sheet.note(note);
}

std::vector<Run> all_runs(const Shown& shown) {
  std::vector<Run> runs = shown.exact;
  runs.insert(runs.end(), shown.engines.begin(), shown.engines.end());
  return runs;
}

Legend mark_legend(const std::vector<Run>& runs, double size) {
  return legend_of(runs, [&](const Run& run, std::size_t) { return mark_style(run, size); });
}

void add_curves(Sheet& sheet, const SeriesPanel& panel, const std::vector<Run>& runs,
                const std::vector<Curve>& curves, const std::string& stem, const CurveLook& look) {
  std::vector<Series> series;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (curves[i].size() == 0) continue;
    const std::string name = fmt::format("{}_{}", stem, i);
    sheet.data(data_block(name, curves[i]));
    series.push_back(curve_series(runs[i], name, i, look));
  }
  add_series(sheet, panel, series, are_many(runs));
}

std::string logarithmic_axes(const Reach& across, const Reach& up, double width, double height) {
  return logarithmic_range("x", across.low, across.high, width) +
         logarithmic_range("y", up.low, up.high, height) + grid_lines;
}

std::string number_block(const std::string& name, const Numbers& lines) {
  std::string text = fmt::format("${} << END\n", name);
  for (const std::vector<double>& line : lines) {
    for (const double number : line) text += plain(number) + " ";
    text += "\n";
  }
  return text + "END\n";
}

void Plots::add(const Numbers& lines, const std::vector<std::string>& styles) {
  const std::string name = fmt::format("{}_{}", stem_, list_.size());
  sheet_.data(number_block(name, lines));
  for (const std::string& style : styles) list_.push_back(fmt::format("${} {} notitle", name, style));
}

std::string word_tics(const std::vector<std::string>& words, int first, int step) {
  const auto tic = [&](const std::string& word) {
    return fmt::format("{} {}", in_quotes(word), std::exchange(first, first + step));
  };
  return text_of_each(words, tic, ", ");
}

}  // namespace rockstack::plots
