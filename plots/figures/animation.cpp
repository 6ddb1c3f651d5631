#include "plots/figures/animation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analytic/scene/kinematics.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "plots/data/contacts.hpp"
#include "plots/data/events.hpp"
#include "plots/data/selection.hpp"
#include "plots/drawing/layout.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/figures.hpp"

namespace rockstack::plots {
namespace {

constexpr double frame_rate = 25;  // 1/s

/// One column of the picture.
struct Actor {
  Run run;
  std::string colour;
  std::vector<std::vector<double>> samples;  ///< times, then angles of each block, then its x and y if told
};

/// Everything that frames are made of.
struct Stage {
  const ComparedScene& scene;
  std::vector<Actor> actors;
  std::vector<PatternSpan> spans;
  Stack<double> stack;
  double end = 0;    ///< s
  double side = 0;   ///< half the width of a column, m
  double above = 0;  ///< top of the picture, m
};

Stack<double> stack_of(const std::vector<StackBlock>& blocks) {
  const auto size = static_cast<Eigen::Index>(blocks.size());
  const Vector<double> zero = Vector<double>::Zero(size);
  Stack<double> stack{zero, zero, zero, zero, zero, zero, {}};
  for (Eigen::Index k = 0; k < size; ++k) {
    const StackBlock& block = blocks[static_cast<std::size_t>(k)];
    const double below = k > 0 ? blocks[static_cast<std::size_t>(k) - 1].width : block.width;
    stack.half_width[k] = std::min(block.width, below) / 2;
    stack.half_height[k] = stack.centre_y[k] = block.height / 2;
  }
  return stack;
}

/// All columns but the time, between samples on straight lines; held after the end.
Vector<double> values_at(const Actor& actor, double time) {
  const std::vector<double>& times = actor.samples.front();
  const auto after = std::upper_bound(times.begin(), times.end(), time) - times.begin();
  const auto high = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(times) - 1));
  const double span = times[high] - times[high - 1];
  const double part = span > 0 ? std::clamp((time - times[high - 1]) / span, 0.0, 1.0) : 1;
  Vector<double> values(static_cast<Eigen::Index>(actor.samples.size()) - 1);
  for (std::size_t k = 1; k < actor.samples.size(); ++k)
    values[static_cast<Eigen::Index>(k) - 1] =
        actor.samples[k][high - 1] * (1 - part) + actor.samples[k][high] * part;
  return values;
}

/// Where the middle of a block is: its centre of mass as the results have it, less its way from the middle.
Point<double> told_middle(const StackBlock& block, double x, double y, double angle) {
  return Point<double>(x, y) - turned(block.offset_x, block.offset_y, std::cos(angle), std::sin(angle));
}

/// The middles of all blocks: as the results tell them, else from the angles, about the corners.
Points<double> middles_at(const Stage& stage, const Vector<double>& values) {
  const auto blocks = std::ssize(stage.scene.stack);
  const Vector<double> angles = values.head(blocks);
  if (values.size() == blocks) {
    const Vector<double> gaps = relative(angles);
    return centres(make_chain(stage.stack, pattern_of(gaps, gaps), angles));
  }
  Points<double> middles(2, blocks);
  for (Eigen::Index k = 0; k < blocks; ++k)
    middles.col(k) = told_middle(stage.scene.stack[static_cast<std::size_t>(k)], values[blocks + 2 * k],
                                 values[blocks + 2 * k + 1], angles[k]);
  return middles;
}

/// The corners of a block as a polygon, `middle` m along the picture.
std::string polygon(const StackBlock& block, const Point<double>& centre, double angle, double middle) {
  std::string text;
  const double b = block.width / 2, h = block.height / 2;
  const std::array<std::array<double, 2>, 5> corners{{{-b, -h}, {b, -h}, {b, h}, {-b, h}, {-b, -h}}};
  for (const auto& [a, c] : corners) {
    const Point<double> corner = centre + turned(a, c, std::cos(angle), std::sin(angle));
    text += fmt::format("{}{:.5g},{:.5g}", text.empty() ? "" : " to ", middle + corner.x(), corner.y());
  }
  return text;
}

std::string drawn(const Stage& stage, std::size_t index, double time) {
  const Actor& actor = stage.actors[index];
  const Vector<double> values = values_at(actor, time);
  const Points<double> middles = middles_at(stage, values);
  const double middle = (2 * static_cast<double>(index) + 1) * stage.side;
  std::string text;
  for (Eigen::Index k = 0; k < middles.cols(); ++k)
    text += fmt::format(
        "set object polygon from {} fillstyle transparent solid 0.18 border lc rgb '{}' fillcolor rgb '{}' "
        "lw 2\n",
        polygon(stage.scene.stack[static_cast<std::size_t>(k)], middles.col(k), values[k], middle),
        actor.colour, actor.colour);
  return text;
}

std::string pattern_at(const std::vector<PatternSpan>& spans, double time) {
  std::string pattern;
  for (const PatternSpan& span : spans)
    if (span.from <= time) pattern = span.pattern;
  return pattern;
}

std::string frame(const Stage& stage, double time) {
  std::string text = "unset object\n";
  for (std::size_t i = 0; i < stage.actors.size(); ++i) text += drawn(stage, i, time);
  const std::string pattern = pattern_at(stage.spans, time);
  const std::string label =
      fmt::format("{:.2f} s{}", time, pattern.empty() ? "" : ", exact pattern " + shown_pattern(pattern));
  return text + fmt::format("set label 1 {} noenhanced at graph 0.5, graph 0.965 center\nplot NaN notitle\n",
                            in_quotes(label));
}

/// How fast a film runs: as players do at first.
double speed_of(double duration) {
  constexpr double long_motion = 8, short_motion = 2;
  return duration > long_motion ? 1 : duration > short_motion ? 0.5 : 0.1;
}

std::string speed_text(double speed) {
  return speed < 1 ? fmt::format(" (1/{:.0f} of the speed)", 1 / speed) : "";
}

/// Two engines at most: more would be too small to look at.
std::vector<Actor> actors_of(const Comparison& comparison, const ComparedScene& scene) {
  const Shown shown = shown_runs(comparison, scene.name);
  std::vector<Run> runs = shown.exact;
  for (const Run& run : shown.engines)
    if (runs.size() < shown.exact.size() + 2 && !std::isnan(run.dt)) runs.push_back(run);
  std::vector<Actor> actors;
  for (const Run& run : runs) {
    std::vector<std::string> names = numbered("theta_", scene.blocks);
    names.insert(names.begin(), "time");
    if (has_column(run, "x_1"))
      for (int k = 1; k <= scene.blocks; ++k)
        names.insert(names.end(), {fmt::format("x_{}", k), fmt::format("y_{}", k)});
    Actor actor{run, style_of(run).colour, read_columns(run.folder / "history.csv", names)};
    if (actor.samples.front().size() > 1) actors.push_back(std::move(actor));
  }
  return actors;
}

Stage stage_of(const Comparison& comparison, const ComparedScene& scene) {
  Stage stage{
      .scene = scene, .actors = actors_of(comparison, scene), .spans = {}, .stack = stack_of(scene.stack)};
  const auto blocks = static_cast<std::size_t>(scene.blocks);
  double height = 0, width = 0, most = 0, across = 0, up = 0;
  for (const StackBlock& block : scene.stack) height += block.height, width = std::max(width, block.width);
  for (const Actor& actor : stage.actors) {
    stage.end = std::max(stage.end, actor.samples.front().back());
    for (std::size_t k = 1; k <= blocks; ++k)
      for (const double angle : actor.samples[k]) most = std::max(most, std::abs(angle));
    for (std::size_t c = blocks + 1; c < actor.samples.size() && actor.run.exact(); ++c) {
      const StackBlock& block = scene.stack[(c - blocks - 1) / 2];
      double& far = (c - blocks) % 2 == 1 ? across : up;
      for (const double place : actor.samples[c])
        far = std::max(far, std::abs(place) + std::hypot(block.width, block.height) / 2);
    }
    if (actor.run.exact())
      stage.spans =
          read_events(actor.run, scene.blocks, actor.samples.front().back(), starting_pattern(actor.run))
              .spans;
  }
  stage.side = std::max(across, 0.6 * width + height * std::max(0.2, std::sin(std::min(most, 1.4))));
  stage.above = std::max(1.05 * up, 1.25 * std::hypot(height, width / 2));
  return stage;
}

Animation animation_of(const Stage& stage) {
  const double speed = speed_of(stage.end);
  const double wide = 2 * stage.side * static_cast<double>(stage.actors.size()), high = 1.08 * stage.above;
  Animation animation;
  animation.height = 2 * static_cast<int>(std::clamp(500.0 * high / wide + 30, 140.0, 400.0));
  animation.settings =
      "unset tics\nunset key\nunset border\nset size ratio -1\nset margins screen 0.01, screen 0.99, screen "
      "0.02, screen 0.93\n" +
      fmt::format("set xrange [0:{}]\nset yrange [{}:{}]\nset title {} noenhanced offset 0,-0.6\n",
                  plain(wide), plain(-0.08 * stage.above), plain(stage.above),
                  in_quotes(stage.scene.title + speed_text(speed))) +
      fmt::format("set arrow from 0,0 to {},0 nohead lw 2 lc rgb '#555555'\n", plain(wide));
  for (std::size_t i = 0; i < stage.actors.size(); ++i)
    animation.settings += fmt::format(
        "set label {} {} noenhanced at {},{} center textcolor rgb '{}' font ',10'\n", i + 2,
        in_quotes(run_label(stage.actors[i].run)), plain((2 * static_cast<double>(i) + 1) * stage.side),
        plain(-0.05 * stage.above), stage.actors[i].colour);
  const auto frames = static_cast<std::size_t>(std::ceil(stage.end / speed * frame_rate));
  for (std::size_t i = 0; i <= frames; ++i)
    animation.frames.push_back(
        frame(stage, std::min(static_cast<double>(i) * speed / frame_rate, stage.end)));
  return animation;
}

}  // namespace

std::vector<std::filesystem::path> draw_animations(const std::filesystem::path& results) {
  const Comparison comparison = read_comparison(results);
  std::vector<std::filesystem::path> files;
  for (const ComparedScene& scene : comparison.scenes) {
    if (!has_motion(comparison, scene)) continue;
    const std::filesystem::path stem = figure_stem(results, scene.name, "motion");
    draw(animation_of(stage_of(comparison, scene)), stem);
    files.push_back(std::filesystem::path(stem).concat(".gif"));
    if (has_ffmpeg()) files.push_back(std::filesystem::path(stem).concat(".mp4"));
  }
  return files;
}

}  // namespace rockstack::plots
