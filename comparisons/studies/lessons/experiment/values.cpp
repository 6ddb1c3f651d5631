#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve.hpp"
#include "comparisons/studies/lessons/lesson.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

/// What was measured of blocks that rocked freely: the ratio of angular velocities over an impact, as a share
/// of what their shape alone would have it. M. A. ElGawady, Q. Ma, J. W. Butterworth, J. Ingham, "Effects of
/// interface material on the dynamic behaviour of rigid blocks", Progress in Mechanics of Structures and
/// Materials (2007).
struct Measured {
  double height_over_width;
  const char* base;
  double share;
};

constexpr Measured measured[]{{5, "concrete", 0.95}, {5, "rubber", 0.67}, {3, "concrete", 0.97}};

/// Spread of the ratio between releases that are meant to be the same: an assumption, not a measurement.
constexpr double assumed_spread = 0.01;

/// The scene's block in that shape, of the same height, let go at the same share of its slenderness, with
/// that ratio.
Scene block_of(Scene scene, const Measured& one, double ratio) {
  const Block& old = scene.blocks.front();
  const double slenderness = std::atan2(old.half_width, old.half_height);
  const double share = scene.initial.angles.front() / slenderness, height = 2 * old.half_height;
  scene.blocks = {make_block(height / one.height_over_width, height, 2500)};
  scene.initial.angles = {share * std::atan(1 / one.height_over_width)};
  scene.restitution = {ratio};
  return scene;
}

std::vector<double> impact_times(const Scene& scene) {
  return mapped(impacts_of(solve(scene)), &Event::time);
}

Table shapes() {
  Table table{{"height over width", "base", "ratio by shape", "ratio measured", "energy kept by shape",
               "energy kept, measured", "impacts to a tenth of the energy, by shape", "the same, measured"}};
  for (const Measured& one : measured) {
    const double shape = impact_ratio(one.height_over_width), found = one.share * shape;
    table.rows.push_back({cell(one.height_over_width), one.base, fixed(shape, 3), fixed(found, 3),
                          percent(shape * shape, 1), percent(found * found, 1),
                          cell(impacts_to_share(0.1, shape)), cell(impacts_to_share(0.1, found))});
  }
  return table;
}

/// When the n-th impact comes where the ratio is that much more or less.
Table spreads(const Scene& scene, const Measured& one) {
  const double ratio = one.share * impact_ratio(one.height_over_width);
  Table table{
      {"impact", "ratio 1 % less (s)", "ratio as measured (s)", "ratio 1 % more (s)", "between them (s)"}};
  const std::vector<double> middle = impact_times(block_of(scene, one, ratio)),
                            less = impact_times(block_of(scene, one, ratio * (1 - assumed_spread))),
                            more = impact_times(block_of(scene, one, ratio * (1 + assumed_spread)));
  for (const std::size_t n : {1U, 2U, 5U, 10U, 15U})
    table.rows.push_back({std::to_string(n), cell(less.at(n - 1)), cell(middle.at(n - 1)),
                          cell(more.at(n - 1)), cell(more.at(n - 1) - less.at(n - 1))});
  return table;
}

}  // namespace

LessonValues experiment_values(const Suite& suite, const std::vector<RunMetrics>& rows) {
  const Scene& scene = suite.scenes.front().scene;
  const Measured &concrete = measured[0], &rubber = measured[1];
  const double shape = impact_ratio(concrete.height_over_width), found = concrete.share * shape;
  const auto fifth = [](const Scene& one) { return impact_times(one).at(4); };
  const double by_shape = fifth(block_of(scene, concrete, shape)),
               by_ratio = fifth(block_of(scene, concrete, found)),
               on_rubber = fifth(block_of(scene, rubber, rubber.share * shape));
  const std::vector<double> shape_times = impact_times(block_of(scene, concrete, shape));
  const auto measured_times = impact_times(block_of(scene, concrete, found)),
             later_times = impact_times(block_of(scene, concrete, found + 0.01));
  const RunMetrics& ode = find_run(rows, "ode", 1e-3);
  return {.numbers = {{"shape", fixed(shape, 4)},
                      {"concrete", fixed(found, 4)},
                      {"rubber", fixed(rubber.share * shape, 4)},
                      {"concrete_share", fixed(concrete.share, 2)},
                      {"squat_share", fixed(measured[2].share, 2)},
                      {"rubber_share", fixed(rubber.share, 2)},
                      {"kept_shape", percent(shape * shape, 1)},
                      {"kept_concrete", percent(found * found, 1)},
                      {"lost_more", fixed((1 - found * found) / (1 - shape * shape), 1)},
                      {"fifth_shape", fixed(by_shape, 3)},
                      {"fifth_concrete", fixed(by_ratio, 3)},
                      {"fifth_rubber", fixed(on_rubber, 3)},
                      {"fifth_early", fixed(by_shape - by_ratio, 3)},
                      {"fifth_later", fixed(later_times.at(4) - measured_times.at(4), 3)},
                      {"tenth_later", fixed(later_times.at(9) - measured_times.at(9), 3)},
                      {"tenth", fixed(measured_times.at(9), 2)},
                      {"second_swing", fixed(shape_times.at(1) - shape_times.at(0), 2)},
                      {"six_impacts", fmt::format("{}", fmt::join(std::span(shape_times).first(6), ", "))},
                      {"tenth_swing", fixed(measured_times.at(9) - measured_times.at(8), 2)},
                      {"engine_late", quantity_text(std::abs(*ode.first_impact_time_difference), "s", 2)},
                      {"spread", percent(assumed_spread, 0)}},
          .tables = {{"shapes", shapes()}, {"spreads", spreads(scene, concrete)}},
          .player = {.time = 0, .speed = 0.5, .gain = 2},
          .measured = {{"fifth_early", by_shape - by_ratio},
                       {"lost_more", (1 - found * found) / (1 - shape * shape)}}};
}

}  // namespace rockstack
