#include "analytic/scene/kinematics.hpp"
#include "plots/data/patterns.hpp"
#include "plots/data/run_files.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr double frame_rate = 25;  // 1/s

/// One column of the picture.
struct Actor {
  Run run;
  std::shared_ptr<const History> history;
};

struct Stage {
  const ComparedScene& scene;
  std::vector<Actor> actors;
  std::vector<PatternSpan> spans;
  Stack<double> stack;
  double end = 0;    ///< s
  double side = 0;   ///< half the width of a column, m
  double above = 0;  ///< top of the picture, m
};

/// Angles of all blocks, or their places, between samples on straight lines; held after the end.
std::vector<double> values_at(const History& history, const std::vector<double>& rows, double time) {
  const std::vector<double>& times = history.times;
  const auto after = std::ranges::upper_bound(times, time) - times.begin();
  const auto high = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after, 1, std::ssize(times) - 1));
  const double span = times[high] - times[high - 1];
  const double part = span > 0 ? std::clamp((time - times[high - 1]) / span, 0.0, 1.0) : 1;
  const std::size_t width = rows.size() / times.size();
  std::vector<double> values(width);
  for (std::size_t k = 0; k < width; ++k)
    values[k] = rows[(high - 1) * width + k] * (1 - part) + rows[high * width + k] * part;
  return values;
}

/// The middles of all blocks: as the results tell them, else from the angles, about the corners.
Points<double> middles_at(const Stage& stage, const std::vector<double>& angles,
                          const std::vector<double>& places) {
  const auto blocks = std::ssize(angles);
  if (places.empty()) {
    const Vector<double> turns = Eigen::Map<const Eigen::VectorXd>(angles.data(), blocks);
    const Vector<double> openings = relative(turns);
    return centres(make_chain(stage.stack, pattern_of(openings, openings), turns));
  }
  Points<double> middles(2, blocks);
  // A centre of mass as the results have it, less its way from the middle.
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Block& block = stage.scene.stack[k];
    middles.col(static_cast<Eigen::Index>(k)) =
        Point<double>(places[2 * k], places[2 * k + 1]) -
        turned(block.offset_x, block.offset_y, std::cos(angles[k]), std::sin(angles[k]));
  }
  return middles;
}

/// The corners of a block as a polygon, `middle` m along the picture.
std::string polygon(const Block& block, const Point<double>& centre, double angle, double middle) {
  std::string text;
  const double b = block.half_width, h = block.half_height;
  const std::array<std::array<double, 2>, 5> corners{{{-b, -h}, {b, -h}, {b, h}, {-b, h}, {-b, -h}}};
  for (const auto& [a, c] : corners) {
    const Point<double> corner = centre + turned(a, c, std::cos(angle), std::sin(angle));
    text += fmt::format("{}{:.5g},{:.5g}", text.empty() ? "" : " to ", middle + corner.x(), corner.y());
  }
  return text;
}

std::string drawn(const Stage& stage, std::size_t index, double time) {
  const Actor& actor = stage.actors[index];
  const History& history = *actor.history;
  const std::vector<double> angles = values_at(history, history.angles, time);
  const Points<double> middles = middles_at(stage, angles, values_at(history, history.centres, time));
  const double middle = (2 * static_cast<double>(index) + 1) * stage.side;
  std::string text;
  for (Eigen::Index k = 0; k < middles.cols(); ++k)
    text += fmt::format(
        "set object polygon from {0} fillstyle transparent solid 0.18 border lc rgb '{1}' fillcolor rgb '{1}' "
        "lw 2\n",
        polygon(stage.scene.stack[static_cast<std::size_t>(k)], middles.col(k),
                angles[static_cast<std::size_t>(k)], middle),
        style_of(actor.run).colour);
  return text;
}

std::string frame(const Stage& stage, double time) {
  std::string text = "unset object\n", pattern;
  for (std::size_t i = 0; i < stage.actors.size(); ++i) text += drawn(stage, i, time);
  for (const PatternSpan& span : stage.spans)
    if (span.from <= time) pattern = ", exact pattern " + shown_pattern(span.pattern);
  return text + fmt::format("set label 1 {} noenhanced at graph 0.5, graph 0.965 center\nplot NaN notitle\n",
                            in_quotes(fmt::format("{:.2f} s{}", time, pattern)));
}

/// Two engines at most: more would be too small to look at.
std::vector<Actor> actors_of(const Comparison& comparison, const ComparedScene& scene) {
  const auto [exact, engines] = shown_runs(comparison, scene.name);
  std::vector<Run> runs = exact;
  for (const Run& run : engines)
    if (runs.size() < exact.size() + 2 && run.dt) runs.push_back(run);
  std::vector<Actor> actors;
  for (const Run& run : runs)
    if (const auto history = history_of(run); history->size() > 1) actors.push_back({run, history});
  return actors;
}

Stage stage_of(const Comparison& comparison, const ComparedScene& scene) {
  Scene middles;  // of blocks whose centres of mass are in their middles: pictures show no others
  middles.blocks = scene.stack;
  for (Block& block : middles.blocks) block.offset_x = block.offset_y = 0;
  Stage stage{scene, actors_of(comparison, scene), {}, make_stack<double>(middles)};
  double height = 0, width = 0, most = 0, across = 0, up = 0;
  for (const Block& block : scene.stack)
    height += 2 * block.half_height, width = std::max(width, 2 * block.half_width);
  for (const Actor& actor : stage.actors) {
    stage.end = std::max(stage.end, actor.history->times.back());
    for (const double angle : actor.history->angles) most = std::max(most, std::abs(angle));
    if (!actor.run.exact()) continue;
    const std::vector<double>& places = actor.history->centres;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Block& block = scene.stack[i / 2 % scene.stack.size()];
      double& far = i % 2 == 0 ? across : up;
      far = std::max(far, std::abs(places[i]) + std::hypot(block.half_width, block.half_height));
    }
    stage.spans = pattern_spans(*actor.history);
  }
  stage.side = std::max(across, 0.6 * width + height * std::max(0.2, std::sin(std::min(most, 1.4))));
  stage.above = std::max(1.05 * up, 1.25 * std::hypot(height, width / 2));
  return stage;
}

Animation animation_of(const Stage& stage) {
  const double speed = stage.end > 8 ? 1 : stage.end > 2 ? 0.5 : 0.1;  // as players run at first
  const double wide = 2 * stage.side * static_cast<double>(stage.actors.size()), high = 1.08 * stage.above;
  Animation animation;
  animation.height = 2 * static_cast<int>(std::clamp(500.0 * high / wide + 30, 140.0, 400.0));
  const std::string slow = speed < 1 ? fmt::format(" (1/{:.0f} of the speed)", 1 / speed) : "";
  animation.settings = fmt::format(
      "unset tics\nunset key\nunset border\nset size ratio -1\nset margins screen 0.01, screen 0.99, screen "
      "0.02, screen 0.93\nset xrange [0:{0}]\nset yrange [{1}:{2}]\nset title {3} noenhanced offset 0,-0.6\n"
      "set arrow from 0,0 to {0},0 nohead lw 2 lc rgb '#555555'\n",
      plain(wide), plain(-0.08 * stage.above), plain(stage.above), in_quotes(stage.scene.title + slow));
  for (std::size_t i = 0; i < stage.actors.size(); ++i)
    animation.settings += fmt::format(
        "set label {} {} noenhanced at {},{} center textcolor rgb '{}' font ',10'\n", i + 2,
        in_quotes(run_label(stage.actors[i].run)), plain((2 * static_cast<double>(i) + 1) * stage.side),
        plain(-0.05 * stage.above), style_of(stage.actors[i].run).colour);
  const auto frames = static_cast<std::size_t>(std::ceil(stage.end / speed * frame_rate));
  for (std::size_t i = 0; i <= frames; ++i)
    animation.frames.push_back(
        frame(stage, std::min(static_cast<double>(i) * speed / frame_rate, stage.end)));
  return animation;
}

}  // namespace

std::vector<fs::path> draw_animations(const fs::path& results) {
  const Comparison comparison = read_comparison(results);
  std::vector<fs::path> files;
  for (const ComparedScene& scene : comparison.scenes) {
    if (!has_motion(comparison, scene)) continue;
    const fs::path stem = results / "figures" / (scene.name + ".motion");
    draw(animation_of(stage_of(comparison, scene)), stem);
    files.push_back(fs::path(stem).concat(".gif"));
    if (has_program("ffmpeg")) files.push_back(fs::path(stem).concat(".mp4"));
  }
  return files;
}

}  // namespace rockstack::plots
