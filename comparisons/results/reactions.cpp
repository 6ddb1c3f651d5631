#include "comparisons/results/reactions.hpp"

#include <fmt/format.h>

#include <iterator>

#include "analytic/outcome.hpp"
#include "analytic/scene/ground_motion.hpp"

namespace rockstack {
namespace {

/// The state of a sample, whose closed interfaces have no relative motion but rounding.
State<double> state_at(const History& history, std::size_t sample) {
  using Angles = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(history.blocks);
  const Vector<double> angles = Angles(history.angles_at(sample).data(), size);
  const Vector<double> velocities = Angles(history.velocities_at(sample).data(), size);
  State<double> state{history.patterns[sample], relative(angles), relative(velocities)};
  for (int k = 0; k < history.blocks; ++k) {
    if (state.pattern[k] != Contact::closed) continue;
    state.angles[k] = 0;
    state.velocities[k] = 0;
  }
  return state;
}

std::string header(int blocks) {
  std::string text = "time";
  for (const char* stem : {"normal", "tangential", "centre"})
    for (int k = 1; k <= blocks; ++k) text += fmt::format(",{}_{}", stem, k);
  return text + "\n";
}

}  // namespace

std::string reactions_csv(const Scene& scene, const History& history) {
  const Model<double> model = make_model<double>(scene);
  fmt::memory_buffer lines;
  const auto out = std::back_inserter(lines);
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double time = history.times[i];
    const Point<double> ground{acceleration(scene.horizontal, time), acceleration(scene.vertical, time)};
    const Outcome<double> outcome = accelerate(model, state_at(history, i), ground);
    fmt::format_to(out, "{}", time);
    for (const double normal : outcome.reactions.normal) fmt::format_to(out, ",{:.7g}", normal);
    for (const double tangential : outcome.reactions.tangential) fmt::format_to(out, ",{:.7g}", tangential);
    for (int k = 0; k < history.blocks; ++k) {
      if (outcome.pattern[k] == Contact::closed && outcome.reactions.normal[k] > outcome.rounding[k]) {
        fmt::format_to(out, ",{:.7g}", -outcome.reactions.moment[k] / outcome.reactions.normal[k]);
      } else {
        fmt::format_to(out, ",");
      }
    }
    fmt::format_to(out, "\n");
  }
  return header(history.blocks) + fmt::to_string(lines);
}

}  // namespace rockstack
