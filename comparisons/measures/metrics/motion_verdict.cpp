#include "comparisons/measures/metrics/motion_verdict.hpp"

#include <fmt/format.h>

#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/contact.hpp"

namespace rockstack {
namespace {

constexpr double visible = 1e-9;  // m

/// In the order of TopplingVerdict.
constexpr std::array<const char*, 5> verdict_names{"", "neither", "both", "exact alone", "engine alone"};

/// Which interface would have to pull first, by forces or by impulses; empty where none does.
std::string pull(const History& history) {
  double first = std::numeric_limits<double>::infinity();
  std::string text;
  for (const auto* demands : {&history.forces, &history.impulses})
    for (std::size_t k = 0; k < demands->size(); ++k)
      if (const Demand& one = (*demands)[k]; one.least_normal < 0 && one.first_pull_time < first) {
        first = one.first_pull_time;
        text = fmt::format("interface {} would have to pull at {:.4g} s", k + 1, first);
      }
  return text;
}

/// What blocks and ground must do for the model to hold; empty where it was not asked for.
std::string demand(const History& history) {
  if (history.forces.empty()) return "";
  if (const std::string text = pull(history); !text.empty()) return "; " + text;
  const double forces = worst_of(history.forces).friction;
  const double impulses = worst_of(history.impulses).friction;
  const std::string needed = fmt::format("{:.2g}", forces), in_impacts = fmt::format("{:.2g}", impulses);
  return "; needs friction " + needed +
         (impulses > forces && in_impacts != needed ? ", " + in_impacts + " in impacts" : "");
}

/// Of a block, in samples, by the angle of balance on the side that it leans to.
Lean lean_to_either_side(const Scene& scene, const History& history, std::size_t block) {
  Lean most{block, 0, 0};
  for (const int side : {1, -1}) {
    const double balance = balance_angle(scene, static_cast<int>(block), side);
    for (std::size_t i = 0; i < history.size(); ++i) {
      const double angle = side * history.angles_at(i)[block];
      if (angle > 0 && angle / balance > most.ratio) most = {block, angle / balance, history.times[i]};
    }
  }
  return most;
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

/// What is still going on in the last sample, so that nothing can be said of standing: "block 1 is in
/// flight".
std::string unsettled(const Scene& scene, const History& history) {
  if (history.times.empty()) return "";
  const std::size_t last = history.size() - 1;
  const auto angles = history.angles_at(last), velocities = history.velocities_at(last);
  if (const auto block =
          first_block(history, [&](std::size_t k) { return gap_at(history, last, k) > visible; }))
    return fmt::format("block {} is in flight", *block);
  if (const auto block = sliding_at_end(history)) return fmt::format("block {} slides", *block);
  if (const auto block = first_block(history, [&](std::size_t k) {
        return std::abs(angles[k]) > slenderness(scene, static_cast<int>(k)) && angles[k] * velocities[k] > 0;
      }))
    return fmt::format("block {} leans further than its slenderness angle, and on", *block);
  return "";
}

/// The block that slips furthest, and where it is left.
std::string slipping(const History& history, const std::vector<InterfaceSummary>& interfaces) {
  const auto most = std::ranges::max_element(interfaces, {}, &InterfaceSummary::largest_slip);
  if (most->largest_slip <= visible) return "";
  std::string far = fmt::format("; block {} slips by up to {}", most - interfaces.begin() + 1,
                                quantity_text(most->largest_slip, "m"));
  if (sliding_at_end(history)) return far;
  return far + fmt::format(" and is left {} to the {}", quantity_text(std::abs(most->final_slip), "m"),
                           most->final_slip < 0 ? "left" : "right");
}

/// The block that rises furthest above where it starts.
std::string lifting(const History& history, std::vector<InterfaceSummary> interfaces) {
  for (std::size_t k = 0; k < interfaces.size(); ++k) interfaces[k].highest_lift -= gap_at(history, 0, k);
  const auto most = std::ranges::max_element(interfaces, {}, &InterfaceSummary::highest_lift);
  if (most->highest_lift <= visible) return "";
  return fmt::format("; block {} lifts by up to {}", most - interfaces.begin() + 1,
                     quantity_text(most->highest_lift, "m"));
}

/// How far blocks slip and lift, where they may; else what must hold for them not to.
std::string freedom(const History& history) {
  const std::vector<InterfaceSummary> interfaces = contact_summary(history);
  if (interfaces.empty()) return demand(history);
  const std::string text = slipping(history, interfaces) + lifting(history, interfaces);
  const bool held = !first_block(history, [&](std::size_t k) { return gap_at(history, 0, k) > visible; });
  const std::string doubt = doubt_of(history);
  return (text.empty() && held ? "; nothing slips or lifts" : text) + (doubt.empty() ? "" : "; " + doubt);
}

/// What ends a motion, of a block from 1.
std::string end_words(EventKind kind, int block) {
  if (kind == EventKind::fall) return "falls off";
  if (kind != EventKind::strike) return "topples";
  return block < 3 ? "strikes the ground" : "strikes the ground or a block further down";
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

}  // namespace

std::string doubt_of(const History& history) {
  for (const Event& event : history.events)
    if (event.consistency == Consistency::several)
      return fmt::format("from {:.4g} s on one of several motions that obey", event.time);
  const std::string text = pull(history);
  return text.empty() ? "" : "one in which " + text;
}

std::string reported_toppling(const History& history) {
  if (history.events.empty() || !ends_motion(history.events.back().kind)) return "";
  return fmt::format("block {} at {} s", history.events.back().interface, history.events.back().time);
}

std::string observed_toppling(const Scene& scene, const History& history) {
  const auto last = history.angles_at(history.size() - 1);
  for (std::size_t k = 0; k < last.size(); ++k)
    if (std::abs(last[k]) > toppling_angle(scene, static_cast<int>(k)))
      return fmt::format("block {} at {} s", k + 1, history.times.back());
  return "";
}

TopplingVerdict toppling_verdict(bool exact, bool engine) {
  if (exact == engine) return exact ? TopplingVerdict::both : TopplingVerdict::neither;
  return exact ? TopplingVerdict::exact_alone : TopplingVerdict::engine_alone;
}

std::string name(TopplingVerdict verdict) {
  return verdict_names.at(static_cast<std::size_t>(verdict));
}

TopplingVerdict named_verdict(const std::string& name) {
  const auto found = std::find(verdict_names.begin(), verdict_names.end(), name);
  return found == verdict_names.end() ? TopplingVerdict::unknown
                                      : static_cast<TopplingVerdict>(found - verdict_names.begin());
}

bool differ(TopplingVerdict verdict) {
  return verdict == TopplingVerdict::exact_alone || verdict == TopplingVerdict::engine_alone;
}

double angle_at(const History& history, std::size_t block, double time) {
  const auto after = std::lower_bound(history.times.begin(), history.times.end(), time);
  const auto last = static_cast<std::ptrdiff_t>(history.size()) - 1;
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - history.times.begin(), 1, last));
  const double fraction = (time - history.times[i - 1]) / (history.times[i] - history.times[i - 1]);
  const double from = history.angles_at(i - 1)[block];
  return from + fraction * (history.angles_at(i)[block] - from);
}

std::vector<Swing> swings(const History& history, std::size_t block) {
  std::vector<Swing> list(1);
  double side = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double angle = history.angles_at(i)[block];
    if (i == 0) side = angle;
    if (angle * side < 0) {
      list.back().end = history.times[i];
      list.emplace_back();
      side = angle;
    }
    if (std::abs(angle) > list.back().peak) {
      list.back().peak = std::abs(angle);
      list.back().peak_time = history.times[i];
    }
  }
  return list;
}

Swing largest_swing(const History& history, std::size_t block) {
  const auto list = swings(history, block);
  return *std::ranges::max_element(list, {}, &Swing::peak);
}

std::vector<double> peak_angles(const History& history) {
  if (!history.peaks.empty()) return history.peaks;
  std::vector<double> result(static_cast<std::size_t>(history.blocks));
  for (std::size_t i = 0; i < history.angles.size(); ++i) {
    double& peak = result[i % result.size()];
    peak = std::max(peak, std::abs(history.angles[i]));
  }
  return result;
}

Lean largest_lean(const Scene& scene, const History& history) {
  const std::vector<double> peaks = peak_angles(history);
  Lean largest;
  for (std::size_t k = 0; k < peaks.size(); ++k) {
    const Lean lean =
        scene.blocks[k].offset_x == 0 || history.angles.empty()
            ? Lean{k, peaks[k] / slenderness(scene, static_cast<int>(k)), largest_swing(history, k).peak_time}
            : lean_to_either_side(scene, history, k);
    if (lean.ratio > largest.ratio) largest = lean;
  }
  return largest;
}

Support support_of(const std::vector<double>& penetration, const std::vector<double>& unsupported_since) {
  const auto tenth = static_cast<std::ptrdiff_t>((penetration.size() + 9) / 10);
  return {*std::min_element(penetration.end() - tenth, penetration.end()), fallen_block(unsupported_since)};
}

std::string motion_verdict(const Scene& scene, const History& history, const Support& support) {
  const bool reported = !history.events.empty() && ends_motion(history.events.back().kind);
  const std::string toppled = reported ? reported_toppling(history) : observed_toppling(scene, history);
  if (!toppled.empty())
    return fmt::format(
        "{} {} at {:.4g} s{}", toppled.substr(0, toppled.find(" at ")),
        reported ? end_words(history.events.back().kind, history.events.back().interface) : "topples",
        reported ? history.events.back().time : history.times.back(), freedom(history));
  if (!support.fallen.empty())
    return fmt::format("{} has fallen off{}{}", support.fallen.substr(0, support.fallen.find(" at ")),
                       support.fallen.substr(support.fallen.find(" at ")), freedom(history));
  const Lean most = largest_lean(scene, history);
  const std::string sunk = sinking(scene, history, support.sinking);
  const std::string going_on = unsettled(scene, history);
  if (history.events.empty() && most.ratio < 1e-3 && going_on.empty())
    return sunk.empty() ? "rests throughout" + freedom(history) : "rests, but " + sunk + freedom(history);
  const std::string rest =
      ends_at_rest(scene, history) ? fmt::format(", at rest from {:.4g} s", history.events.back().time) : "";
  const std::string lean =
      most.ratio < 1e-3 && !history.slips.empty()
          ? "; nothing rocks"
          : fmt::format("; block {} peaks at {:.2f} of its slenderness angle at {:.4g} s", most.block + 1,
                        most.ratio, most.time);
  const std::string state =
      going_on.empty() ? "stands" : fmt::format("{} at the end, {:.4g} s", going_on, history.times.back());
  return state + rest + lean + (sunk.empty() ? "" : "; " + sunk) + freedom(history);
}

}  // namespace rockstack
