#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/studies/lessons/course/course.hpp"
#include "comparisons/studies/lessons/mechanics.hpp"

namespace rockstack {
namespace {

const Event& first(const Asked& asked, EventKind kind) {
  const Event* event = first_event(asked.history, kind);
  if (event == nullptr)
    throw std::runtime_error(fmt::format("{}: there is no {}", asked.scene.title, name(kind)));
  return *event;
}

double kept_energy(const Asked& asked) {
  const ImpactEnergies energies = impact_energies(asked.scene, first(asked, EventKind::impact));
  return energies.after / energies.before;
}

double ratio_at_impact(const Asked& asked) {
  const Event& impact = first(asked, EventKind::impact);
  const auto block = static_cast<std::size_t>(impact.interface) - 1;
  return impact.after[block] / impact.before[block];
}

double fifth_impact(const Asked& asked) {
  const std::vector<Event> impacts = impacts_of(asked.history);
  if (impacts.size() < 5)
    throw std::runtime_error(fmt::format("{}: there are no five impacts", asked.scene.title));
  return impacts[4].time;
}

/// What pivots need of friction, beyond what there is.
double friction_short(const Asked& asked) {
  const ContactNeed need = contact_need(asked.scene);
  return std::max(need.force.friction, need.impulse.friction) - need.friction;
}

/// The chance that two samples of n values are apart by luck: all of the one below all of the other is
/// one of the (2n choose n) ways to share out 2n ranks, as likely as the other way round.
double chance_apart(const Asked& asked) {
  const double n = asked["draws"];
  return 2 * std::exp(2 * std::lgamma(n + 1) - std::lgamma(2 * n + 1));
}

/// Each exact impact has a window of ± w; n impacts at random times miss it with (1 − 2w/T)ⁿ.
double chance_matched(const Asked& asked) {
  const double share = 2 * asked["window"] / asked["duration"];
  return asked["exact"] * (1 - std::pow(1 - share, asked["seen"]));
}

using Quantity = double(const Asked& asked);

const std::map<std::string, Quantity*> all_quantities{
    // Quantities of a scene's exact solution. SI units.
    {"first-impact", [](const Asked& a) { return first(a, EventKind::impact).time; }},
    {"opening", [](const Asked& a) { return first(a, EventKind::opening).time; }},
    {"opening-lead",
     [](const Asked& a) { return first(a, EventKind::impact).time - first(a, EventKind::opening).time; }},
    {"lift-off", [](const Asked& a) { return first(a, EventKind::lift_off).time; }},
    {"flight",
     [](const Asked& a) { return first(a, EventKind::impact).time - first(a, EventKind::lift_off).time; }},
    {"impact-ratio", ratio_at_impact},
    {"top-ratio",
     [](const Asked& a) {
       const Event& impact = first(a, EventKind::impact);
       return impact.after.back() / impact.before.back();
     }},
    {"fifth-impact", fifth_impact},
    {"kept-energy", kept_energy},
    {"lost-energy", [](const Asked& a) { return 1 - kept_energy(a); }},
    {"base-after", [](const Asked& a) { return std::abs(first(a, EventKind::impact).after.front()); }},
    {"slenderness", [](const Asked& a) { return slenderness(a.scene, 0); }},
    {"force-friction", [](const Asked& a) { return contact_need(a.scene).force.friction; }},
    {"impulse-friction", [](const Asked& a) { return contact_need(a.scene).impulse.friction; }},
    {"sticking-ratio",
     [](const Asked& a) {
       const Block& block = a.scene.blocks.front();
       return impact_ratio(block.half_height / block.half_width);
     }},
    {"friction-short", friction_short},
    {"jamming-friction",
     [](const Asked& a) { return jamming_friction(a.scene.blocks.front(), a.scene.initial.angles.front()); }},
    {"one-body-energy", [](const Asked& a) { return land(a.scene, {}).energy; }},
    {"printed-energy",
     [](const Asked& a) {
       return land(a.scene, {true, true}).energy;
     }},
    // Quantities of the numbers of the question.
    {"chance-apart", chance_apart},
    {"tests-that-show", [](const Asked& a) { return std::floor(a["level"] / chance_apart(a)); }},
    {"chance-matched", chance_matched},
    {"luckiest", [](const Asked& a) { return 1 - std::pow(1 - a["share"], a["draws"]); }},
    {"order",
     [](const Asked& a) { return std::log(a["coarse_error"] / a["fine_error"]) / std::log(a["factor"]); }},
    {"lead", [](const Asked& a) { return a["step"] / 2; }},
    {"erp-stiffness", [](const Asked& a) { return a["erp"] / (a["dt"] * a["cfm"]); }},
    {"erp-damping", [](const Asked& a) { return (1 - a["erp"]) / a["cfm"]; }},
    {"restitution-of-damping", [](const Asked& a) { return restitution_of(a["damping_ratio"]); }},
    {"chatter-sum", [](const Asked& a) { return a["flight"] / (1 - a["factor"]); }},
    {"doubling", [](const Asked& a) { return std::log(2.0) / a["rate"]; }},
    {"predictable", [](const Asked& a) { return std::log(a["parted"] / a["error"]) / a["rate"]; }},
    {"impacts-to-share", [](const Asked& a) { return impacts_to_share(a["share"], a["ratio"]); }}};

}  // namespace

double Asked::operator[](const std::string& name) const {
  const auto found = numbers.find(name);
  if (found == numbers.end())
    throw InputError(
        fmt::format("a lesson's question: {}: must be one of its numbers", rockstack::quoted(name)));
  return found->second;
}

Asked asked_about(const std::string& scene, const std::vector<std::string>& changes) {
  Asked asked;
  asked.scene = read_shipped(scene, changes);
  asked.history = solve(asked.scene);
  return asked;
}

double quantity(const std::string& name, const Asked& asked) {
  const auto found = all_quantities.find(name);
  return found != all_quantities.end() ? found->second(asked) : asked[name];
}

std::vector<std::string> quantity_names() {
  return mapped(all_quantities, [](const auto& one) { return one.first; });
}

}  // namespace rockstack
