#include "plots/figures/figure.hpp"

#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "plots/data/scores.hpp"
#include "rockstack_plots_texts.hpp"

namespace rockstack::plots {

using DrawScene = Drawing(const SceneSubject&);
using DrawComparison = Drawings(const ComparisonSubject&);
using DrawFolder = Drawings(const FolderSubject&);
#include "plots/figures/drawers.inc"
DrawComparison solver_scores;

namespace {

/// A figure with its words, from figures.txt.
Figure figure(const std::string& name, const decltype(Figure::of)& of) {
  static const std::vector<Paragraph> list = paragraphs(figures_txt);
  const Paragraph& words = *std::ranges::find(list, name, &Paragraph::name);
  const std::size_t end = words.words.find("? ") + 1;
  return {name, words.kind.substr(words.kind.find("} | ") + 4), words.words.substr(0, end),
          words.words.substr(end + 1), of};
}

std::vector<Figure> all_figures() {
  // What a scene's results must have.
  static constexpr auto sampled = [](auto& scene) { return scene.has("histories"); };
  // Whether runs stand beside each other at all times.
  static constexpr auto compared = [](auto& scene) { return sampled(scene) && !scene.alone; };
  static constexpr auto tested = [](auto& scene) { return sampled(scene) && !scene.readings.empty(); };
  static constexpr auto slips = [](auto& scene) { return sampled(scene) && scene.slips; };
  static constexpr auto frictions = [](auto& scene) { return sampled(scene) && scene.frictions; };
  static constexpr auto both_equations = [](auto& scene) { return sampled(scene) && scene.both_equations; };
  static constexpr auto bodies = [](auto& scene) { return sampled(scene) && scene.has("bodies"); };
  static constexpr auto impacts = [](auto& scene) { return scene.has("impacts"); };
  static constexpr auto carried = [](auto& scene) { return sampled(scene) && scene.has("forces"); };
  static constexpr auto struck = [](auto& scene) { return carried(scene) && !scene.alone; };
  static constexpr auto shaken = [](auto& scene) { return !scene.ground_motion.empty(); };
  static constexpr auto losses = [](auto& scene) {
    return bodies(scene) && impacts(scene) && !shaken(scene);
  };
  static constexpr auto errors = [](auto& scene) { return scene.has("angles"); };
  static constexpr auto patterns = [](auto& scene) { return scene.has("patterns"); };
  static constexpr auto split = [](auto& scene) { return scene.split; };
  static constexpr auto fitted = [](auto& scene) { return scene.fitted; };
  static constexpr auto perturbed = [](auto& scene) { return scene.perturbed; };
  std::vector<Figure> list{
#include "plots/figures/entries.inc"
  };
  for (const SolverQuestion& one : solver_questions())
    list.push_back(
        {"solvers." + one.name, "All solvers: " + one.name, one.question,
         "A row a solver and set, those first that answer for all scenes; a small cross a scene, a large "
         "mark the median of all. Rows whose scenes lie among each other are not told apart.",
         ComparisonFigure{solver_scores}});
  return list;
}

void draw_all(const Figure& figure, const Drawings& drawings, const fs::path& results) {
  for (const auto& [part, drawing] : drawings)
    draw(drawing, results / "figures" / (part.empty() ? figure.name : figure.name + "." + part));
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> list = all_figures();
  return list;
}

std::vector<const Figure*> figures_of(const ComparedScene& scene, bool in_print) {
  std::vector<const Figure*> list;
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<SceneFigure>(&figure.of);
        of != nullptr && of->needs(scene) && (in_print || !figure.has(print_alone)))
      list.push_back(&figure);
  return list;
}

const Figure* figure_in(const std::string& stem) {
  for (const Figure& figure : figures())
    if (stem == figure.name || stem.starts_with(figure.name + ".")) return &figure;
  for (const Figure& figure : figures())
    if (stem.ends_with("." + figure.name)) return &figure;
  return nullptr;
}

void draw_figures(const fs::path& results, const Comparison& comparison) {
  for (const ComparedScene& scene : comparison.scenes)
    for (const Figure* figure : figures_of(scene))
      draw(std::get<SceneFigure>(figure->of).draw({{*figure}, comparison, scene}),
           figure_stem(results, scene, *figure));
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<ComparisonFigure>(&figure.of); of != nullptr)
      draw_all(figure, of->draw({{figure}, comparison}), results);
}

void draw_figures(const fs::path& results) {
  for (const Figure& figure : figures()) {
    const auto* of = std::get_if<FolderFigure>(&figure.of);
    if (of == nullptr || !fs::exists(table_file(results / of->needs))) continue;
    Drawings drawings = of->draw({{figure}, results});
    if (figure.has(narrow)) drawings[narrow_part] = of->draw({{figure}, results, narrow_width}).at("");
    draw_all(figure, drawings, results);
  }
}

Sheet Subject::sheet(const std::string& heading, const Legend& legend, const std::string& answer,
                     double width) const {
  if (print == nullptr) return {heading, legend, figure.question + " " + answer, width};
  return {print->titles ? heading : "", legend, "", print_width(*print),
          Paper{print->font, pixels_per_inch(*print), true, least_size(*print)}};
}

Sheet FolderSubject::sheet(const std::string& heading, const Legend& legend,
                           const std::string& answer) const {
  const bool is_narrow = print == nullptr && width < full_width;
  return is_narrow ? Sheet("", legend, "", width) : Subject::sheet(heading, legend, answer);
}

Sheet SceneSubject::sheet(const Legend& legend, const std::string& answer) const {
  return on_slide ? Sheet("", legend, "", slide_width) : Subject::sheet(scene.heading, legend, answer);
}

RunSelection SceneSubject::shown(const std::vector<std::string>& files) const {
  RunSelection shown = shown_runs(comparison, scene.name);
  std::erase_if(shown.engines, [&](const Run& run) {
    return !std::ranges::all_of(
        files, [&](const std::string& file) { return fs::exists(run.shown_folder() / file); });
  });
  return shown;
}

TimeAxis SceneSubject::asked(TimeAxis axis) const {
  if (print == nullptr) return axis;
  axis.begin = print->from;
  axis.end = std::min(axis.end, print->to);
  if (!(axis.begin < axis.end))
    throw InputError(fmt::format("from = {}: must be before {:.4g} s, where the motion of {} ends",
                                 number_text(axis.begin), axis.end, scene.title));
  return axis;
}

TimeAxis SceneSubject::time_axis(const std::vector<Run>& runs, Legend& legend) const {
  const TimeAxis axis = time_axis(runs);
  explain_shade(axis, legend);
  return axis;
}

std::function<std::string(double, double)> logarithmic_axes(const Extent& across, const Extent& up) {
  return [across, up](double width, double height) {
    return logarithmic_range("x", across.low, across.high, width) +
           logarithmic_range("y", up.low, up.high, height) + grid_lines;
  };
}

std::string number_block(const std::string& name, const Numbers& lines) {
  const auto line = [](const std::vector<double>& numbers) {
    return joined_texts(numbers, plain, " ") + "\n";
  };
  return "$" + name + " << END\n" + joined_texts(lines, line) + "END\n";
}

void Plots::add(const Numbers& lines, const std::vector<std::string>& styles) {
  const std::string name = fmt::format("{}_{}", stem_, list_.size());
  sheet_.data(number_block(name, lines));
  for (const std::string& style : styles) list_.push_back(fmt::format("${} {} notitle", name, style));
}

DrawnCurve drawn_curve(const std::string& words, const Numbers& lines, std::size_t column) {
  DrawnCurve drawn{words, "#1A1A1A", {}};
  for (const std::vector<double>& line : lines) drawn.curve.add(line[0], line[column]);
  return drawn;
}

std::string word_tics(const std::vector<std::string>& words, int first, int step) {
  const auto tic = [&](const std::string& word) {
    return fmt::format("{} {}", in_quotes(word), std::exchange(first, first + step));
  };
  return joined_texts(words, tic, ", ");
}

}  // namespace rockstack::plots
