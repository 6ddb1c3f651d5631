#include "comparisons/measures/metrics/motion_verdict.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/metrics/ground.hpp"

namespace rockstack {
namespace {

constexpr double visible = 1e-9;  // m
constexpr const char* visible_text = "1 nm";

/// The most friction that an interface needs, and in words; there it is rounded up, to two digits.
struct FrictionNeeded {
  double friction = 0;
  std::string text;
};

FrictionNeeded friction_needed(const std::vector<Demand>& demands) {
  const auto most = std::ranges::max_element(demands, {}, &Demand::friction);
  const double enough = two_digits_up(most->friction);
  const std::string where =
      demands.size() > 1 && enough > 0 ? fmt::format(" at interface {}", most - demands.begin() + 1) : "";
  return {most->friction,
          (enough < 100 ? fmt::format("{:.2g}", enough) : fmt::format("{:.0f}", enough)) + where};
}

/// From when on pivots hold what blocks would not, as "not valid from 1.2 s, as interface 2 would have to
/// pull"; empty where they never do, or where it was not asked for. An interface slips before it pulls,
/// whatever its friction; where that is more than is told from infinite, the pull is told.
struct Breach {
  double time = std::numeric_limits<double>::infinity();  ///< s
  std::string text = {};
};

Breach breach_of(const Scene& scene, const History& history) {
  const std::vector<double> friction = friction_of(scene);
  Breach first;
  for (const auto* demands : {&history.forces, &history.impulses})
    for (std::size_t k = 0; k < demands->size(); ++k) {
      const Demand& one = (*demands)[k];
      const bool slips = friction[k] < largest_friction && one.first_slip_time < one.first_pull_time;
      const double time = slips ? one.first_slip_time : one.first_pull_time;
      if (!(time < first.time)) continue;
      const std::string needed =
          std::isfinite(one.friction) ? "needs " + friction_needed({one}).text : "no friction is enough";
      first = {time, fmt::format("not valid from {:.4g} s, as interface {} would ", time, k + 1) +
                         (slips ? fmt::format("slip: it has friction {} and {}", friction[k], needed)
                                : "have to pull")};
    }
  return first;
}

/// What blocks and ground must do for the model to hold; empty where it was not asked for.
std::string demand(const Scene& scene, const History& history) {
  if (history.forces.empty() || !breach_of(scene, history).text.empty()) return "";
  const FrictionNeeded forces = friction_needed(history.forces), impulses = friction_needed(history.impulses);
  if (!(std::max(forces.friction, impulses.friction) > 0)) return "";
  if (impulses.friction > forces.friction && impulses.text != forces.text)
    return fmt::format("; needs friction {} in impacts, {} between them", impulses.text, forces.text);
  return "; needs friction " + forces.text;
}

/// How far a block is above what is below it, m; 0 where the history does not tell it.
double gap_at(const History& history, std::size_t sample, std::size_t block) {
  return history.gaps.empty() ? 0 : history.row(history.gaps, sample)[block];
}

/// The first block that holds something, from 1.
template <class Holds>
std::optional<std::size_t> first_block(const History& history, const Holds& holds) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(history.blocks); ++k)
    if (holds(k)) return k + 1;
  return {};
}

std::optional<std::size_t> sliding_at_end(const History& history) {
  return first_block(
      history, [&](std::size_t k) { return !history.patterns.empty() && history.patterns.back().slides[k]; });
}

/// "block 3 leans" of the top one, "blocks 1 to 3 lean" of one with what stands on it.
std::string from_block_up(std::size_t block, const Scene& scene, const std::string& alone,
                          const std::string& together) {
  const std::size_t top = scene.blocks.size();
  return block + 1 == top ? fmt::format("block {} {}", top, alone)
                          : fmt::format("blocks {} to {} {}", block + 1, top, together);
}

/// With two digits, however small.
std::string share_text(double share) {
  return share < 0.1 ? fmt::format("{:.2g}", share) : fmt::format("{:.2f}", share);
}

/// How far a block by itself comes, or one with what stands on it where that comes nearer to its balance; on
/// sloping ground the latter, or nothing where upright blocks would fall.
std::string leaning(const Scene& scene, const Lean& alone, const Lean& common, double end) {
  if (scene.inclination != 0 && common.ratio == 0) return "";
  if (common.ratio > alone.ratio || scene.inclination != 0)
    return "; " + from_block_up(common.block, scene, "comes", "together come") +
           fmt::format(" to {} of {} balance at {:.4g} s", share_text(common.ratio),
                       common.block + 1 == scene.blocks.size() ? "its" : "their", common.time);
  return fmt::format("; block {} {} {} of its slenderness angle at {:.4g} s", alone.block + 1,
                     alone.time < end ? "peaks at" : "comes to", share_text(alone.ratio), alone.time);
}

/// What is still going on in the last sample, so that nothing can be said of standing: "block 1 is in
/// flight".
std::string unsettled(const Scene& scene, const History& history,
                      const std::optional<FallingBlock>& falling) {
  const std::size_t last = history.size() - 1;
  if (falling && !(gap_at(history, last, falling->block) > visible))
    return falling->past_edge
               ? from_block_up(falling->block, scene, "has slid past the edge and falls",
                               "have slid past the edge and fall")
               : from_block_up(falling->block, scene, "leans", "lean") + " past balance and on";
  if (const auto block =
          first_block(history, [&](std::size_t k) { return gap_at(history, last, k) > visible; }))
    return fmt::format("block {} is in flight", *block);
  if (const auto block = sliding_at_end(history)) return fmt::format("block {} slides", *block);
  return "";
}

/// The block that slips furthest, and where it is left.
std::string slipping(const History& history, const std::vector<InterfaceSummary>& interfaces) {
  const auto most = std::ranges::max_element(interfaces, {}, &InterfaceSummary::largest_slip);
  if (most->largest_slip <= visible) return "";
  // What is apart at times need not have slipped to be elsewhere.
  std::string far =
      fmt::format("; block {} {} by up to {}", most - interfaces.begin() + 1,
                  most->highest_lift > visible ? "shifts" : "slips", quantity_text(most->largest_slip, "m"));
  if (sliding_at_end(history)) return far;
  if (std::abs(most->final_slip) <= visible) return far + " and ends where it began";
  return far + fmt::format(" and is left {} to the {}", quantity_text(std::abs(most->final_slip), "m"),
                           most->final_slip < 0 ? "left" : "right");
}

/// The block that rises furthest above where it starts, and how far it is above what is below it then.
std::string lifting(const History& history, const std::vector<InterfaceSummary>& interfaces) {
  const auto risen = [&](std::size_t k) { return interfaces[k].highest_lift - gap_at(history, 0, k); };
  std::size_t most = 0;
  for (std::size_t k = 1; k < interfaces.size(); ++k)
    if (risen(k) > risen(most)) most = k;
  if (risen(most) <= visible) return "";
  const std::string high = quantity_text(interfaces[most].highest_lift, "m");
  return fmt::format("; block {} {}", most + 1,
                     gap_at(history, 0, most) > visible ? "rises to " + high + " above what it is over"
                                                        : "lifts by up to " + high);
}

/// Nothing is seen to slip or lift, whatever impacts bring about by roundings; of blocks that touch.
std::string held(const History& history) {
  if (first_block(history, [&](std::size_t k) { return gap_at(history, 0, k) > visible; })) return "";
  const bool slightly = std::ranges::any_of(history.events, [](const Event& event) {
    return event.kind == EventKind::slip || event.kind == EventKind::stick ||
           event.kind == EventKind::lift_off;
  });
  return "; nothing slips or lifts" + (slightly ? std::string(" by more than ") + visible_text : "");
}

/// How far blocks slip and lift, where they may; else what must hold for them not to.
std::string freedom(const Scene& scene, const History& history) {
  const std::vector<InterfaceSummary> interfaces = contact_summary(history);
  if (interfaces.empty()) return demand(scene, history);
  const std::string text = slipping(history, interfaces) + lifting(history, interfaces);
  return text.empty() ? held(history) : text;
}

/// "block 2 topples", "blocks 1 to 2 topple": a block, from 1, and its neighbours that have turned as far as
/// it has, to a hundredth.
std::string toppling_words(std::span<const double> angles, int block) {
  const auto turned = [&](int k) { return angles[static_cast<std::size_t>(k) - 1]; };
  const auto as_one = [&](int k) {
    return k >= 1 && k <= static_cast<int>(angles.size()) &&
           std::abs(turned(k) - turned(block)) <= 0.01 * std::abs(turned(block));
  };
  int lowest = block, highest = block;
  while (as_one(lowest - 1)) --lowest;
  while (as_one(highest + 1)) ++highest;
  return lowest == highest ? fmt::format("block {} topples", block)
                           : fmt::format("blocks {} to {} topple", lowest, highest);
}

/// What ends a motion, of a block from 1.
std::string end_words(const History& history, int block) {
  if (history.events.empty() || !ends_motion(history.events.back().kind))
    return toppling_words(history.angles_at(history.size() - 1), block);
  const Event& last = history.events.back();
  if (last.kind == EventKind::topple) return toppling_words(last.angles, block);
  return fmt::format("block {} {}", block,
                     last.kind == EventKind::fall ? "falls off"
                     : block < 3                  ? "strikes the ground"
                                                  : "strikes the ground or a block further down");
}

/// How far a centre is nearer to the one below than upright blocks that touch have it, at most, at one sample
/// of a motion that tells centres, m.
double deepest_sinking(const Scene& scene, const History& history, std::size_t sample) {
  double deepest = 0, below = 0;
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const Block& block = scene.blocks[k];
    const double centre = history.centres[2 * (sample * scene.blocks.size() + k) + 1];
    deepest = std::max(deepest, below + block.half_height + block.offset_y - centre);
    below = centre + block.half_height - block.offset_y;
  }
  return deepest;
}

/// "sinks in by 86 mm", or nothing. An exact motion whose springs are not loaded at the start tells itself
/// what an engine's bodies would.
std::string sinking(const Scene& scene, const History& history, double depth) {
  std::vector<double> depths;
  if (scene.law == Law::compliant && !scene.initial.preloaded)
    for (std::size_t i = 0; i < history.size(); ++i) depths.push_back(deepest_sinking(scene, history, i));
  if (!depths.empty()) depth = std::max(depth, support_of(depths, {}).sinking);
  return depth > told_sinking * least_height(scene.blocks) ? "sinks in by " + quantity_text(depth, "m", 2)
                                                           : "";
}

/// The first block that has fallen off what it stood on.
std::string fallen_block(const std::vector<double>& unsupported_since) {
  const auto first = std::ranges::min_element(unsupported_since);
  if (first == unsupported_since.end() || std::isinf(*first)) return "";
  return fmt::format("block {} at {} s", first - unsupported_since.begin() + 1, *first);
}

/// What a scene leaves out of its ground's motion, in brackets.
std::string cut_short(const Scene& scene) {
  const double left = ground_left(scene);
  return left > 0 ? fmt::format(" (the scene ends at {:.4g} s, its ground at {:.4g} s)", scene.duration,
                                scene.duration + left)
                  : "";
}

/// How it ends, how far it comes, and what for.
std::string outcome_of(const Scene& scene, const History& history, const SupportLoss& support) {
  if (const auto end = toppling_of(scene, history))
    return fmt::format("{} at {:.4g} s{}", end_words(history, end->block), end->time,
                       freedom(scene, history));
  if (!support.fallen.empty())
    return fmt::format("{} has fallen off{}{}", support.fallen.substr(0, support.fallen.find(" at ")),
                       support.fallen.substr(support.fallen.find(" at ")), freedom(scene, history));
  const Lean most = largest_lean(scene, history);
  const std::string sunk = sinking(scene, history, support.sinking);
  const auto falling = falling_block(scene, history, history.size() - 1);
  const std::string going_on = unsettled(scene, history, falling);
  if (history.events.empty() && most.ratio < 1e-3 && going_on.empty())
    return (sunk.empty() ? "rests throughout" : "rests, but " + sunk) + cut_short(scene) +
           freedom(scene, history);
  const std::string lean =
      falling && falling->past_edge ? ""
      : most.ratio < 1e-3 && !history.slips.empty()
          ? "; nothing rocks"
          : leaning(scene, most, largest_common_lean(scene, history), history.times.back());
  const std::string end = fmt::format("the end, {:.4g} s", history.times.back());
  const bool rocks = !history.patterns.empty() && !is_closed(history.patterns.back());
  const std::string state = !going_on.empty() ? going_on + " at " + end
                            : ends_at_rest(scene, history)
                                ? fmt::format("stands, at rest from {:.4g} s", history.events.back().time)
                            : rocks ? "stands so far, still rocking at " + end
                                    : "stands";
  return state + cut_short(scene) + lean + (sunk.empty() ? "" : "; " + sunk) + freedom(scene, history);
}

}  // namespace

std::string doubt_of(const Scene& scene, const History& history) {
  for (const Event& event : history.events) {
    if (event.consistency == Consistency::several)
      return fmt::format("from {:.4g} s on one of several motions that obey the laws of contact", event.time);
    if (event.consistency == Consistency::none && leaves_pivots(scene.law))
      return fmt::format("stopped by an impulse at {:.4g} s, as no finite forces let it go on (Painlevé)",
                         event.time);
  }
  return breach_of(scene, history).text;
}

double angle_at(const History& history, std::size_t block, double time) {
  const auto after = std::lower_bound(history.times.begin(), history.times.end(), time);
  const auto last = static_cast<std::ptrdiff_t>(history.size()) - 1;
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - history.times.begin(), 1, last));
  const double fraction = (time - history.times[i - 1]) / (history.times[i] - history.times[i - 1]);
  const double from = history.angles_at(i - 1)[block];
  return from + fraction * (history.angles_at(i)[block] - from);
}

SupportLoss support_of(const std::vector<double>& penetration, const std::vector<double>& unsupported_since) {
  const auto tenth = static_cast<std::ptrdiff_t>((penetration.size() + 9) / 10);
  return {*std::min_element(penetration.end() - tenth, penetration.end()), fallen_block(unsupported_since)};
}

std::string motion_verdict(const Scene& scene, const History& history, const SupportLoss& support) {
  const std::string doubt = doubt_of(scene, history);
  std::string outcome = outcome_of(scene, history, support);
  if (doubt.empty()) return outcome;
  // What pivots hold of a block that is falling anyway comes last.
  const Breach breach = breach_of(scene, history);
  const auto after = std::upper_bound(history.times.begin(), history.times.end(), breach.time);
  const auto sample =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - history.times.begin() - 1, 0));
  return doubt == breach.text && falling_block(scene, history, sample) ? outcome + "; " + doubt
                                                                       : doubt + "; " + outcome;
}

}  // namespace rockstack
