#include "comparisons/measures/results/sentences.hpp"
#include "plots/data/scores.hpp"
#include "plots/figures/figure.hpp"
#include "rockstack_plots_texts.hpp"

namespace rockstack::plots {

using DrawScene = Drawing(const SceneSubject&);
using DrawComparison = Drawings(const ComparisonSubject&);
using DrawFolder = Drawings(const FolderSubject&);
#include "plots/figures/drawers.inc"
DrawComparison solver_scores;

namespace {

// What a scene's results must have.
constexpr auto sampled = [](const auto& scene) { return scene.has("histories"); };
/// Whether runs stand beside each other at all times.
constexpr auto compared = [](const auto& scene) { return sampled(scene) && !scene.alone; };
constexpr auto tested = [](const auto& scene) { return sampled(scene) && !scene.readings.empty(); };
constexpr auto slips = [](const auto& scene) { return sampled(scene) && scene.slips; };
constexpr auto frictions = [](const auto& scene) { return sampled(scene) && scene.frictions; };
constexpr auto both_equations = [](const auto& scene) { return sampled(scene) && scene.both_equations; };
constexpr auto bodies = [](const auto& scene) { return sampled(scene) && scene.has("bodies"); };
constexpr auto impacts = [](const auto& scene) { return scene.has("impacts"); };
constexpr auto shaken = [](const auto& scene) { return !scene.ground_motion.empty(); };
constexpr auto losses = [](const auto& scene) { return bodies(scene) && impacts(scene) && !shaken(scene); };
constexpr auto errors = [](const auto& scene) { return scene.has("angles"); };
constexpr auto patterns = [](const auto& scene) { return scene.has("patterns"); };
constexpr auto split = [](const auto& scene) { return scene.split; };
constexpr auto fitted = [](const auto& scene) { return scene.fitted; };
constexpr auto perturbed = [](const auto& scene) { return scene.perturbed; };

/// A figure with its words, from figures.txt.
Figure figure(const std::string& name, const decltype(Figure::of)& of) {
  static const std::vector<Paragraph> list = paragraphs(figures_txt);
  const Paragraph& words = *std::ranges::find(list, name, &Paragraph::name);
  const std::size_t end = words.words.find("? ") + 1;
  return {name, words.kind.substr(words.kind.find("| ") + 2), words.words.substr(0, end),
          words.words.substr(end + 1), of};
}

std::vector<Figure> all_figures() {
  std::vector<Figure> list{
#include "plots/figures/entries.inc"
  };
  for (const SolverQuestion& one : solver_questions())
    list.push_back(
        {"solvers." + one.name, "All solvers: " + one.name, one.question,
         "A row a solver and set, those first that answer for all scenes; a small cross a scene, a large "
         "mark the median of all. Rows whose scenes lie among each other are not told apart.",
         OfComparison{solver_scores}});
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

std::vector<const Figure*> figures_of(const ComparedScene& scene) {
  std::vector<const Figure*> list;
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<OfScene>(&figure.of); of != nullptr && of->needs(scene))
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

fs::path figure_stem(const fs::path& results, const ComparedScene& scene, const Figure& figure) {
  return results / "figures" / (scene.alone ? figure.name : scene.name + "." + figure.name);
}

void draw_figures(const fs::path& results, const Comparison& comparison) {
  for (const ComparedScene& scene : comparison.scenes)
    for (const Figure* figure : figures_of(scene))
      draw(std::get<OfScene>(figure->of).draw({*figure, comparison, scene}),
           figure_stem(results, scene, *figure));
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<OfComparison>(&figure.of); of != nullptr)
      draw_all(figure, of->draw({figure, comparison}), results);
}

void draw_figures(const fs::path& results) {
  for (const Figure& figure : figures()) {
    const auto* of = std::get_if<OfFolder>(&figure.of);
    if (of == nullptr || !fs::exists(results / of->needs)) continue;
    Drawings drawings = of->draw({figure, results});
    if (of->narrow) drawings[narrow_part] = of->draw({figure, results, narrow_width}).at("");
    draw_all(figure, drawings, results);
  }
}

}  // namespace rockstack::plots
