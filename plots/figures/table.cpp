#include "plots/data/scores.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {

using DrawScene = Drawing(const SceneSubject&);
DrawScene histories, readings, slip, friction, differences, impact_times, impact_energy, ranking, split_parts,
    error_time, error_step, first_impact_step, toppling, distributions, equations, energy, phase, occupancy,
    ground_motion;
using DrawComparison = Drawings(const ComparisonSubject&);
DrawComparison agreement, solver_scores;
using DrawFolder = Drawings(const FolderSubject&);
DrawFolder fragility, incremental, overturning, modes, law_maps, law_engines, stability, record, advice, fit,
    branches;

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

std::vector<Figure> scene_figures() {
  return {
      {"histories", "Angles over time", "How do the blocks move?",
       "A small panel a solver and set, for each block in turn: its coarsest step dashed and its finest "
       "one solid on the thick grey exact curve; tuned settings where there are some. Shaded is what the "
       "middle half of its replicates lie between. Ticks along the "
       "upper edge are the exact impacts at the interface under that block; the band at the bottom names "
       "the exact pattern. The time shown is that of the motion, without the rest after it; grey is what "
       "lies beyond the horizon of predictability. A curve that leaves its panel goes on beyond it.",
       OfScene{sampled, histories}},
      {"readings", "Beside the test", "How near do motions come to what was measured?",
       "Marks: what was measured, an angle or how far a point of a block has moved along the ground. Lines: "
       "the exact motion and engines there.",
       OfScene{tested, readings}},
      {"slip", "Slip and gap", "How far do blocks slide, and when do they fly?",
       "The slip of each block along what is below it, to the right positive, and its distance from it "
       "where there ever is one: a gap above zero is a flight. The thick grey line is the exact motion; "
       "engines are shown as far as they tell their slip. A curve that leaves its panel goes on beyond it.",
       OfScene{slips, slip}},
      {"friction", "Friction", "What does friction do?",
       "Angles and slips of the exact motion with several coefficients of friction at all interfaces; the "
       "thick grey line is the motion by the scene's own law.",
       OfScene{frictions, friction}},
      {"differences", "Angle differences over time", "How far off is each engine, and from when?",
       "The largest absolute value of each short stretch of time, on a logarithmic axis; a curve that "
       "leaves its panel below is nearer still. The dashed line is the tolerance. The rows at the bottom "
       "say when each replicate first passes it, in whichever block: crosses are replicates, the large "
       "mark their median; at the right end stands what never does.",
       OfScene{compared, differences}},
      {"impact-times", "Impact times", "How late or early is each impact?",
       "Each mark is an exact impact that the engine has too: above zero the engine is late, below it is "
       "early. The axis is logarithmic on both sides and linear across the middle. The rows below hold the "
       "exact impacts that an engine misses, and those of its own that match none.",
       OfScene{impacts, impact_times}},
      {"impact-energy", "Energy lost at each impact", "Does each impact lose what it should?",
       "Above, the exact losses. Below, by how much more the engine loses, in percent of the exact loss, "
       "counted from halfway to the impact before to halfway to that after, so that a late impact is "
       "compared with itself. Impacts that lose less than a thousandth of the largest are left out; marks "
       "on the edge lie at or beyond 100 %.",
       OfScene{losses, impact_energy}},
      {"ranking", "Ranking", "Which is nearest to the exact motion?",
       "A row a solver and set, or a number of iterations where these vary; a column a time step. Marks "
       "are medians over replicates, thick bars quartiles, thin ones the whole range. The words above say "
       "which rows share the first rank: those that no test of replicates tells apart.",
       OfScene{errors, ranking}},
      {"parts", "Contact model, contact softness, time step", "What is a difference made of?",
       "Three bars a row: from the exact motion to the exact one on rigid contacts with the engine's "
       "friction; from there to the exact one on springs as soft as the engine's contacts; from there to "
       "the engine. The first does not depend on the engine's step, the last is what a smaller step may "
       "take away. Bars that end on the left edge are smaller, or nothing.",
       OfScene{split, split_parts}},
      {"error-time", "Error against computing time", "What does accuracy cost?",
       "Each mark is a run, labelled with its time step where there is room, or in a sweep of iterations "
       "at one step with their number: lower is nearer to the exact solution, further left is faster. "
       "Filled marks are tuned settings, open ones defaults, stars and crosses sets with a parameter "
       "changed. Lines join neighbours whose errors tell a trend. The vertical line is the time the exact "
       "solver takes. Levels across are model errors, where a fit over the time steps tells them: dashed, "
       "or dotted where its bounds include none.",
       OfScene{errors, error_time}},
      {"error-step", "Error against time step", "What does a smaller step bring?",
       "Each mark is a run. The line through them is the fit error = model error + c · dtᵖ, with its order "
       "p and the model error that no step takes away, each with 95 % bounds. Levels across are the model "
       "errors: dashed, or dotted where the bounds include none.",
       OfScene{fitted, error_step}},
      {"first-impact-step", "Time of the first impact against time step",
       "Does the first impact come in time?",
       "The same for the absolute difference in time of the first impact, which no impact before it has disturbed.",
       OfScene{fitted, first_impact_step}},
      {"toppling", "Scenes that topple", "How many scenes that differ a little topple?",
       "The share of slightly perturbed scenes in which it does, with 95 % bounds, and in how many of them "
       "the engine's answer is the exact one.",
       OfScene{perturbed, toppling}},
      {"distributions", "Distributions over perturbed scenes", "Are engines right on the whole?",
       "The share of slightly perturbed scenes in which a quantity is at most the value below. Where "
       "histories part by nature, these are what can be compared: D is the largest vertical distance from "
       "the exact solution's curve, and beside it the distance that two samples of one distribution exceed "
       "once in twenty times.",
       OfScene{perturbed, distributions}},
      {"equations", "Linear against nonlinear equations", "What does linearising change?",
       "The exact solver with the full equations and with those that the paper linearises, one panel a "
       "block. Ticks and band are the exact motion's.",
       OfScene{both_equations, equations}},
      {"energy", "Energy", "Do engines lose energy as they should?",
       "Kinetic and potential energy in the ground's frame. In free rocking the exact one is a staircase: "
       "it falls at impacts and nowhere else. Below, how far engines are off, as the median between exact "
       "impacts, so that a late impact does not hide a drift: where their curve rises without a ground "
       "that moves, contacts make energy.",
       OfScene{bodies, energy}},
      {"phase", "Phase portraits", "Which path does each block take?",
       "Its angle against its angular velocity: a swing is a loop, an impact a jump, and a path inside the "
       "exact one has lost more energy. A curve that leaves its panel goes on beyond it.",
       OfScene{compared, phase}},
      {"occupancy", "Time in each pattern", "Are engines in the exact pattern?",
       "The share of time spent in each pattern of contacts, read from the angles of all motions alike; "
       "the exact motion's longest first, as grey bars. The words below say for how much of the time a "
       "motion is in the exact one's pattern.",
       OfScene{patterns, occupancy}},
      {"ground-motion", "Ground acceleration", "What shakes the blocks?",
       "The acceleration to the right and upwards positive, up to the end of the scene. The mark is the "
       "largest absolute value.",
       OfScene{shaken, ground_motion}},
  };
}

std::vector<Figure> study_figures() {
  return {
      {"fragility", "Fragility", "How likely is toppling?",
       "Marks: the share of runs that topple at each intensity, with its confidence bounds. Line: the "
       "fitted lognormal curve, where there is one.",
       OfFolder{"fragility.csv", fragility, true}},
      {"incremental", "Incremental", "How strong a motion does it bear?",
       "Marks: runs, each motion at each intensity. Lines: the angle over the slenderness that half of the "
       "motions, and 16 and 84 % of them, stay within up to an intensity; they never turn back, unlike "
       "those in the table, which are of each intensity by itself. Blocks that topple stand at the right.",
       OfFolder{"incremental.csv", incremental}},
      {"overturning", "Overturning", "What topples?",
       "What becomes of the block at each frequency and intensity of the pulse: it stays at rest, rocks, "
       "topples after an impact, or topples without one.",
       OfFolder{"overturning.csv", overturning}},
      {"modes", "Modes", "Does it slide, rock or fly?",
       "What the stack does at each friction and intensity: on the left the mode in which motion begins, "
       "on the right all of it. Black lines, where there are some, are Shenton's boundaries of a single "
       "block under a rectangular pulse.",
       OfFolder{"modes.csv", modes}},
      {"stability", "Stability", "Where does it stop being right?",
       "Each square is a run: across, the value that the study varies; up, the time step. Under the black "
       "line steps are stable.",
       OfFolder{"stability.csv", stability}},
      {"impact-laws.engines", "How far every engine run is from either law", "Whose side do engines take?",
       "Each mark is a run: across, how far its velocities after the impact are from those of law paper; "
       "up, from those of law consistent, on logarithmic axes. Under the dashed line it is nearer to law "
       "consistent. Small marks are runs at longer time steps.",
       OfFolder{"impact-laws-engines.csv", law_engines}},
      {"impact-laws", "Where the laws differ", "Where do the laws differ?",
       "Each map is one kind of impact. Across: height over width of the top block; up: its mass over that "
       "of the block below; darker: a larger share of the impacts. Kinds with a share below one in a "
       "hundred are left out; grey squares have no impact that was judged.",
       OfFolder{"impact-laws.csv", law_maps}},
      {"advice", "Cost and error of what was tried", "What is the cheapest that is near enough?",
       "Each mark is a trial, labelled with its time step where there is room: across, the computing time; up, "
       "the largest difference from the exact motion until it can no longer be predicted, of an angle in rad "
       "or of a centre as a share of the least block height. Under the dashed line nine of ten replicates "
       "must lie; trials where they do have a ring, and the cheapest of them has a second one.",
       OfFolder{"advice.json", advice, true}},
      {"branches", "Branches", "Which motions obey?",
       "Angles of all motions that obey the laws of contact; below, when each leaves which other one, what its "
       "contacts take there, and how it ends. A line is broken where its motion is that of an earlier branch "
       "again, or its mirror image.",
       OfFolder{"branches.csv", branches}},
      {"fit", "Fit", "How near does the model come to the test?",
       "Marks: what was measured; line: the fitted motion; below, the one less the other. Up to the dashed line, "
       "the horizon of predictability, they were held together.",
       OfFolder{"fit.json", fit}},
      {"record", "Record", "How strong and how long is the record?",
       "Acceleration, velocity and displacement with their peaks; the shaded span is the significant "
       "duration. Below, the growth of the Arias intensity and the response spectrum.",
       OfFolder{"record.csv", record, true}},
  };
}

std::vector<Figure> all_figures() {
  std::vector<Figure> list{
      {"agreement", "Until when engines agree", "Until when does each engine agree, and how far off is it?",
       "Each row is a solver with one set, each line a time step, the coarser the fainter; each column is a scene, as far as its motion. Above, the "
       "time until which angles and centres stay within the tolerance, with quartiles over replicates in "
       "black; a line to the right edge agrees to the end; grey is what lies beyond the scene's horizon of predictability, where nothing is compared. "
       "Below, the largest difference up to there: of an angle in rad, or of a centre as a share of the "
       "least block height, whichever is larger; on the left edge stands what is smaller.",
       OfComparison{agreement}}};
  for (Figure& one : scene_figures()) list.push_back(std::move(one));
  for (const SolverQuestion& one : solver_questions())
    list.push_back(
        {"solvers." + one.name, "All solvers: " + one.name, one.question,
         "A row a solver and set, those first that answer for all scenes; a small cross a scene, a large "
         "mark the median of all. Rows whose scenes lie among each other are not told apart.",
         OfComparison{solver_scores}});
  for (Figure& one : study_figures()) list.push_back(std::move(one));
  return list;
}

void draw_all(const Figure& figure, const Drawings& drawings, const std::filesystem::path& results) {
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

std::filesystem::path figure_stem(const std::filesystem::path& results, const ComparedScene& scene,
                                  const Figure& figure) {
  return results / "figures" / (scene.alone ? figure.name : scene.name + "." + figure.name);
}

void draw_figures(const std::filesystem::path& results, const Comparison& comparison) {
  for (const ComparedScene& scene : comparison.scenes)
    for (const Figure* figure : figures_of(scene))
      draw(std::get<OfScene>(figure->of).draw({*figure, comparison, scene}),
           figure_stem(results, scene, *figure));
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<OfComparison>(&figure.of); of != nullptr)
      draw_all(figure, of->draw({figure, comparison}), results);
}

void draw_figures(const std::filesystem::path& results) {
  for (const Figure& figure : figures()) {
    const auto* of = std::get_if<OfFolder>(&figure.of);
    if (of == nullptr || !std::filesystem::exists(results / of->needs)) continue;
    Drawings drawings = of->draw({figure, results});
    if (of->narrow) drawings[narrow_part] = of->draw({figure, results, narrow_width}).at("");
    draw_all(figure, drawings, results);
  }
}

}  // namespace rockstack::plots
