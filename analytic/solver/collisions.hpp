#pragma once

#include "analytic/events/chatter.hpp"
#include "analytic/scene/wall.hpp"
#include "analytic/solver/recorder.hpp"

namespace rockstack {

/// What follows where interfaces close: an impact, or the end of chatter.
template <class Real, int N>
class Collisions {
 public:
  /// Keeps references to `scene` and `model`, its model.
  Collisions(const Scene& scene, const Model<Real, N>& model, const SolveOptions& options)
      : scene_(scene),
        model_(model),
        end_of_chatter_(model, resolution_of(options)),
        zeno_(model, resolution_of(options)),
        sums_chatter_(options.events == EventsKept::summed && zeno_.worthwhile() && !upright_ &&
                      scene.wall.side == 0 && model.pushes.empty() && model.restraints.empty()) {}

  /// As EndOfChatter tells.
  bool negligibly_open(const State<Real, N>& state, int k) const {
    return end_of_chatter_.negligibly_open(state, k);
  }

  /// What follows an impact, `offset` into a ground piece; `directions` are those at its state. `foreseen` is
  /// what is known of it, or null. Noted are its impulses as they are, not those of a closure that stands for
  /// the impacts to come.
  Resolution<Real, N> outcome(const Impact<Real, N>& impact, const Directions<Real, N>& directions,
                              const GroundPiece<Real>& piece, const Real& offset, Recorder<Real, N>& recorder,
                              const PredictedImpact<Real, N>* foreseen) {
    const Model<Real, N>& model = upright_ ? *upright_ : model_;
    const BeforeImpact<Real, N> before = foreseen   ? foreseen->before
                                         : upright_ ? before_impact(model, impact.before)
                                                    : before_impact(model, impact.before, directions);
    Resolution<Real, N> resolution = foreseen
                                         ? Resolution<Real, N>{foreseen->solution, Consistency::consistent}
                                         : resolve(model, impact, before, scene_.law);
    PatternSolution<Real, N>& solution = resolution.solution;
    keep_own_ratio(impact, before, solution);
    if (scene_.wall.side != 0)  // whose impulses the ground shares as it will
      resolution = {strike(model, impact, before), Consistency::consistent};
    else
      recorder.note_impact(solution, piece.start + offset);
    const PatternSolution<Real, N> parting = solution;
    close_slow(model, impact, before, directions, piece.at(offset), resolution);
    if (sums_chatter_ && !resolution.closes)
      if (const auto rest =
              negligible_rest({impact, before, solution, piece, offset, recorder.events()}, recorder)) {
        solution = rest->closure;
        resolution.closes = true;
      }
    if (resolution.closes)
      resolution.chatter = chatter_left(impact, parting, solution.pattern, directions, piece.at(offset));
    return resolution;
  }

  /// What follows impulses and steps of the ground's velocity: of what touches, the pattern that pushing
  /// impulses can bring about, by any law, as at the end of chatter. Where none is, the pattern stays, and
  /// says so.
  [[gnu::cold]] Resolution<Real, N> kicked(const State<Real, N>& state, const Interfaces& touching,
                                           const Directions<Real, N>& directions,
                                           const GroundPiece<Real>& piece, const Loading<Real>& steps,
                                           Recorder<Real, N>& recorder) {
    const Model<Real, N>& model = upright_ ? *upright_ : model_;
    BeforeImpact<Real, N> before =
        upright_ ? before_impact(model, state) : before_impact(model, state, directions);
    before.motion.centre.colwise() -= steps.ground;
    if (steps.pushes > 0) add_pushes(model, directions, steps, before.motion);
    const auto evaluate = [&](const Pattern& pattern) { return velocities_after(model, before, pattern); };
    const auto found = find_admissible(model.stack, state.pattern, touching, Real(0), evaluate);
    Resolution<Real, N> resolution{found ? *found : evaluate(state.pattern), Consistency::none};
    if (found && rockstack::pushes(*found)) resolution.consistency = Consistency::consistent;
    recorder.note_impact(resolution.solution, piece.start);
    close_slow(model, {state, touching}, before, directions, piece.at(0), resolution);
    return resolution;
  }

 private:
  /// Strike of a block at its wall, which it leaves by the ratio of that, about the same corner.
  [[gnu::cold]] PatternSolution<Real, N> strike(const Model<Real, N>& model, const Impact<Real, N>& impact,
                                                const BeforeImpact<Real, N>& before) const {
    const Vector<Real, N> relative = Real(-wall_restitution(scene_)) * impact.before.velocities;
    const Pattern pattern = relative[0] == 0 ? closed_pattern(impact.before.size()) : impact.before.pattern;
    return solution_for(model, pattern, before.directions,
                        make_chain(model.stack, pattern, before.directions), before.motion, relative);
  }

  /// Ends chatter: closes what would part too slowly.
  void close_slow(const Model<Real, N>& model, const Impact<Real, N>& impact,
                  const BeforeImpact<Real, N>& before, const Directions<Real, N>& directions,
                  const Loading<Real>& loading, Resolution<Real, N>& resolution) const {
    PatternSolution<Real, N>& solution = resolution.solution;
    const auto without_slow = [&] {
      return end_of_chatter_.without_slow({solution.pattern, impact.before.angles, solution.relative},
                                          impact.touching(), directions, loading);
    };
    for (Pattern slow = without_slow(); !(slow == solution.pattern); slow = without_slow()) {
      solution = velocities_after(model, before, slow);
      resolution.closes = true;
    }
  }

  /// What impacts of small-angle equations are resolved with: the stack as it is, upright.
  static std::optional<Model<Real, N>> upright_model(const Scene& scene) {
    if (scene.equations != Equations::small_angle) return std::nullopt;
    return Model<Real, N>{make_stack<Real, N>(scene), make_model<Real, N>(scene).gravity, Equations::linear};
  }

  /// Replaces the law's solution by that of a scene's own ratio, where it has one for this impact.
  void keep_own_ratio(const Impact<Real, N>& impact, const BeforeImpact<Real, N>& before,
                      PatternSolution<Real, N>& solution) const {
    if (scene_.restitution.empty()) return;
    const Model<Real, N>& model = upright_ ? *upright_ : model_;
    if (const auto own = restored(model, impact, before, solution.pattern, scene_.restitution))
      solution = *own;
  }

  /// How long an interface goes on to chatter that parts from an impact as `parting` tells and is `closed`
  /// instead, s. With u its speed, a what brings it back on either side and η the ratios of impacts there, 1
  /// where it is first, impacts come to their end after 2u (1/a₁ + η₁/a₂) / (1 − η₁ η₂), but for terms in u²:
  /// nothing but that interface moves in so short a time. 0 where several chatter, or an impact would do more
  /// than throw it.
  [[gnu::cold]] Real chatter_left(const Impact<Real, N>& impact, const PatternSolution<Real, N>& parting,
                                  const Pattern& closed, const Directions<Real, N>& directions,
                                  const Loading<Real>& loading) const {
    int slow = -1;
    for (int k = 0; k < parting.size(); ++k) {
      if (parting.pattern[k] == closed[k]) continue;
      if (slow >= 0) return 0;
      slow = k;
    }
    const Vector<Real, N>& angles = impact.before.angles;
    const bool at_wall = scene_.wall.side != 0;  // all flights are to one side
    std::array<Real, 2> duration;                // of flights, for unit speed
    std::array<Real, 2> ratio;
    Pattern pattern = parting.pattern;
    for (std::size_t side = 0; side < 2; ++side) {
      const Real back = accelerations(model_, {pattern, angles, parting.relative}, directions, loading)[slow];
      duration[side] = -2 * Real(sign(pattern[slow])) / back;
      ratio[side] = at_wall ? Real(wall_restitution(scene_))
                    : side == 1 && pattern == impact.before.pattern && impact.impacting.count() == 1
                        ? parting.relative[slow] / impact.before.velocities[slow]  // of that impact itself
                        : unit_ratio(pattern, angles, directions, slow);
      if (!at_wall) pattern[slow] = opposite(pattern[slow]);
    }
    const bool ends = std::min(duration[0], duration[1]) > 0 && ratio[0] * ratio[1] < 1 &&
                      std::min(ratio[0], ratio[1]) >= 0;
    if (!ends) return 0;
    return abs(parting.relative[slow]) * (duration[0] + ratio[0] * duration[1]) / (1 - ratio[0] * ratio[1]);
  }

  /// What an impact of one interface alone leaves of its speed; −1 where it does more than throw that one.
  [[gnu::cold]] Real unit_ratio(const Pattern& pattern, const Vector<Real, N>& angles,
                                const Directions<Real, N>& directions, int interface) const {
    const Model<Real, N>& model = upright_ ? *upright_ : model_;
    Vector<Real, N> closing = Vector<Real, N>::Zero(pattern.size);
    closing[interface] = -Real(sign(pattern[interface]));
    const Impact<Real, N> impact{{pattern, angles, closing}, Interfaces().set(interface)};
    const auto before =
        upright_ ? before_impact(model, impact.before) : before_impact(model, impact.before, directions);
    PatternSolution<Real, N> after = resolve(model, impact, before, scene_.law).solution;
    keep_own_ratio(impact, before, after);
    Pattern thrown = pattern;
    thrown[interface] = opposite(pattern[interface]);
    return after.pattern == thrown ? abs(after.relative[interface]) : Real(-1);
  }

  static Real resolution_of(const SolveOptions& options) {
    return options.resolution > 0 ? Real(options.resolution) : std::numeric_limits<Real>::epsilon();
  }

  /// What is left of chatter, where it neither moves the motion nor holds what is asked for.
  std::optional<RestOfChatter<Real, N>> negligible_rest(
      const typename ZenoSummation<Real, N>::Landing& landing, const Recorder<Real, N>& recorder) {
    const PatternSolution<Real, N>& after = landing.after;
    if (!zeno_.below_resolution(landing) || recorder.keeps(after)) return std::nullopt;
    const State<Real, N> open{after.pattern, landing.impact.before.angles, after.relative};
    const Loading<Real> ground = landing.piece.at(landing.offset);
    auto rest = zeno_.rest(landing, end_of_chatter_.fastest_return(open, ground));
    if (rest && recorder.wants(*rest, landing.piece.start + landing.offset)) rest.reset();
    return rest;
  }

  const Scene& scene_;
  const Model<Real, N>& model_;
  std::optional<Model<Real, N>> upright_ = upright_model(scene_);  ///< of impacts, where they need their own
  EndOfChatter<Real, N> end_of_chatter_;
  ZenoSummation<Real, N> zeno_;
  bool sums_chatter_;
};

}  // namespace rockstack
