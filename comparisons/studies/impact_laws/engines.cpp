#include "comparisons/studies/impact_laws/study.hpp"

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"

namespace rockstack {
namespace {

std::vector<double> list_of(const Vector<double>& values) {
  return {values.begin(), values.end()};
}

/// Mean angular velocities between two samples.
std::vector<double> mean_rates(const History& history, std::size_t from, std::size_t to) {
  return list_of((vector_of(history.angles_at(to)) - vector_of(history.angles_at(from))) /
                 (history.times[to] - history.times[from]));
}

struct LawRun {
  Event impact;
  std::vector<double> rates;
  bool alone;  ///< the only impact
};

/// The exact motion under a law up to `follow` after its first event.
LawRun run_law(Scene scene, Law law) {
  scene.law = law;
  const History events = solve(scene);
  if (events.events.empty()) throw std::runtime_error("nothing happens");
  const Event impact = events.events.front();
  const History history = solve(scene, {.sample_times = {impact.time + follow / 2, impact.time + follow}});
  if (history.size() < 2) throw std::runtime_error("a block topples");
  const auto count = std::ranges::count_if(events.events, [&](const Event& event) {
    return event.kind != EventKind::opening && event.time <= impact.time + follow;
  });
  return {impact, mean_rates(history, 0, 1), count == 1};
}

bool is_of(const LawRun& run, const ImpactKind& kind, const Pattern& answer) {
  return run.alone && run.impact.kind != EventKind::opening && run.impact.interface == kind.interface + 1 &&
         run.impact.from == kind.before && run.impact.to == answer;
}

/// The scene that runs into an impact after `lead`, to the first order in `lead`.
Scene scene_before(const DrawnImpact& drawn) {
  Scene scene = drawn.scene;
  const State<double>& state = drawn.impact.before;
  scene.duration = 4 * lead + follow;
  const Vector<double> rates = absolute(state.velocities);
  scene.initial.velocities = list_of(rates);
  scene.initial.angles = list_of(absolute(state.angles) - lead * rates);
  // Closed interfaces are those whose angles are equal to the last bit.
  for (int k = 0; k < state.pattern.size; ++k) {
    const auto block = static_cast<std::size_t>(k);
    if (state.pattern[k] != Contact::closed) continue;
    scene.initial.angles[block] = k == 0 ? 0 : scene.initial.angles[block - 1];
    scene.initial.velocities[block] = k == 0 ? 0 : scene.initial.velocities[block - 1];
  }
  return scene;
}

std::optional<ImpactCase> make_case(const Disagreement& disagreement) {
  const ImpactKind& kind = disagreement.kind;
  ImpactCase result{.name = name(kind) + "." + name(disagreement.paper) + "." + name(disagreement.consistent),
                    .disagreement = disagreement,
                    .scene = scene_before(disagreement.clearest)};
  result.scene.title = result.name;
  const LawRun paper = run_law(result.scene, Law::paper);
  const LawRun consistent = run_law(result.scene, Law::consistent);
  if (!is_of(paper, kind, disagreement.paper) || !is_of(consistent, kind, disagreement.consistent))
    return std::nullopt;
  result.time = consistent.impact.time;
  result.before = consistent.impact.before;
  result.largest_rate = relative(vector_of(result.before)).cwiseAbs().maxCoeff();
  result.paper = paper.rates;
  result.consistent = consistent.rates;
  result.scene.duration = result.time + follow;
  return result;
}

/// Relative angles count as open above this share of the largest relative rate before times `follow`.
constexpr double open_share = 0.03;

}  // namespace

std::vector<ImpactCase> clear_cases(const std::vector<Disagreement>& disagreements, double least_clearness) {
  std::vector<ImpactCase> cases;
  for (const Disagreement& disagreement : disagreements) {
    if (disagreement.clearness < least_clearness) continue;
    if (auto found = make_case(disagreement)) cases.push_back(std::move(*found));
  }
  return cases;
}

EngineVerdict ask_engine(const ImpactCase& question, const EngineSeries& series, double dt) {
  EngineVerdict verdict{series.engine->name, series.engine->solver, series.settings, dt};
  try {
    const History history = simulate(*series.engine, question.scene, dt, series.parameters).history;
    const std::size_t last = history.size() - 1;
    const auto half = static_cast<std::size_t>(std::lround(follow / 2 / dt));
    if (half < 1 || half > last) throw std::runtime_error("the step is too long, or a block toppled");
    verdict.rates = mean_rates(history, last - half, last);
    Vector<double> opening = relative(vector_of(history.angles_at(last)));
    for (double& angle : opening)
      angle = std::abs(angle) > open_share * question.largest_rate * follow ? angle : 0;
    verdict.pattern = pattern_of(opening, Vector<double>::Zero(opening.size()));
    verdict.follows = verdict.pattern == question.disagreement.consistent ? "consistent"
                      : verdict.pattern == question.disagreement.paper    ? "paper"
                                                                          : "neither";
    const auto off = [&](const std::vector<double>& rates) {
      return (vector_of(verdict.rates) - vector_of(rates)).cwiseAbs().maxCoeff() / question.largest_rate;
    };
    verdict.from_paper = off(question.paper);
    verdict.from_consistent = off(question.consistent);
  } catch (const std::exception& failure) {
    verdict.failure = failure.what();
  }
  return verdict;
}

}  // namespace rockstack
