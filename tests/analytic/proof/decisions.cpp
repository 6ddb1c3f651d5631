#include "tests/analytic/proof/decisions.hpp"

#include <utility>

namespace rockstack::proof {
namespace {

using Interfaces = std::vector<std::size_t>;

/// All patterns in which these interfaces are left, closed or right.
std::vector<Pattern> candidates(const Pattern& pattern, const Interfaces& touching) {
  std::vector<Pattern> result{pattern};
  for (const std::size_t k : touching) {
    const std::vector<Pattern> before = std::exchange(result, {});
    result.reserve(3 * before.size());
    for (Pattern candidate : before)
      for (const int side : {-1, 0, 1}) {
        candidate[k] = side;
        result.push_back(candidate);
      }
  }
  return result;
}

enum class Verdict { holds, violated, unknown };

struct Judged {
  Verdict verdict = Verdict::holds;
  Trial trial;
};

Judged judge(const Pattern& pattern, const std::vector<Condition>& conditions) {
  Judged result{Verdict::holds, {pattern, {}}};
  for (const Condition& condition : conditions) {
    if (negative(condition.value)) return {Verdict::violated, {pattern, condition}};
    if (!positive(condition.value)) result.verdict = Verdict::unknown;
  }
  return result;
}

struct ImpactSolution {
  std::vector<Ball> rates;
  std::vector<Condition> kinematic;  ///< touching interfaces open towards their sides
  std::vector<Condition> impulsive;  ///< pivots push, and closed interfaces bear inside their widths
};

/// An impact at given angles: velocities before, and what each pattern makes of them.
class UnitImpact {
 public:
  UnitImpact(const Stack& stack, const Pattern& before, std::size_t hit, const std::vector<Ball>& angles)
      : stack_(stack), angles_(angles) {
    for (std::size_t k = 0; k < before.size(); ++k)
      if (k == hit || !before[k]) touching_.push_back(k);
    std::vector<Ball> rates(before.size());
    rates[hit] = Ball(-before[hit]);
    omega_ = summed(before, rates);
    velocities_ = centre_velocities(make_chain(stack, before, angles, rates), omega_);
  }

  const Interfaces& touching() const { return touching_; }

  ImpactSolution operator()(const Pattern& after) const {
    const Chain<Ball> chain = make_chain(stack_, after, angles_, std::vector<Ball>(after.size()));
    const Matrix<Ball> matrix = mass_matrix(stack_, after, chain);
    const std::vector<Ball> momenta = generalized_momenta(chain);
    ImpactSolution result{solve_open(after, matrix, momenta), {}, {}};
    for (const std::size_t k : touching_)
      if (after[k]) result.kinematic.push_back({"opens", k, Ball(after[k]) * result.rates[k]});
    const std::vector<Ball> normal =
        normal_impulses(chain, centre_velocities(chain, summed(after, result.rates)));
    for (std::size_t k = 0; k < after.size(); ++k) {
      result.impulsive.push_back({"pushes", k, normal[k]});
      if (after[k]) continue;
      const Margins<Ball> margins =
          margins_of(stack_.half_width[k], normal[k], residual(matrix, result.rates, momenta, k, after));
      result.impulsive.push_back({"right", k, margins.right});
      result.impulsive.push_back({"left", k, margins.left});
    }
    return result;
  }

 private:
  static std::vector<Point<Ball>> centre_velocities(const Chain<Ball>& chain,
                                                    const std::vector<Ball>& omega) {
    std::vector<Point<Ball>> result;
    Point<Ball> pivot{0, 0};
    for (std::size_t k = 0; k < omega.size(); ++k) {
      result.push_back(pivot + omega[k] * quarter_turned(chain.arms[k]));
      pivot = pivot + omega[k] * quarter_turned(chain.links[k]);
    }
    return result;
  }

  /// Momenta before along the motions that a chain allows.
  std::vector<Ball> generalized_momenta(const Chain<Ball>& chain) const {
    std::vector<Ball> momenta(omega_.size());
    Point<Ball> above{0, 0};
    for (std::size_t k = omega_.size(); k-- > 0;) {
      const Point<Ball> own = stack_.mass[k] * velocities_[k];
      momenta[k] = stack_.inertia[k] * omega_[k] + dot(quarter_turned(chain.arms[k]), own) +
                   dot(quarter_turned(chain.links[k]), above);
      above = above + own;
    }
    sum_downwards(momenta);
    return momenta;
  }

  /// Across the face of each interface: that of the lower block, or of the upper one that overhangs.
  std::vector<Ball> normal_impulses(const Chain<Ball>& chain, const std::vector<Point<Ball>>& after) const {
    std::vector<Ball> result(after.size());
    Point<Ball> impulse{0, 0};
    for (std::size_t k = after.size(); k-- > 0;) {
      impulse = impulse + stack_.mass[k] * (after[k] - velocities_[k]);
      if (k == 0 && !stack_.overhangs[k]) {
        result[k] = impulse.y;
        continue;
      }
      const SineCosine<Ball>& face = chain.directions[stack_.overhangs[k] ? k : k - 1];
      result[k] = impulse.x * face.sine + impulse.y * face.cosine;
    }
    return result;
  }

  const Stack& stack_;
  const std::vector<Ball>& angles_;
  Interfaces touching_;
  std::vector<Ball> omega_;
  std::vector<Point<Ball>> velocities_;
};

/// The only candidate that holds its conditions; nothing where all violate some. @throws Undecided
template <class Conditions>
std::optional<Pattern> only_one(const std::vector<Pattern>& patterns, const Conditions& conditions,
                                std::vector<Trial>& tried) {
  std::optional<Pattern> found;
  for (const Pattern& pattern : patterns) {
    const Judged judged = judge(pattern, conditions(pattern));
    if (judged.verdict == Verdict::unknown)
      throw Undecided("pattern " + letters(pattern) + " is on its limit");
    if (judged.verdict == Verdict::violated) tried.push_back(judged.trial);
    if (judged.verdict == Verdict::holds && found) throw Undecided("two patterns hold all conditions");
    if (judged.verdict == Verdict::holds) found = pattern;
  }
  return found;
}

/// The paper's order: open, joined, closed.
std::vector<Pattern> paper_trials(const Pattern& before, std::size_t hit, const Interfaces& touching) {
  Pattern open = before, joined = before, closed = before;
  for (const std::size_t k : touching) {
    open[k] = -before[hit];
    joined[k] = k == hit ? -before[hit] : 0;
    closed[k] = 0;
  }
  return {open, joined, closed};
}

Pattern first_of_paper(const UnitImpact& impact, const std::vector<Pattern>& trials,
                       std::vector<Trial>& tried) {
  for (const Pattern& pattern : {trials[0], trials[1]}) {
    const Judged judged = judge(pattern, impact(pattern).kinematic);
    if (judged.verdict == Verdict::unknown) throw Undecided("trial " + letters(pattern) + " is on its limit");
    if (judged.verdict == Verdict::holds) return pattern;
    tried.push_back(judged.trial);
  }
  return trials[2];
}

}  // namespace

Decision unit_impact(const Stack& stack, bool paper, const Pattern& before, std::size_t hit,
                     const std::vector<Ball>& angles) {
  const UnitImpact impact(stack, before, hit, angles);
  Decision decision;
  std::optional<Pattern> chosen;
  if (!paper)
    chosen = only_one(
        candidates(before, impact.touching()),
        [&](const Pattern& pattern) {
          ImpactSolution solution = impact(pattern);
          std::vector<Condition>& all = solution.kinematic;
          all.insert(all.end(), solution.impulsive.begin(), solution.impulsive.end());
          return all;
        },
        decision.tried);
  // Where no impulses that push bring a pattern about, law `consistent` falls back on the paper's order.
  decision.pattern =
      chosen ? *chosen : first_of_paper(impact, paper_trials(before, hit, impact.touching()), decision.tried);
  decision.rates = impact(decision.pattern).rates;
  return decision;
}

Decision opening_at_once(const Stack& stack, const Pattern& pattern, const std::vector<Ball>& angles,
                         const std::vector<Ball>& rates, const Point<Ball>& ground) {
  Interfaces closed;
  for (std::size_t k = 0; k < pattern.size(); ++k)
    if (!pattern[k]) closed.push_back(k);
  Decision decision;
  const auto conditions = [&](const Pattern& candidate) {
    const Accelerations<Ball> found = accelerate(stack, candidate, angles, rates, ground);
    std::vector<Condition> result;
    for (const std::size_t k : closed) {
      if (candidate[k]) {
        result.push_back({"opens", k, Ball(candidate[k]) * found.relative[k]});
      } else {
        result.push_back({"right", k, found.margins[k].right});
        result.push_back({"left", k, found.margins[k].left});
      }
    }
    return result;
  };
  const auto found = only_one(candidates(pattern, closed), conditions, decision.tried);
  if (!found) throw Undecided("no pattern lets the motion go on");
  decision.pattern = *found;
  return decision;
}

}  // namespace rockstack::proof
