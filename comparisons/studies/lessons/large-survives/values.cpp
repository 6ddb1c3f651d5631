#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

constexpr std::array block_heights{0.5, 1.0, 2.0, 4.0};  // m

double height_of(const Scene& scene) {
  return 2 * scene.blocks.front().half_height;
}

/// The scene with its block made larger each way.
Scene as_high(Scene scene, double height) {
  Block& block = scene.blocks.front();
  constexpr double density = 2500;  // kg/m³
  block = make_block(2 * block.half_width * height / height_of(scene), height, density);
  return scene;
}

/// Least acceleration at which the block leaves its base, g tan α, m/s².
double lifting_acceleration(const Scene& scene) {
  return scene.gravity * scene.blocks.front().half_width / scene.blocks.front().half_height;
}

/// Housner's rate, 1/s.
double housner_rate(const Scene& scene) {
  const Block& block = scene.blocks.front();
  return std::sqrt(3 * scene.gravity / (4 * std::hypot(block.half_width, block.half_height)));
}

/// The motion under a pulse of that many times lifting_acceleration(), for so long that a block which
/// hesitates decides.
History pushed(Scene scene, double strength, const SolveOptions& options = {}) {
  constexpr double decided = 60;  // s
  scene.horizontal.pulse->amplitude = strength * lifting_acceleration(scene);
  return solve(lasting(scene, decided), options);
}

bool topples_under(const Scene& scene, double strength) {
  return first_event(pushed(scene, strength), EventKind::topple) != nullptr;
}

/// The strength between two at which a block that topples comes to stand, or the other way round.
double toppling_strength(const Scene& scene, double low, double high) {
  return crossing(low, high, [&](double strength) { return topples_under(scene, strength) ? 1.0 : -1.0; });
}

/// Strengths from which on the block topples, stands again, and topples again.
std::vector<double> changes(const Scene& scene) {
  constexpr double step = 0.05, most = 14;
  std::vector<double> list;
  for (double strength = 1; strength < most; strength += step)
    if (topples_under(scene, strength) != topples_under(scene, strength + step))
      list.push_back(toppling_strength(scene, strength, strength + step));
  return list;
}

/// The changes() of a block of each height.
using Boundaries = std::map<double, std::vector<double>>;

Table sizes(const Scene& scene, const Boundaries& boundaries) {
  Table table{{"height (m)", "p (1/s)", "ω/p", "topples from (g tan α)", "topples from (m/s²)"}};
  for (const auto& [height, list] : boundaries) {
    const double p = housner_rate(as_high(scene, height));
    table.rows.push_back({cell(height), fixed(p, 3),
                          fixed(2 * pi<double> / scene.horizontal.pulse->period / p, 2), fixed(list[0], 3),
                          fixed(list[0] * lifting_acceleration(scene), 2)});
  }
  return table;
}

Table strips(const Boundaries& boundaries) {
  Table table{{"height (m)", "topples from (g tan α)", "stands again from", "topples again from"}};
  for (const auto& [height, list] : boundaries)
    table.rows.push_back({cell(height), fixed(list[0], 3), fixed(list[1], 3), fixed(list[2], 3)});
  return table;
}

/// A constant push for the time T in place of the sine: the least one that topples, m/s².
Table constant_pushes(Scene scene) {
  Table table{
      {"height (m)", "p T", "formula (m/s²)", "solver, small angles (m/s²)", "solver, in full (m/s²)"}};
  Pulse& pulse = *scene.horizontal.pulse;
  pulse.shape = PulseShape::rectangle;
  for (const double height : block_heights) {
    scene = as_high(scene, height);
    const double pT = housner_rate(scene) * pulse.period;
    table.rows.push_back(
        {cell(height), fixed(pT, 3), fixed(scene.gravity * slenderness(scene, 0) / -std::expm1(-pT), 4)});
    for (const Equations equations : {Equations::small_angle, Equations::nonlinear}) {
      scene.equations = equations;
      table.rows.back().push_back(fixed(lifting_acceleration(scene) * toppling_strength(scene, 1, 10), 4));
    }
  }
  return table;
}

/// The height from which on a pulse of that strength topples no block, m.
double sure_height(const Scene& scene, double strength) {
  return crossing(block_heights[2], block_heights[3], [&](double height) {
    return topples_under(as_high(scene, height), strength) ? -1.0 : 1.0;
  });
}

/// How the block of the scene topples, where it does.
Table ways(const Scene& scene, const std::vector<double>& strengths) {
  Table table{{"pulse (g tan α)", "impacts before it topples", "topples"}};
  for (const double strength : strengths) {
    const History history = pushed(scene, strength);
    const Event* end = first_event(history, EventKind::topple);
    table.rows.push_back({fixed(strength, 1), end ? std::to_string(impacts_of(history).size()) : "",
                          !end                 ? "not at all"
                          : end->angles[0] < 0 ? "to the left"
                                               : "to the right"});
  }
  return table;
}

double friction_at(const Scene& scene, double strength) {
  return pushed(scene, strength, {.validity = true}).forces.front().friction;
}

}  // namespace

LessonValues large_survives_values(const Suite& suite, const std::vector<RunMetrics>& /*rows*/) {
  const Scene& scene = suite.scenes.front().scene;
  Boundaries boundaries;
  for (const double height : block_heights) boundaries[height] = changes(as_high(scene, height));
  const std::vector<double>&small = boundaries.at(1), &middle = boundaries.at(2), &large = boundaries.at(4);
  const double between = (middle[1] + middle[2]) / 2;
  const double enough = std::ceil(10 * large[0]) / 10;  // with one digit
  Scene model = as_high(scene, 1);
  model.horizontal.pulse->period /= 2;
  const double amplitude = scene.horizontal.pulse->amplitude;
  return {.numbers = {{"period", fixed(scene.horizontal.pulse->period, 1)},
                      {"amplitude", fixed(amplitude, 2)},
                      {"strength", fixed(amplitude / lifting_acceleration(scene), 0)},
                      {"lifting", fixed(lifting_acceleration(scene), 2)},
                      {"large_from", fixed(large[0], 2)},
                      {"ratio", fixed(large[0] / small[0], 1)},
                      {"model_from", fixed(changes(model)[0], 2)},
                      {"sure_height", fixed(sure_height(scene, 3), 2)},
                      {"between", fixed(between, 2)},
                      {"middle_again", fixed(middle[1], 2)},
                      {"middle_for_good", fixed(middle[2], 2)},
                      {"friction", fixed(friction_at(as_high(scene, 4), 0.999 * large[0]), 2)}},
          .tables = {{"sizes", sizes(scene, boundaries)},
                     {"pushes", constant_pushes(scene)},
                     {"strips", strips(boundaries)},
                     {"ways", ways(as_high(scene, 4), {5, enough, 2 * enough, 12})}},
          .player = {.time = 0, .speed = 0.5, .gain = 1},
          .measured = {{"enough", enough},
                       {"threshold_ratio", large[0] / small[0]},
                       {"topples_at_twice", topples_under(as_high(scene, 4), 2 * enough) ? 1.0 : 0.0}}};
}

}  // namespace rockstack
