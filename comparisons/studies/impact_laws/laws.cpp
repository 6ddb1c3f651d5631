#include "comparisons/studies/impact_laws/laws.hpp"

#include <random>

#include "analytic/scene/lists.hpp"

namespace rockstack {
namespace {

/// Uniform in [0, 1); the library's own distributions differ between implementations.
double unit(std::mt19937_64& random) {
  return std::ldexp(static_cast<double>(random() >> 11U), -53);
}

double uniform(const Range& range, std::mt19937_64& random) {
  return range.from + (range.to - range.from) * unit(random);
}

double log_uniform(const Range& range, std::mt19937_64& random) {
  return range.from * std::pow(range.to / range.from, unit(random));
}

/// Part `i` of a range cut into `count` equal ratios.
Range part(const Range& range, int i, int count) {
  const auto edge = [&](int at) { return range.from * std::pow(range.to / range.from, double(at) / count); };
  return {edge(i), edge(i + 1)};
}

Scene draw_blocks(const ImpactDraws& draws, int count, const Range& aspect_ratio, const Range& mass_ratio,
                  std::mt19937_64& random) {
  Scene scene;
  double half_width = 1;
  double mass = 1;
  for (int k = 0; k < count; ++k) {
    const bool top = k == count - 1;
    if (k > 0) half_width *= uniform(draws.width_ratio, random);
    if (k > 0) mass *= log_uniform(top ? mass_ratio : draws.mass_ratio, random);
    const double half_height = half_width * log_uniform(top ? aspect_ratio : draws.base_aspect_ratio, random);
    scene.blocks.push_back({half_width, half_height, mass, rectangle_inertia(mass, half_width, half_height)});
  }
  return scene;
}

State<double> draw_state(const ImpactDraws& draws, const ImpactKind& kind, double rate_scale,
                         std::mt19937_64& random) {
  const int size = kind.before.size;
  State<double> state{kind.before, Vector<double>::Zero(size), Vector<double>::Zero(size)};
  double largest = 0;
  for (int k = 0; k < size; ++k) {
    if (kind.before[k] == Contact::closed) continue;
    const bool impacts = k == kind.interface;
    state.velocities[k] = impacts ? -sign(kind.before[k]) * unit(random) : 2 * unit(random) - 1;
    state.angles[k] = impacts ? 0 : sign(kind.before[k]) * draws.largest_angle * unit(random);
    largest = std::max(largest, std::abs(state.velocities[k]));
  }
  state.velocities *= rate_scale * uniform(draws.speed, random) / largest;
  return state;
}

/// The forces of the motion before: every interface pushes, closed ones inside their width.
bool carries_itself(const Model<double>& model, const State<double>& state) {
  const PatternSolution<double> solution = accelerate(model, state, {0, 0});
  if (!pushes(solution)) return false;
  for (int k = 0; k < state.pattern.size; ++k) {
    if (state.pattern[k] != Contact::closed) continue;
    const Margins<double> margin = margins(model.stack, solution.reactions, k);
    if (margin.left < 0 || margin.right < 0) return false;
  }
  return true;
}

/// How clearly an engine can tell the two answers of an impact apart.
double clearness(const DrawnImpact& drawn, const LawVerdict& verdict) {
  const State<double>& before = drawn.impact.before;
  const Interfaces touching = drawn.impact.touching();
  double least =
      (absolute(verdict.paper.relative) - absolute(verdict.consistent->relative)).cwiseAbs().maxCoeff();
  for (int k = 0; k < before.pattern.size; ++k) {
    if (drawn.impact.impacting.test(static_cast<std::size_t>(k)))
      least = std::min(least, std::abs(before.velocities[k]));
    if (touching.test(static_cast<std::size_t>(k)) && verdict.consistent->pattern[k] != Contact::closed)
      least = std::min(least, std::abs(verdict.consistent->relative[k]));
  }
  return least / before.velocities.cwiseAbs().maxCoeff();
}

/// Draws until the pattern before carries itself (every pivot pushes, every centre of pressure lies inside),
/// a number of times at the most; nothing where it never does.
std::optional<DrawnImpact> draw_impact(const ImpactDraws& draws, ImpactShare& share,
                                       std::mt19937_64& random) {
  constexpr int attempts = 50;
  for (int i = 0; i < attempts; ++i) {
    ++share.drawn;
    DrawnImpact result{draw_blocks(draws, share.blocks, share.aspect_ratio, share.mass_ratio, random), {}};
    const Model<double> model = make_model<double>(result.scene);
    const double rate_scale = std::sqrt(model.gravity / (2 * model.stack.half_height.sum()));
    result.impact.before = draw_state(draws, share.kind, rate_scale, random);
    result.impact.impacting.set(static_cast<std::size_t>(share.kind.interface));
    if (carries_itself(model, result.impact.before)) return result;
  }
  return std::nullopt;
}

void fill(const ImpactDraws& draws, ImpactShare& share, std::mt19937_64& random,
          std::vector<Disagreement>& disagreements) {
  for (int i = 0; i < draws.samples; ++i) {
    const auto drawn = draw_impact(draws, share, random);
    if (!drawn) continue;
    const LawVerdict verdict = judge(*drawn);
    ++share.impacts;
    share.differ += static_cast<int>(verdict.differ());
    share.none += static_cast<int>(!verdict.consistent);
    share.several += static_cast<int>(verdict.admissible > 1);
    share.missed += static_cast<int>(verdict.missed);
    if (!verdict.differ()) continue;
    const Pattern &paper = verdict.paper.pattern, &consistent = verdict.consistent->pattern;
    const auto is = [&](const Disagreement& known) {
      return known.kind == share.kind && known.paper == paper && known.consistent == consistent;
    };
    Disagreement& found = found_or_added(disagreements, is, {share.kind, paper, consistent, 0, 0, *drawn});
    ++found.count;
    const double clear = clearness(*drawn, verdict);
    if (clear <= found.clearness) continue;
    found.clearness = clear;
    found.clearest = *drawn;
  }
}

}  // namespace

std::string name(const ImpactKind& kind) {
  const std::string place = kind.interface == 0     ? "ground"
                            : kind.before.size == 2 ? "blocks"
                                                    : "interface-" + std::to_string(kind.interface + 1);
  return name(kind.before) + "-" + place;
}

std::vector<ImpactKind> impact_kinds(int blocks) {
  const Impact<double> standing{{closed_pattern(blocks), {}, {}}, {}};
  std::vector<Pattern> all = candidates(standing.before.pattern, standing.touching());
  std::ranges::sort(all, {}, &Pattern::contacts);
  std::vector<ImpactKind> kinds;
  for (const Pattern& pattern : all) {
    int lowest = 0;
    while (lowest < blocks && pattern[lowest] == Contact::closed) ++lowest;
    if (lowest == blocks || pattern[lowest] == Contact::left) continue;
    for (int k = lowest; k < blocks; ++k)
      if (pattern[k] != Contact::closed) kinds.push_back({pattern, k});
  }
  return kinds;
}

LawVerdict judge(const DrawnImpact& drawn) {
  const Model<double> model = make_model<double>(drawn.scene);
  const Interfaces touching = drawn.impact.touching();
  const BeforeImpact<double> before = before_impact(model, drawn.impact.before);
  const auto after = [&](const Pattern& pattern) { return velocities_after(model, before, pattern); };
  LawVerdict verdict{paper_solution(drawn.impact, after), std::nullopt};
  for (const Pattern& pattern : candidates(drawn.impact.before.pattern, touching)) {
    PatternSolution<double> solution = after(pattern);
    if (!kinematically_admissible(solution, touching) || !pushes(solution) ||
        first_violation(model.stack, solution, touching, 0.0))
      continue;
    ++verdict.admissible;
    verdict.consistent = std::move(solution);
  }
  verdict.missed = verdict.consistent && !consistent_solution(model, drawn.impact, before);
  return verdict;
}

ImpactLaws study_impact_laws(const ImpactDraws& draws) {
  ImpactLaws result;
  std::mt19937_64 random(draws.seed);
  for (const int blocks : draws.blocks) {
    for (const ImpactKind& kind : impact_kinds(blocks)) {
      for (int i = 0; i < draws.cells * draws.cells; ++i) {
        const Range aspect_ratio = part(draws.aspect_ratio, i % draws.cells, draws.cells);
        const Range mass_ratio = part(draws.mass_ratio, i / draws.cells, draws.cells);
        result.shares.push_back({blocks, kind, aspect_ratio, mass_ratio});
        fill(draws, result.shares.back(), random, result.disagreements);
      }
    }
  }
  return result;
}

}  // namespace rockstack
