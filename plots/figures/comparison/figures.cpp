#include "plots/figures/comparison/figures.hpp"

#include <array>

#include "plots/figures/comparison/drawings.hpp"
#include "plots/figures/contact/slip.hpp"
#include "plots/figures/solvers/scores.hpp"

namespace rockstack::plots {
namespace {

using Draw = Drawing (*)(const Comparison&, const ComparedScene&);

constexpr std::array<Draw, 18> draws{
    histories,     slip,        friction,   differences, impact_times,      impact_energy,
    ranking,       split_parts, error_time, error_step,  first_impact_step, toppling,
    distributions, equations,   energy,     phase,       occupancy,         ground_motion};

bool sampled(const ComparedScene& scene) {
  return scene.has("histories");
}

bool fitted(const ComparedScene& scene) {
  return scene.fitted;
}

}  // namespace

const std::vector<FigureKind>& figure_kinds() {
  static const std::vector<FigureKind> kinds{
      {"histories", "Angles over time",
       "How do the blocks move? One panel a block. The thick grey line with a black core is the exact "
       "solution; "
       "each engine is shown with its smallest time step, tuned where it was tuned. Ticks along the upper "
       "edge "
       "are the exact impacts at the interface under that block; the band at the bottom names the exact "
       "pattern. A curve that leaves its panel goes on beyond it.",
       sampled},
      {"slip", "Slip and gap",
       "How far do blocks slide, and when do they fly? The slip of each block along what is below it, to the "
       "right positive, and its distance from it where there ever is one: a gap above zero is a flight. The "
       "thick grey line is the exact motion; engines are shown as far as they tell their slip. A curve that "
       "leaves its panel goes on beyond it.",
       [](const ComparedScene& scene) { return sampled(scene) && scene.slips; }},
      {"friction", "Friction",
       "What does friction do? Angles and slips of the exact motion with several coefficients of friction at "
       "all interfaces; the thick grey line is the motion by the scene's own law.",
       [](const ComparedScene& scene) { return sampled(scene) && scene.frictions; }},
      {"differences", "Angle differences over time",
       "How far off is each engine, and from when? The largest absolute value of each short "
       "stretch of time, on a logarithmic axis; a curve that leaves its panel below is nearer still. The "
       "dashed "
       "line is the tolerance. The rows at the bottom say when each replicate first passes it, in whichever "
       "block: "
       "crosses are replicates, the large mark their median; at the right end stands what never does.",
       sampled},
      {"impact-times", "Impact times",
       "How late or early is each impact? Each mark is an exact impact that the engine has too: above zero "
       "the "
       "engine is late, below it is early. The axis is logarithmic on both sides and linear across the "
       "middle. "
       "The rows below hold the exact impacts that an engine misses, and those of its own that match none.",
       [](const ComparedScene& scene) { return scene.has("impacts"); }},
      {"impact-energy", "Energy lost at each impact",
       "Does each impact lose what it should? Above, the exact losses. Below, by how much more the engine "
       "loses, "
       "in percent of the exact loss, counted from halfway to the impact before to halfway to that after, so "
       "that a late impact is compared with itself. Impacts that lose less than a thousandth of the largest "
       "are "
       "left out; marks on the edge lie at or beyond 100 %.",
       [](const ComparedScene& scene) {
         return sampled(scene) && scene.has("bodies") && scene.has("impacts") && scene.ground_motion.empty();
       }},
      {"ranking", "Ranking",
       "Which is nearest to the exact motion? A row a solver and set, or a number of iterations where these "
       "vary; a column a time step. Marks are medians over replicates, thick bars quartiles, thin ones the "
       "whole "
       "range. Rows whose bars overlap cannot be told apart.",
       [](const ComparedScene& scene) { return scene.has("angles"); }},
      {"parts", "Contact model, contact softness, time step",
       "What is a difference made of? Three bars a row: from the exact motion to the exact one on rigid "
       "contacts with the engine's friction; from there to the exact one on springs as soft as the engine's "
       "contacts; from there to the engine. The first does not depend on the engine's step, the last is what "
       "a smaller step may take away. Bars that end on the left edge are smaller, or nothing.",
       [](const ComparedScene& scene) { return scene.split; }},
      {"error-time", "Error against computing time",
       "What does accuracy cost? Each mark is a run, labelled with its time step where there is room, or in "
       "a "
       "sweep of iterations at one step with their number: lower is nearer to the exact solution, further "
       "left "
       "is faster. Filled marks are tuned settings, open ones defaults, stars and crosses sets with a "
       "parameter "
       "changed. Lines join neighbours whose errors tell a trend. The vertical line is the time the exact "
       "solver takes. Levels across are model errors, where a fit over the time steps tells them: dashed, or "
       "dotted where its bounds include none.",
       [](const ComparedScene& scene) { return scene.has("angles"); }},
      {"error-step", "Error against time step",
       "What does a smaller step bring? Each mark is a run. The line through them is the fit error = model "
       "error "
       "+ c · dtᵖ, with its order p and the model error that no step takes away, each with 95 % bounds. "
       "Levels "
       "across are the model errors: dashed, or dotted where the bounds include none.",
       fitted},
      {"first-impact-step", "Time of the first impact against time step",
       "Does the first impact come in time? The same for the absolute difference in time of the first "
       "impact, "
       "which no impact before it has disturbed.",
       fitted},
      {"toppling", "Scenes that topple",
       "How many scenes that differ a little topple? The share of slightly perturbed scenes in which it "
       "does, with 95 % bounds, "
       "and in "
       "how many of them the engine's answer is the exact one.",
       [](const ComparedScene& scene) { return scene.perturbed; }},
      {"distributions", "Distributions over perturbed scenes",
       "Are engines right on the whole? The share of slightly perturbed scenes in which a quantity is at "
       "most "
       "the value below. Where histories part by nature, these are what can be compared: D is the largest "
       "vertical distance from the exact solution's curve, and beside it the distance that two samples of "
       "one "
       "distribution exceed once in twenty times.",
       [](const ComparedScene& scene) { return scene.perturbed; }},
      {"equations", "Linear against nonlinear equations",
       "What does linearising change? The exact solver with the full equations and with those that the paper "
       "linearises, one panel a block. Ticks and band are the exact motion's.",
       [](const ComparedScene& scene) { return sampled(scene) && scene.both_equations; }},
      {"energy", "Energy",
       "Do engines lose energy as they should? Kinetic and potential energy in the ground's frame. In free "
       "rocking the exact one is a staircase: it falls at impacts and nowhere else. Below, how far engines "
       "are "
       "off, as the median between exact impacts, so that a late impact does not hide a drift: where their "
       "curve rises without a ground that moves, contacts make energy.",
       [](const ComparedScene& scene) { return sampled(scene) && scene.has("bodies"); }},
      {"phase", "Phase portraits",
       "Which path does each block take? Its angle against its angular velocity: a swing is a loop, an "
       "impact a "
       "jump, and a path inside the exact one has lost more energy. A curve that leaves its panel goes on "
       "beyond it.",
       sampled},
      {"occupancy", "Time in each pattern",
       "Are engines in the exact pattern? The share of time spent in each pattern of contacts, read from the "
       "angles of all motions alike; the exact motion's longest first, as grey bars. The words below say for "
       "how "
       "much of the time a motion is in the exact one's pattern.",
       [](const ComparedScene& scene) { return scene.has("patterns"); }},
      {"ground-motion", "Ground acceleration",
       "What shakes the blocks? The acceleration to the right and upwards positive, up to the end of the "
       "scene. "
       "The mark is the largest absolute value.",
       [](const ComparedScene& scene) { return !scene.ground_motion.empty(); }},
  };
  return kinds;
}

bool has_figure(const ComparedScene& scene, const FigureKind& kind) {
  return kind.is_there(scene);
}

std::filesystem::path figure_stem(const std::filesystem::path& results, const std::string& scene,
                                  const std::string& kind) {
  return results / "figures" / (scene + "." + kind);
}

void draw_figures(const std::filesystem::path& results) {
  const Comparison comparison = read_comparison(results);
  for (const ComparedScene& scene : comparison.scenes)
    for (std::size_t i = 0; i < draws.size(); ++i)
      if (const FigureKind& kind = figure_kinds()[i]; has_figure(scene, kind))
        draw(draws[i](comparison, scene), figure_stem(results, scene.name, kind.name));
  draw_solver_scores(comparison, results);
}

}  // namespace rockstack::plots
