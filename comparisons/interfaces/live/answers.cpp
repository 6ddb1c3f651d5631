#include "comparisons/interfaces/live/live_state.hpp"

#include <nlohmann/json.hpp>

#include "comparisons/interfaces/live/exact_answers.hpp"
#include "comparisons/measures/metrics/impacts.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "plots/pages/player_data.hpp"

namespace rockstack::live {

using Json = nlohmann::ordered_json;

Json engine_answer(const LiveState& state, const WorkerRun& run, std::size_t stride) {
  const History& history = run.run.history;
  Json answer;
  add_track(answer,
            plots::player_track(history, stride,
                                {state.series.engine->full_name(), "#0072b2", "(8,3)", true, false}),
            observed_impacts(history, chatter_speed(state.scene)));
  const auto& bodies = run.run.bodies;
  if (bodies) add_energies(answer, state.scene, history.times, bodies->energy, stride);
  answer["verdict"] = motion_verdict(
      state.scene, history, bodies ? support_of(bodies->penetration, bodies->unsupported_since) : Support{});
  answer["warnings"] = run.run.warnings;
  return answer;
}

Json engine_member(const WorkerRun& run, std::size_t stride) {
  return {{"track", plots::player_track(run.run.history, stride)}};
}

}  // namespace rockstack::live
