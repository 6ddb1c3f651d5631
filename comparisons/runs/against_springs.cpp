#include "comparisons/measures/results/tables.hpp"
#include "comparisons/runs/measure.hpp"

namespace rockstack {
namespace {

void add_sizes(const DifferenceParts& parts, RunMetrics& row) {
  const Difference whole = whole_of(parts);
  row.model_difference = root_mean_square(parts.model);
  row.softness_difference = root_mean_square(parts.softness);
  row.step_difference = root_mean_square(parts.step);
  row.model_share = share_of(parts.model, whole);
  row.softness_share = share_of(parts.softness, whole);
  row.step_share = share_of(parts.step, whole);
  if (row.model_share)
    row.parts_over_whole = std::hypot(*row.model_difference, *row.softness_difference, *row.step_difference) /
                           root_mean_square(whole);
}

}  // namespace

CornerSpring corner_of(const ContactRecord& contacts) {
  return {contacts.points * contacts.stiffness, contacts.points * contacts.damping};
}

SoftMotion soft_motion(const Scene& scene, const std::vector<double>& friction, CornerSpring spring,
                       const std::vector<double>& times, double most_steps) {
  const double factor = spring_factor(scene, spring, most_steps);
  const auto solved = [&](double softer) {
    const CornerSpring one{spring.stiffness / softer, spring.damping / softer};
    return solve(with_springs(scene, friction, one), {.sample_times = times});
  };
  if (factor == 1) return {solved(1), 1};
  // Extrapolates angles that are linear in the factor to those for factor 1.
  const History stiffer = solved(factor), softer = solved(2 * factor);
  const std::size_t samples = std::min(stiffer.size(), softer.size());
  History result;
  result.blocks = stiffer.blocks;
  result.times.assign(stiffer.times.begin(), stiffer.times.begin() + static_cast<std::ptrdiff_t>(samples));
  for (std::size_t i = 0; i < samples * static_cast<std::size_t>(stiffer.blocks); ++i)
    result.angles.push_back(stiffer.angles[i] -
                            (softer.angles[i] - stiffer.angles[i]) * (factor - 1) / factor);
  return {std::move(result), factor};
}

void add_parts(const Scene& scene, const History& exact, const CandidateMotion& candidate, double horizon,
               bool histories, RunMetrics& row, RunFiles& files) {
  if (!candidate.bodies->contacts) {
    row.split_reason = "the engine tells no contacts";
    return;
  }
  try {
    const bool rigid_engine = std::isinf(candidate.bodies->contacts->stiffness);
    const History rigid =
        solve(with_rigid_contacts(scene, candidate.friction), {.sample_times = candidate.history.times});
    SoftMotion soft{rigid};
    if (!rigid_engine && !scene.kinetic_friction.empty())
      throw std::runtime_error("contact.kinetic_friction: springs have one coefficient");
    if (!rigid_engine) {
      soft = soft_motion(scene, candidate.friction, corner_of(*candidate.bodies->contacts),
                         candidate.history.times);
      row.spring_factor = soft.factor;
    }
    const DifferenceParts parts = difference_parts(exact, rigid, soft.history, candidate.history);
    add_sizes({up_to(parts.model, horizon), up_to(parts.softness, horizon), up_to(parts.step, horizon)}, row);
    if (histories) files["parts.csv"] = parts_csv(parts);
  } catch (const std::exception& failure) {
    row.split_reason = failure.what();
  }
}

}  // namespace rockstack
