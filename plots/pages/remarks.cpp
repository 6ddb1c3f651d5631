#include <fmt/format.h>

#include "plots/data/scores.hpp"
#include "plots/pages/sections.hpp"

namespace rockstack::plots {
namespace {

/// Energy gained, as a share of weight times height, that is worth a word: beyond rounding of 32 bits.
constexpr double reported_gain = 1e-4;
/// How many times worse than another a number is that is worth a word: replicates alone differ by as much.
constexpr double reported_ratio = 2;

/// The scene of a run again, with its solver in both sets, at these steps.
std::string command(const Comparison& comparison, const Run& run, const std::vector<double>& steps) {
  const auto scene = std::ranges::find(comparison.scenes, run.scene, &ComparedScene::name);
  return fmt::format("rockstack compare {} --engine {} --dt {} --set duration={} --out DIR", run.scene,
                     run.solver_name(), fmt::join(steps, ","), scene->duration);
}

/// All steps of a run's series, the largest first.
std::vector<double> steps_of(const Comparison& comparison, const Run& run) {
  std::set<double> steps;
  for (const Run& other : comparison.runs)
    if (other.scene == run.scene && other.solver_name() == run.solver_name() && other.dt)
      steps.insert(*other.dt);
  return {steps.rbegin(), steps.rend()};
}

std::vector<Score> answers_to(const std::string& question, const Comparison& comparison) {
  return scores(comparison, *std::ranges::find(solver_questions(), question, &SolverQuestion::name));
}

/// Those of tuned sets where a solver has one.
std::vector<Score> best_of(std::vector<Score> list) {
  std::set<std::string> tuned;
  for (const Score& score : list)
    if (score.runs.front().settings == "tuned") tuned.insert(score.runs.front().solver_name());
  std::erase_if(list, [&](const Score& score) {
    const Run& run = score.runs.front();
    return run.settings != "tuned" && tuned.contains(run.solver_name());
  });
  return list;
}

/// The first of a solver, and of these settings where some are named; null where there is none.
const Score* find_score(const std::vector<Score>& list, const std::string& solver,
                        const std::string& settings = "") {
  const auto found = std::ranges::find_if(list, [&](const Score& score) {
    const Run& run = score.runs.front();
    return run.solver_name() == solver && (settings.empty() || run.settings == settings);
  });
  return found == list.end() ? nullptr : &*found;
}

/// Parameters that differ between two runs: "erp 0.2 → 0.01".
std::vector<std::string> changed_parameters(const Run& from, const Run& to) {
  constexpr std::string_view prefix = "parameters.";
  const auto facts = [](const Run& run) { return read_json(run.folder / "summary.json", facts_of); };
  std::map<std::string, std::string> before;
  for (const auto& [name, text] : facts(from)) before[name] = text;
  std::vector<std::string> words;
  for (const auto& [name, text] : facts(to))
    if (name.starts_with(prefix) && before[name] != text)
      words.push_back(fmt::format("{} {} → {}", name.substr(prefix.size()), before[name], text));
  return words;
}

class Writer {
 public:
  explicit Writer(const Comparison& comparison) : comparison_(comparison) {}

  std::vector<SolverRemarks> all() const {
    std::vector<SolverRemarks> list;
    for (const Score& score : accuracy_) {
      const std::string solver = score.runs.front().solver_name();
      list.push_back({solver, {}});
      for (const auto add : {&Writer::add_accuracy, &Writer::add_sets, &Writer::add_convergence,
                             &Writer::add_worst, &Writer::add_failures})
        (this->*add)(solver, list.back().list);
    }
    return list;
  }

 private:
  std::string again(const Run& run) const { return command(comparison_, run, {value_of(run.dt)}); }

  void add_accuracy(const std::string& solver, std::vector<Remark>& list) const {
    const Score& score = *find_score(accuracy_, solver);
    const Run& worst = score.worst();
    const std::vector<RankedSet>& ranking = comparison_.verdict.ranking;
    const auto set =
        std::ranges::find_if(ranking, [&](const RankedSet& one) { return set_name(one) == set_name(worst); });
    if (set == ranking.end()) return;
    const auto sharing =
        std::ranges::count_if(ranking, [&](const RankedSet& one) { return one.rank == set->rank; });
    list.push_back(
        {fmt::format("Rank {} of {}{}: with its {} set its error is {:.2g} times the least, in the "
                     "geometric mean of {} of scene and step; at {} most in {} ({:.2g}).",
                     set->rank, counted(ranking.size(), "set"),
                     sharing > 1 ? fmt::format(", which {} share", sharing) : "", worst.settings, set->score,
                     counted(static_cast<std::size_t>(set->cells), "pair"), duration_text(value_of(worst.dt)),
                     worst.scene, value_of(worst.error)),
         again(worst)});
  }

  void add_sets(const std::string& solver, std::vector<Remark>& list) const {
    const Score& tuned = *find_score(accuracy_, solver);
    const Score* defaults = find_score(all_, solver, "default");
    if (defaults == nullptr || defaults->median < reported_ratio * tuned.median) return;
    const std::vector<std::string> changes = changed_parameters(defaults->runs.front(), tuned.runs.front());
    list.push_back({fmt::format("Its defaults are {:.1f} times as far off. The tuned set differs by: {}.",
                                defaults->median / tuned.median,
                                changes.empty() ? "nothing that is told" : joined(changes)),
                    again(defaults->worst())});
  }

  void add_convergence(const std::string& solver, std::vector<Remark>& list) const {
    for (const Run& run : find_score(accuracy_, solver)->runs) {
      const StepFit* const fit = fit_of(comparison_, {run}, "rms_angle_difference");
      if (fit != nullptr && fit->holds() && fit->model_error.low > 0)
        list.push_back(
            {fmt::format("In {} an error of {:.2g} rad [{:.2g}, {:.2g}] is left however small the step: what "
                         "contacts do there is another law, or a parameter that no step changes.",
                         run.scene, fit->model_error.value, fit->model_error.low, fit->model_error.high),
             command(comparison_, run, steps_of(comparison_, run))});
    }
    const Score* score = find_score(convergence_, solver);
    if (score == nullptr) return;
    const auto [coarsest, finest] = step_ends(comparison_, score->worst());
    list.push_back(
        {fmt::format("From a step of {} to {} its error falls to {:.2g} of what it was, in the median of {} "
                     "scenes; order one would leave {:.2g}.",
                     duration_text(value_of(coarsest->dt)), duration_text(value_of(finest->dt)),
                     score->median, score->runs.size(), value_of(finest->dt) / value_of(coarsest->dt)),
         command(comparison_, *finest, steps_of(comparison_, *finest))});
  }

  /// What contacts do and steps cost, where that is worst.
  void add_worst(const std::string& solver, std::vector<Remark>& list) const {
    const auto add = [&](const std::vector<Score>& scores, const auto& sentence) {
      const Score* score = find_score(scores, solver);
      if (score == nullptr) return;
      const std::string words = sentence(*score, *std::ranges::max_element(score->values));
      if (!words.empty()) list.push_back({words, again(score->worst())});
    };
    add(energy_, [](const Score& score, double most) {
      return most < reported_gain
                 ? ""
                 : fmt::format("In {} its contacts make energy: {:.2g} of the stack's weight times height.",
                               score.worst().scene, most);
    });
    add(overlap_, [](const Score& score, double most) {
      return fmt::format("Blocks sink into each other by up to {:.2g} m ({}).", most, score.worst().scene);
    });
    add(cost_, [&](const Score& score, double) {
      const double quickest = cost_.front().median;
      return score.median < reported_ratio * quickest
                 ? fmt::format("A step takes {}, among the quickest.", rounded_duration(score.median))
                 : fmt::format("A step takes {}, {:.2g} times as long as the quickest solver's.",
                               rounded_duration(score.median), score.median / quickest);
    });
  }

  void add_failures(const std::string& solver, std::vector<Remark>& list) const {
    std::size_t runs = 0, failed = 0;
    const Run* last = nullptr;
    for (const Run& run : comparison_.runs) {
      if (run.exact() || run.solver_name() != solver) continue;
      ++runs;
      if (run.done()) continue;
      ++failed;
      last = &run;
    }
    if (last != nullptr)
      list.push_back({fmt::format("{} of {} failed, at last {}: {}.", failed, counted(runs, "run"),
                                  last->scene, last->reason.empty() ? name(last->status) : last->reason),
                      again(*last)});
  }

  const Comparison& comparison_;
  const std::vector<Score> all_ = answers_to("accuracy", comparison_), accuracy_ = best_of(all_),
                           convergence_ = best_of(answers_to("convergence", comparison_)),
                           energy_ = best_of(answers_to("energy", comparison_)),
                           overlap_ = best_of(answers_to("overlap", comparison_)),
                           cost_ = best_of(answers_to("cost", comparison_));
};

}  // namespace

std::vector<SolverRemarks> remarks(const Comparison& comparison) {
  return has_scores(comparison) ? Writer(comparison).all() : std::vector<SolverRemarks>{};
}

std::string remarks_section(const Comparison& comparison) {
  const std::vector<SolverRemarks> list = remarks(comparison);
  if (list.empty()) return "";
  std::string text = element("p",
                             "Medians over scenes; the figures above have the scenes. Ranks are those of the "
                             "comparison's verdict: sets that replicates do not tell apart share one.",
                             " class=\"hint\"") +
                     "\n";
  for (const SolverRemarks& solver : list) {
    const std::string items = joined_texts(solver.list, [](const Remark& one) {
      return element("li", escaped(one.sentence) + " " + element("code", escaped(one.command))) + "\n";
    });
    text += element("h3", escaped(solver.solver)) + element("ul", items) + "\n";
  }
  return section("What each solver's author can act on", text, " id=\"solvers\"");
}

}  // namespace rockstack::plots
