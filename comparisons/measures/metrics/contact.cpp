#include "comparisons/measures/metrics/contact.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analytic/mechanics/pattern_solution.hpp"
#include "analytic/scene/spring_checks.hpp"
#include "comparisons/measures/metrics/bodies.hpp"

namespace rockstack {
namespace {

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json demand_json(const Demand& demand) {
  return {{"least_normal", finite(demand.least_normal)},
          {"least_normal_time", demand.least_normal_time},
          {"friction", finite(demand.friction)},
          {"friction_time", demand.friction_time},
          {"first_pull_time", finite(demand.first_pull_time)},
          {"first_slip_time", finite(demand.first_slip_time)}};
}

void add_warnings(const Scene& scene, const std::vector<Demand>& demands, const char* what, const char* unit,
                  std::vector<std::string>& lines) {
  const std::vector<double> friction = friction_of(scene);
  for (std::size_t k = 0; k < demands.size(); ++k) {
    const Demand& demand = demands[k];
    if (demand.least_normal < 0) {
      lines.push_back(fmt::format(
          "interface {} would have to pull, normal {} {:.4g} {} at t = {:.6g} s: blocks would lift off, "
          "first at t = {:.6g} s",
          k + 1, what, demand.least_normal, unit, demand.least_normal_time, demand.first_pull_time));
    } else if (demand.friction > friction[k]) {
      lines.push_back(fmt::format(
          "interface {} needs friction {:.4g} for the {} at t = {:.6g} s, the scene has {}: "
          "blocks would slip, first at t = {:.6g} s",
          k + 1, demand.friction, what, demand.friction_time, friction[k], demand.first_slip_time));
    }
  }
}

/// Where theory has no single answer.
void add_open_questions(const History& history, std::vector<std::string>& lines) {
  for (const Event& event : history.events) {
    if (event.consistency == Consistency::several) {
      lines.push_back(fmt::format(
          "at t = {:.6g} s several motions obey the laws of contact: the one with {} follows. What "
          "sticks goes on to stick "
          "if it can; corner on corner, a slip is judged by the face that it meets",
          event.time, pattern_words(event.to)));
    } else if (event.consistency == Consistency::none) {
      lines.push_back(fmt::format(
          "at t = {:.6g} s no finite forces let the motion go on (Painlevé): an impulse stops interface {}, "
          "as in the limit of time steps",
          event.time, event.interface));
    } else if (event.consistency == Consistency::gains) {
      lines.push_back(fmt::format(
          "at t = {:.6g} s an impact at interface {} gains energy: Newton's coefficient of restitution allows "
          "that beside friction",
          event.time, event.interface));
    }
  }
}

/// The state of a sample, whose closed interfaces have no relative motion but rounding.
State<double> state_at(const History& history, std::size_t sample) {
  State<double> state{history.patterns[sample], relative(vector_of(history.angles_at(sample))),
                      relative(vector_of(history.velocities_at(sample)))};
  for (int k = 0; k < history.blocks; ++k) {
    if (state.pattern[k] != Contact::closed) continue;
    state.angles[k] = 0;
    state.velocities[k] = 0;
  }
  return state;
}

}  // namespace

std::vector<InterfaceSummary> contact_summary(const History& history) {
  if (history.slips.empty()) return {};
  const auto blocks = static_cast<std::size_t>(history.blocks);
  std::vector<InterfaceSummary> list(blocks);
  for (std::size_t i = 0; i < history.slips.size(); ++i) {
    InterfaceSummary& one = list[i % blocks];
    if (history.patterns.empty() || history.patterns[i / blocks].contacts[i % blocks] != Contact::apart) {
      one.final_slip = history.slips[i] - history.slips[i % blocks];
      one.largest_slip = std::max(one.largest_slip, std::abs(one.final_slip));
    }
    if (!history.gaps.empty() && std::isfinite(history.gaps[i]))
      one.highest_lift = std::max(one.highest_lift, history.gaps[i]);
  }
  for (const Event& event : history.events)
    for (std::size_t k = 0; k < blocks; ++k) {
      list[k].slips += event.from.slides[k] == 0 && event.to.slides[k] != 0;
      list[k].lift_offs += event.from.contacts[k] != Contact::apart && event.to.contacts[k] == Contact::apart;
    }
  return list;
}

bool ends_at_rest(const Scene& scene, const History& history) {
  return scene.law != Law::compliant && !history.events.empty() &&
         history.events.back().to == closed_pattern(history.blocks);
}

Json contact_json(const History& history) {
  auto json = Json::array();
  int interface = 0;
  for (const InterfaceSummary& one : contact_summary(history))
    json.push_back({{"interface", ++interface},
                    {"final_slip", one.final_slip},
                    {"largest_slip", one.largest_slip},
                    {"highest_lift", one.highest_lift},
                    {"slips", one.slips},
                    {"lift_offs", one.lift_offs}});
  return json;
}

Json validity_json(const History& history) {
  Json list = Json::array();
  for (std::size_t k = 0; k < history.forces.size(); ++k)
    list.push_back({{"interface", k + 1},
                    {"forces", demand_json(history.forces[k])},
                    {"impulses", demand_json(history.impulses[k])}});
  return list;
}

Demand worst_of(const std::vector<Demand>& demands) {
  Demand worst;
  for (const Demand& one : demands) {
    worst.least_normal = std::min(worst.least_normal, one.least_normal);
    worst.friction = std::max(worst.friction, one.friction);
    worst.first_pull_time = std::min(worst.first_pull_time, one.first_pull_time);
    worst.first_slip_time = std::min(worst.first_slip_time, one.first_slip_time);
  }
  return worst;
}

std::vector<std::string> validity_warnings(const Scene& scene, const History& history) {
  std::vector<std::string> lines;
  if (leaves_pivots(scene.law)) {
    add_open_questions(history, lines);
  } else {
    add_warnings(scene, history.forces, "force", "N", lines);
    add_warnings(scene, history.impulses, "impulse", "N s", lines);
  }
  for (const auto& choice : history.choices)
    lines.push_back(
        fmt::format("interface {} opens under tension at t = {:.6g} s, where either side would do: it took "
                    "one of two motions",
                    choice.interface, choice.time));
  for (const auto& graze : history.grazes)
    lines.push_back(
        fmt::format("interface {} grazes at t = {:.6g} s: rounding decides whether there is an {}",
                    graze.interface, graze.time, name(graze.kind)));
  return lines;
}

std::vector<Reaction> reactions_of(const Scene& scene, const History& history) {
  if (!history.reactions.empty()) return history.reactions;
  Model<double> model = make_model<double>(scene);
  std::vector<Reaction> rows;
  rows.reserve(history.size() * static_cast<std::size_t>(history.blocks));
  auto event = history.events.begin();
  for (std::size_t i = 0; i < history.size(); ++i) {
    // What yields is longest at events.
    for (; !model.restraints.empty() && event != history.events.end() && event->time <= history.times[i];
         ++event) {
      const Vector<double> still = Vector<double>::Zero(history.blocks);
      follow_restraints(model, State<double>{event->to, relative(vector_of(event->angles)), still});
    }
    const State<double> state = state_at(history, i);
    if (!model.restraints.empty()) follow_restraints(model, state);
    const PatternSolution<double> solution = accelerate(model, state, loading_at(scene, history.times[i]));
    const auto& [normal, tangential, moment] = solution.reactions;
    for (int k = 0; k < history.blocks; ++k) {
      const bool carried = solution.pattern[k] == Contact::closed && normal[k] > solution.rounding[k];
      rows.push_back({normal[k], tangential[k], carried ? -moment[k] / normal[k] : std::nan("")});
    }
  }
  return rows;
}

Blow blow_of(const Stack<double>& stack, const Event& event) {
  Blow blow;
  const auto blocks = static_cast<Eigen::Index>(event.angles.size());
  if (event.centres.empty()) {
    const Vector<double> angles = vector_of(event.angles);
    blow.before = centre_velocities(make_chain(stack, event.from, angles), vector_of(event.before));
    blow.after = centre_velocities(make_chain(stack, event.to, angles), vector_of(event.after));
  } else {
    blow.before = Points<double>::Map(event.centres.data() + 2 * blocks, 2, blocks);
    blow.after = Points<double>::Map(event.centres.data() + 4 * blocks, 2, blocks);
  }
  blow.impulses = (blow.after - blow.before) * stack.mass.asDiagonal();
  for (Eigen::Index k = blocks - 2; k >= 0; --k) blow.impulses.col(k) += blow.impulses.col(k + 1);
  return blow;
}

double damping_ratio(const CornerSpring& spring, const Block& block) {
  const double inverse_mass = 1 / block.mass + block.half_width * block.half_width / block.inertia;
  return spring.damping / 2 * std::sqrt(inverse_mass / spring.stiffness);
}

double restitution_of(double damping_ratio) {
  const double z = damping_ratio, under = 1 - z * z;
  if (std::abs(under) < 1e-9) return std::exp(-2.0);
  if (std::isinf(under)) return 0;
  const double s = std::sqrt(std::abs(under));
  const double time = under > 0 ? std::acos(-1.0) - std::atan2(2 * z * s, 1 - 2 * z * z)
                                : 2 * std::log(z + s);  // (ζ + s)/(ζ − s) = (ζ + s)², without cancelling
  return std::exp(-z / s * time);
}

Scene with_rigid_contacts(Scene scene, const std::vector<double>& friction) {
  scene.law = Law::unilateral;
  scene.equations = Equations::nonlinear;
  scene.friction = friction;
  scene.kinetic_friction.clear();
  scene.springs = {};
  scene.initial.preloaded = true;
  return scene;
}

Scene with_springs(Scene scene, const std::vector<double>& friction, const CornerSpring& spring) {
  const double tangential = scene.springs.tangential;
  scene = with_rigid_contacts(std::move(scene), friction);
  scene.law = Law::compliant;
  scene.point_restitution = 0;
  scene.springs.stiffness.assign(scene.blocks.size(), spring.stiffness);
  scene.springs.damping.assign(scene.blocks.size(), spring.damping);
  scene.springs.tangential = tangential;
  scene.initial.preloaded = false;
  return scene;
}

double spring_factor(const Scene& scene, const CornerSpring& spring, double most) {
  double trace = 0;  // of M⁻¹K for unit springs at both ends of each interface
  for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
    const double half_width = interface_half_width(scene, static_cast<int>(k));
    trace += 2 * spring_compliance(scene.blocks[k], half_width, scene.springs.tangential);
    if (k > 0) trace += 2 * spring_compliance(scene.blocks[k - 1], half_width, scene.springs.tangential);
  }
  const double per_rate = scene.duration / steps_per_rate / most;
  const double damped = trace * spring.damping * per_rate;
  const double swinging = trace * spring.stiffness * per_rate * per_rate;
  return std::max({1.0, damped, swinging});
}

}  // namespace rockstack
