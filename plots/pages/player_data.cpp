#include "plots/pages/player_data.hpp"

#include <bit>
#include <nlohmann/json.hpp>

#include "analytic/scene/kinematics.hpp"
#include "analytic/scene/lists.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "plots/data/patterns.hpp"

namespace rockstack::plots {
namespace {

using Rows = std::vector<double>;

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Numbers as text for a page: 32-bit floating point, lowest byte first, in base 64.
std::string base64(const std::vector<float>& numbers) {
  std::vector<unsigned char> bytes;
  bytes.reserve(4 * numbers.size());
  for (const float number : numbers)
    for (unsigned shift = 0; shift < 32; shift += 8)
      bytes.push_back(static_cast<unsigned char>((std::bit_cast<std::uint32_t>(number) >> shift) & 0xFFU));
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  auto letter = text.begin();
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) group = group << 8U | (j < count ? bytes[i + j] : 0U);
    for (std::size_t j = 0; j < 4; ++j, ++letter)
      if (j <= count) *letter = digits[(group >> (18U - 6U * static_cast<unsigned>(j))) & 63U];
  }
  return text;
}

void append(const Rows& rows, std::size_t width, std::size_t row, Rows& to) {
  const auto from = rows.begin() + static_cast<std::ptrdiff_t>(row * width);
  if (!rows.empty()) to.insert(to.end(), from, from + static_cast<std::ptrdiff_t>(width));
}

/// Between two rows, on a straight line.
void append_between(const Rows& rows, std::size_t width, std::size_t after, double part, Rows& to) {
  for (std::size_t at = after * width; !rows.empty() && at < (after + 1) * width; ++at)
    to.push_back(rows[at - width] * (1 - part) + rows[at] * part);
}

Json spans_of(const History& history) {
  Json list = Json::array();
  for (const PatternSpan& span : pattern_spans(history)) {
    Json sides = Json::array(), slides = Json::array();
    for (int k = 0; k < span.pattern.size; ++k) {
      sides.push_back(sign(span.pattern[k]));
      slides.push_back(span.pattern.slides[static_cast<std::size_t>(k)]);
    }
    list.push_back({span.from, shown_pattern(span.pattern), sides, slides});
  }
  return list;
}

/// Events by time, with 1 for chatter: slow bounces, and the starts and ends of sliding and touching that
/// follow them; a landing on springs is none. Chatter beyond what a page can hold is left out.
Json stops_of(const Scene& scene, const History& history) {
  constexpr std::size_t most = 4000;
  Json list = Json::array();
  bool chatter = false;
  for (const Event& event : history.events) {
    const bool bounce = event.kind == EventKind::impact || event.kind == EventKind::touch;
    if (bounce) {
      const auto interface = static_cast<std::size_t>(event.interface) - 1;
      const double width = interface_width(scene, interface);
      const bool lands_on_springs =
          event.kind == EventKind::touch && event.from.contacts[interface] == Contact::apart;
      chatter = !lands_on_springs && approach_speed(event, width) < chatter_speed(scene) * width;
    }
    const bool follows =
        event.kind == EventKind::slip || event.kind == EventKind::stick || event.kind == EventKind::part;
    const bool slow = chatter && (bounce || follows);
    if (list.size() < most || !slow)
      list.push_back({event.time, event.interface, shown_pattern(event.from), shown_pattern(event.to),
                      slow ? 1 : 0, name(event.kind)});
  }
  return list;
}

/// Impacts of blocks on pivots but chatter: time, interface, velocities of the centres before and after, m/s,
/// impulses that interfaces bear, N·s, x and y in turn, and the sides that they leave to.
Json blows_of(const Scene& scene, const History& history) {
  constexpr std::size_t most = 200;
  Json list = Json::array();
  const Stack<double> stack = make_stack<double>(scene);
  const auto values = [](const Points<double>& points) {
    return std::vector<double>(points.data(), points.data() + points.size());
  };
  for (const Event& event : history.events) {
    const bool counts = is_impact(event.kind) && !event.before.empty() && list.size() < most;
    if (!counts) continue;
    const double width = interface_width(scene, static_cast<std::size_t>(event.interface - 1));
    if (approach_speed(event, width) < chatter_speed(scene) * width) continue;
    const Blow blow = blow_of(stack, event);
    std::vector<double> sides(static_cast<std::size_t>(event.to.size));
    for (int k = 0; k < event.to.size; ++k) sides[static_cast<std::size_t>(k)] = side<double>(event.to, k);
    list.push_back({event.time, event.interface, values(blow.before), values(blow.after),
                    values(blow.impulses), std::move(sides)});
  }
  return list;
}

/// A point of a block, from 1; 0 is the ground.
Json point_json(const BlockPoint& point) {
  return {point.block, point.x, point.y};
}

/// Where a push acts, which way, its force at these times, N, and its impulses by their times, N·s.
Json push_json(const Push& push, const std::vector<double>& times) {
  constexpr std::size_t most = 5000;
  const std::size_t stride = stride_for(times.size(), most);
  const auto forces = mapped(times, [&](double time) { return acceleration(push.force, time); });
  Json impulses = Json::array();
  for (const VelocityStep& step : push.force.steps) impulses.push_back({step.time, step.size});
  return {{"point", point_json(push.point)},
          {"direction", {std::cos(push.direction), std::sin(push.direction)}},
          {"times", packed(times, 1, stride)},
          {"forces", packed(forces, 1, stride)},
          {"impulses", std::move(impulses)}};
}

}  // namespace

std::string packed(const std::vector<double>& rows, std::size_t width, std::size_t stride) {
  const std::size_t size = rows.size() / width;
  std::vector<float> numbers;
  const auto keep = [&](std::size_t row) {
    for (std::size_t at = row * width; at < (row + 1) * width; ++at)
      numbers.push_back(static_cast<float>(rows[at]));
  };
  for (std::size_t row = 0; row < size; row += stride) keep(row);
  if (size > 0 && (size - 1) % stride != 0) keep(size - 1);
  return base64(numbers);
}

void make_room(Json& object) {
  constexpr std::size_t most = 16;
  object.get_ref<Json::object_t&>().reserve(most);
}

Json player_track(const History& history, std::size_t stride) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  Json track{{"times", packed(history.times, 1, stride)}, {"angles", packed(history.angles, blocks, stride)}};
  if (!history.slips.empty()) track["slips"] = packed(history.slips, blocks, stride);
  if (!history.centres.empty()) track["places"] = packed(history.centres, 2 * blocks, stride);
  return track;
}

Json player_track(const History& history, std::size_t stride, const TrackLook& look) {
  Json track{{"label", look.label},
             {"colour", look.colour},
             {"dash", look.dash},
             {"shown", look.shown},
             {"exact", look.exact}};
  make_room(track);
  Json motion = player_track(history, stride);
  for (auto& [name, values] : motion.get_ref<Json::object_t&>()) track[name] = std::move(values);
  return track;
}

History with_events(const History& history) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  History merged;
  merged.blocks = history.blocks;
  auto event = history.events.begin();
  for (std::size_t i = 0; i < history.size(); ++i) {
    for (; event != history.events.end() && event->time < history.times[i]; ++event) {
      if (i == 0 || event->time <= merged.times.back()) continue;
      const double before = history.times[i - 1], part = (event->time - before) / (history.times[i] - before);
      merged.times.push_back(event->time);
      append(event->angles, blocks, 0, merged.angles);
      append_between(history.slips, blocks, i, part, merged.slips);
      append_between(history.centres, 2 * blocks, i, part, merged.centres);
    }
    merged.times.push_back(history.times[i]);
    append(history.angles, blocks, i, merged.angles);
    append(history.slips, blocks, i, merged.slips);
    append(history.centres, 2 * blocks, i, merged.centres);
  }
  return merged;
}

void add_forces(const std::vector<double>& times, const std::vector<double>& rows, int blocks,
                std::size_t stride, Json& track) {
  track["reaction_times"] = packed(times, 1, stride);
  track["reactions"] = packed(rows, 3 * static_cast<std::size_t>(blocks), stride);
}

Json player_scene(const Scene& scene, const History& history) {
  double mass = 0;
  Json shapes = Json::array();
  for (const Block& block : scene.blocks) {
    mass += block.mass;
    shapes.push_back({{"width", 2 * block.half_width},
                      {"height", 2 * block.half_height},
                      {"offset", {block.offset_x, block.offset_y}}});
  }
  Json stage{{"title", scene.title}, {"blocks", std::move(shapes)}, {"weight", mass * scene.gravity}};
  make_room(stage);
  stage["events"] = {{"spans", spans_of(history)}, {"stops", stops_of(scene, history)}};
  if (leaves_pivots(scene.law)) stage["friction"] = friction_of(scene);
  if (scene.wall.side != 0) stage["wall"] = scene.wall.side;
  for (const Restraint& restraint : scene.restraints)
    stage["restraints"].push_back({point_json(restraint.from), point_json(restraint.to)});
  if (!history.times.empty())
    for (const Push& push : scene.pushes) stage["pushes"].push_back(push_json(push, history.times));
  return stage;
}

void add_ground(const std::vector<double>& times, const std::vector<double>& right,
                const std::vector<double>& up, Json& stage) {
  constexpr std::size_t most = 5000;
  const std::size_t stride = stride_for(times.size(), most);
  if (!times.empty())
    stage["ground"] = {{"times", packed(times, 1, stride)},
                       {"values", packed(right, 1, stride)},
                       {"up", packed(up, 1, stride)}};
}

std::string for_script(const Json& data) {
  std::string text;
  for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

Json stage_of(const Scene& scene, const History& history) {
  Json stage = player_scene(scene, history);
  if (!leaves_pivots(scene.law)) stage["blows"] = blows_of(scene, history);
  const auto ground = [&](const auto& along) {
    return mapped(history.times, [&](double time) { return acceleration(along, time); });
  };
  if (!scene.horizontal.empty() || !scene.vertical.empty())
    add_ground(history.times, ground(scene.horizontal), ground(scene.vertical), stage);
  return stage;
}

void add_forces(const Scene& scene, const History& history, std::size_t stride, Json& track) {
  Rows rows;
  const auto blocks = static_cast<std::size_t>(history.blocks);
  const std::vector<Reaction> reactions = reactions_of(scene, history);
  rows.reserve(3 * reactions.size());
  for (std::size_t from = 0; from < reactions.size(); from += blocks)
    for (const auto part : {&Reaction::normal, &Reaction::tangential, &Reaction::centre})
      for (std::size_t k = 0; k < blocks; ++k) rows.push_back(reactions[from + k].*part);
  add_forces(history.times, rows, history.blocks, stride, track);
}

}  // namespace rockstack::plots
