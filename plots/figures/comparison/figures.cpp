#include "plots/figures/comparison/figures.hpp"

#include <array>

#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {
namespace {

using Draw = Drawing (*)(const Comparison&, const ComparedScene&, const Styles&);

constexpr std::array<Draw, 12> draws{ground_motion, histories,    equations, differences, impact_times,
                                     energy,        phase,        occupancy, error_step,  first_impact_step,
                                     error_time,    distributions};

bool sampled(const ComparedScene& scene) {
  return scene.has("histories");
}

bool fitted(const ComparedScene& scene) {
  return scene.fitted;
}

}  // namespace

const std::vector<FigureKind>& figure_kinds() {
  static const std::vector<FigureKind> kinds{
      {"ground-motion", "Ground acceleration",
       "What shakes the blocks, to the right and upwards positive, up to the end of the scene. The mark is "
       "the "
       "largest absolute value.",
       [](const ComparedScene& scene) { return !scene.ground_motion.empty(); }},
      {"histories", "Angles over time",
       "One panel a block. The thick grey line with a black core is the exact solution; each engine is shown "
       "with its "
       "smallest time step, tuned where it was tuned. Ticks along the upper edge are the exact impacts at "
       "the "
       "interface under that block; the band at the bottom names the exact pattern. A curve that leaves its "
       "panel "
       "goes on beyond it.",
       sampled},
      {"equations", "Linear against nonlinear equations",
       "The exact solver with the full equations and with those that the paper linearises, one panel a "
       "block. "
       "Ticks and band are the exact motion's.",
       [](const ComparedScene& scene) { return sampled(scene) && scene.both_equations; }},
      {"differences", "Angle differences over time",
       "How far each engine is from the exact angle, on a logarithmic axis, as the largest absolute value of "
       "each "
       "short stretch of time. The dashed line is the tolerance; the filled mark on it is where the run "
       "first passes "
       "it, in whichever block; a run without one stays within it.",
       sampled},
      {"impact-times", "Impact times",
       "Each mark is an exact impact that the engine has too: above zero the engine is late, below it is "
       "early. The "
       "axis is logarithmic on both sides and linear across the middle. The rows below hold the exact "
       "impacts that "
       "an engine misses, and those of its own that match none.",
       [](const ComparedScene& scene) { return scene.has("impacts"); }},
      {"energy", "Energy",
       "Kinetic and potential energy in the ground's frame. In free rocking the exact one is a staircase: it "
       "falls "
       "at impacts and nowhere else. Below, by how much the engines are off: where their curve rises without "
       "a ground "
       "that moves, contacts make energy.",
       [](const ComparedScene& scene) { return sampled(scene) && scene.has("bodies"); }},
      {"phase", "Phase portraits",
       "Each block's angle against its angular velocity, from the release inwards. Impacts are the jumps; a "
       "curve that "
       "leaves its panel goes on beyond it.",
       sampled},
      {"occupancy", "Time in each pattern",
       "The share of time spent in each pattern of contacts, read from the angles of all motions alike; the "
       "exact "
       "motion's longest first. The words at the lower right say for how much of the "
       "time a motion is in the exact one's pattern.",
       [](const ComparedScene& scene) { return scene.has("patterns"); }},
      {"error-step", "Error against time step",
       "Each mark is a run. The line through them is the fit error = model error + c · dtᵖ, with its order p "
       "and the model error "
       "that no step takes away, each with 95 % bounds. Levels across are the model errors: dashed, or "
       "dotted where "
       "the bounds include none.",
       fitted},
      {"first-impact-step", "Time of the first impact against time step",
       "The same for the absolute difference in time of the first impact, which no impact before it has "
       "disturbed.",
       fitted},
      {"error-time", "Error against computing time",
       "Each mark is a run, labelled with its time step where there is room, or in a sweep of iterations at "
       "one step "
       "with their number: lower is nearer to the exact "
       "solution, further left is "
       "faster. Filled marks are tuned settings, open ones defaults, stars and crosses sets with a parameter "
       "changed. "
       "The vertical line is the time the exact "
       "solver "
       "takes. Levels across are model errors, where a fit over the time steps tells them: "
       "dashed, or "
       "dotted where its bounds include none.",
       [](const ComparedScene& scene) { return scene.has("angles"); }},
      {"distributions", "Distributions over perturbed scenes",
       "The share of slightly perturbed scenes in which a quantity is at most the value below. Where "
       "histories part by "
       "nature, these are what can be compared: D is the largest vertical distance from the exact solution's "
       "curve, and "
       "beside it the distance that two samples of one distribution exceed once in twenty times.",
       [](const ComparedScene& scene) { return scene.perturbed; }},
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
  const Styles styles = assign_styles(comparison.runs);
  for (const ComparedScene& scene : comparison.scenes)
    for (std::size_t i = 0; i < draws.size(); ++i)
      if (const FigureKind& kind = figure_kinds()[i]; has_figure(scene, kind))
        draw(draws[i](comparison, scene, styles), figure_stem(results, scene.name, kind.name));
}

}  // namespace rockstack::plots
