#include <fmt/format.h>
#include <fmt/ranges.h>

#include "comparisons/measures/metrics/branches.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

constexpr double reading = 0.02;                 // s after the start, at which motions are told apart
constexpr CornerSpring stiff_spring{1e10, 1e7};  // N/m, N·s/m

/// What the exact solver makes of the start, in the words of its events.
std::string start_of(const History& history) {
  const bool at_once = !history.events.empty() && history.events.front().time == 0;
  const Consistency found = at_once ? history.events.front().consistency : Consistency::consistent;
  return found == Consistency::none ? "none" : found == Consistency::several ? "several" : "one";
}

/// The four signs: with and without a rotation that takes the corner off, on either side of the friction that
/// jams.
Table four_cases(Scene scene) {
  Table table{{"friction", "ω (rad/s)", "A (m/s²)", "m B", "N that satisfy the laws, closed form (weights)",
               "N exact (weights)", "motions without impulse, exact solver"}};
  const double weight = weight_of(scene), mass = scene.blocks.front().mass, rough = scene.friction.front(),
               fast = scene.initial.velocities.front();
  for (const double friction : {0.5, rough})
    for (const double rate : {0.0, fast}) {
      scene.friction = {friction};
      scene.initial.velocities = {rate};
      const SlidingCorner corner = sliding_corner(scene);
      const auto forces =
          mapped(corner.forces(), [&](double force) { return force == 0 ? "0" : fixed(force / weight, 4); });
      const History exact = exact_answer(lasting(scene, reading));
      const std::string start = start_of(exact);
      table.rows.push_back(
          {cell(friction), cell(rate), cell(corner.free), cell(mass * corner.slope),
           forces.empty() ? "none" : fmt::format("{}", fmt::join(forces, " or ")),
           start == "none" ? "an impulse" : fixed(exact.reactions.front().normal / weight, 4), start});
    }
  return table;
}

/// What tells motions apart a moment later: how fast the block turns, and how far its centre has come.
std::vector<std::string> early_cells(const History& history) {
  const double moved = history.centres[history.centres.size() - 2] - history.centres.front();
  return {fixed(history.velocities.back(), 4), fixed(1e3 * moved, 2)};
}

/// The motions that obey, and what engines do with the scene where none but an impulse does, and with the one
/// where several do.
Table early_motions(const Scene& jams, const Scene& several, const BranchTree& tree) {
  Table table{{"motion", "step (s)", "none: ω (rad/s)", "none: centre moved (mm)", "several: ω (rad/s)",
               "several: centre moved (mm)"}};
  const auto add = [&](const std::string& name, const std::string& step, const std::vector<std::string>& none,
                       const History& other) {
    const std::vector<std::string> several_cells = early_cells(other);
    table.rows.push_back({name, step, none[0], none[1], several_cells[0], several_cells[1]});
  };
  for (const Branch& branch : tree.branches)
    add(fmt::format("exact, branch {}: goes on with {}", &branch - tree.branches.data() + 1,
                    branch.start ? shown_pattern(branch.start->ways[branch.start->taken])
                                 : shown_pattern(branch.history.events.front().to)),
        "", {"", ""}, branch.history);
  Scene stuck = several;
  stuck.initial.velocities = {rate_once_stuck(several)};
  stuck.initial.slip_velocities = {0};
  add("exact, after an impulse that stops the slip", "", early_cells(exact_answer(jams)),
      exact_answer(stuck));
  const auto on_springs = [](const Scene& scene) {
    return exact_answer(with_springs(scene, scene.friction, stiff_spring));
  };
  add("exact, on stiff springs", "", early_cells(on_springs(jams)), on_springs(several));
  for (const char* engine : {"ode:step", "ode:quickstep", "bullet"})
    for (const double dt : {1e-3, 1e-4})
      add(engine, cell(dt), early_cells(answer(engine, jams, dt)), answer(engine, several, dt));
  return table;
}

Table branches_of(const Scene& scene, const BranchTree& tree) {
  const auto rows = branches_json(scene, tree);
  const auto blocks = static_cast<int>(scene.blocks.size());
  Table table{
      {"branch", "leaves branch", "from (s)", "with pattern", "instead of pattern", "ends with", "at (s)"}};
  const auto text = [](const Json& value) {
    return value.is_null() ? "" : value.is_string() ? value.get<std::string>() : value.dump();
  };
  const auto pattern = [&](const Json& value) {
    return value.is_null() ? "" : shown_pattern(named_pattern(value.get<std::string>(), blocks));
  };
  for (const auto& row : rows)
    table.rows.push_back({text(row["branch"]), text(row["parent"]), text(row["time"]), pattern(row["takes"]),
                          pattern(row["instead_of"]), text(row["ends"]), text(row["end_time"])});
  return table;
}

}  // namespace

LessonValues complementarity_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& several = suite.scenes.front().scene;
  const Scene& jams = suite.scenes.at(1).scene;
  const Block& block = several.blocks.front();
  const double angle = several.initial.angles.front();
  constexpr std::size_t most = 16;
  const SolveOptions sampled{.sample_times = {0, reading}};
  const BranchTree early = solve_branches(lasting(several, reading), sampled, most);
  const double braked = early.branches.at(1).history.events.front().time;
  const double jammed = first_event(exact_answer(jams), EventKind::impact)->after.front();
  const double chosen = answer("ode:quickstep", lasting(several, reading), 1e-3).velocities.back();
  const double r = block.half_height / block.half_width;
  return {
      .numbers = {{"angle", fixed(angle, 1)},
                  {"friction", fixed(several.friction.front(), 1)},
                  {"limit", fixed(jamming_friction(block, angle), 4)},
                  {"upright", fixed(jamming_friction(block, 0), 4)},
                  {"r", fixed(r, 0)},
                  {"off",
                   fixed(std::sqrt(several.gravity / (sliding_corner(several).free + several.gravity)) *
                             several.initial.velocities.front(),
                         4)},
                  {"rate", fixed(several.initial.velocities.front(), 1)},
                  {"slip", fixed(jams.initial.slip_velocities.front(), 0)},
                  {"jammed", fixed(jammed, 4)},
                  {"jammed_form", fixed(rate_once_stuck(jams), 4)},
                  {"impulse_rate", fixed(rate_once_stuck(several), 4)},
                  {"braked", fixed(1e3 * braked, 2)},
                  {"chosen", fixed(chosen, 3)},
                  {"stiffness", power(stiff_spring.stiffness, 0)},
                  {"damping", power(stiff_spring.damping, 0)},
                  {"reading", fixed(1e3 * reading, 0)}},
      .tables = {{"cases", four_cases(several)},
                 {"early", early_motions(lasting(jams, reading), lasting(several, reading), early)},
                 {"branches",
                  branches_of(several,
                              solve_branches(several, {.sample_times = regular_times(1e-3, several.duration)},
                                             most))}},
      .player = {.time = 0, .speed = 0.05, .gain = 1},
      .measured = {{"jammed", jammed}, {"chosen", chosen}}};
}

}  // namespace rockstack
