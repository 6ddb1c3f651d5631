#include "comparisons/runs/paper_statements.hpp"

#include <fmt/format.h>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"

namespace rockstack {
namespace {

constexpr std::size_t base = 0;
constexpr std::size_t top = 1;

Verdict verdict(bool holds) {
  return holds ? Verdict::holds : Verdict::fails;
}

/// "exact 1.0, bullet 1.1, ode 1.2" for a number of each answer.
std::string each(const std::vector<Answer>& answers, const std::function<double(const History&)>& value) {
  return joined_texts(
      answers, [&](const Answer& one) { return fmt::format("{} {:.4g}", one.name, value(one.history)); },
      ", ");
}

bool lands(const Event& event) {
  return event.kind == EventKind::impact && event.interface == 1;
}

bool base_comes_to_rest(const Event& event) {
  return event.interface == 1 && event.to[0] == Contact::closed;
}

bool moves_base(const Event& event) {
  return event.from[0] == Contact::closed && event.to[0] != Contact::closed;
}

bool hits_base(const Event& event) {
  return moves_base(event) && event.kind != EventKind::opening;
}

/// Precondition: there is one.
const Event& first_of(const History& exact, bool (*wanted)(const Event&)) {
  return *std::ranges::find_if(exact.events, wanted);
}

Statement turns_as_one(const Evidence& evidence) {
  const double impact = first_of(evidence.free_exact(), lands).time;
  const Event& first = evidence.free_exact().events.front();
  return {"Fig. 18", "The stack turns as one body until the base meets the ground.",
          verdict(first.kind != EventKind::opening || first.time >= impact),
          "no event before the first ground impact",
          fmt::format("the top block opens at {:.4f} s, by the paper's own Eq. (29); its angle relative to "
                      "the base at the ground impact ({:.4f} s), rad: {}",
                      first.time, impact, each(evidence.free_answers, [&](const History& history) {
                        return angle_at(history, top, impact) - angle_at(history, base, impact);
                      }))};
}

Statement goes_to_1b(const Evidence& evidence) {
  const Event& impact = first_of(evidence.free_exact(), lands);
  const auto next = std::ranges::upper_bound(evidence.free_exact().events, impact.time, {}, &Event::time);
  return {"Fig. 18",
          "At the first ground impact the top block starts to rock about its left corner, pattern 1b.",
          verdict(name(impact.to) == "1b"), "the pattern after the first ground impact is 1b",
          fmt::format("exact: {} to {} at {:.4f} s, then {} to {} at {:.4f} s, when the blocks meet",
                      name(impact.from), name(impact.to), impact.time, name(next->from), name(next->to),
                      next->time)};
}

Statement faster_after_impact(const Evidence& evidence) {
  const Event& impact = first_of(evidence.free_exact(), lands);
  const double window = 1e-3;
  return {"Fig. 18", "The first impact increases the angular velocity of the top block.",
          verdict(std::abs(impact.after[top]) > std::abs(impact.before[top])),
          "its absolute value is larger after than before",
          fmt::format(
              "exact {:.4f} to {:.4f} rad/s; mean over 1 ms after the impact less that before, rad/s: {}",
              impact.before[top], impact.after[top], each(evidence.free_answers, [&](const History& history) {
                const double here = angle_at(history, top, impact.time);
                const double before = here - angle_at(history, top, impact.time - window);
                return (angle_at(history, top, impact.time + window) - here - before) / window;
              }))};
}

Statement base_rests_early(const Evidence& evidence) {
  const auto second = [](const History& history) {
    const auto list = swings(history, base);
    return list.size() > 1 ? list[1].peak : 0;
  };
  return {"Fig. 18", "The base comes to rest for a while very soon; its second swing is already small.",
          verdict(second(evidence.free_exact()) < 0.2 * evidence.free.initial.angles[base]),
          "the second swing stays below a fifth of the first",
          fmt::format("exact: at rest from {:.4f} s; largest angle of the second swing, rad: {}",
                      first_of(evidence.free_exact(), base_comes_to_rest).time,
                      each(evidence.free_answers, second))};
}

Statement base_is_hit(const Evidence& evidence) {
  const auto& events = evidence.free_exact().events;
  const auto onsets = std::ranges::count_if(events, moves_base),
             by_impact = std::ranges::count_if(events, hits_base);
  return {
      "Fig. 18", "The base rocks again a few times, as a rule because the top block hits it.",
      verdict(2 * by_impact > onsets), "most onsets of base motion are impacts between the blocks",
      fmt::format("exact: {} of {} onsets, most of them within the chatter before rest", by_impact, onsets)};
}

Statement amplitudes(const Evidence& evidence) {
  const auto list = swings(evidence.free_exact(), top);
  bool falls = list.size() > 4 && list[1].peak > list[0].peak;
  for (std::size_t i = 2; i < 5 && falls; ++i) falls = list[i].peak < list[i - 1].peak;
  const auto first_four = [](const Answer& answer) {
    std::vector<double> peaks = mapped(swings(answer.history, top), &Swing::peak);
    peaks.resize(std::min<std::size_t>(peaks.size(), 4));
    return fmt::format("{} {:.4f}", answer.name, fmt::join(peaks, " "));
  };
  return {
      "Fig. 18", "The top block's swings get smaller, except the second.", verdict(falls),
      "the second peak is larger than the first, each later one (to the fifth) smaller than the one before",
      fmt::format("first four peaks, rad: {}", joined_texts(evidence.free_answers, first_four, ", "))};
}

Statement angle_at_one_second(const Evidence& evidence) {
  const auto at_one = [](const History& history) { return std::abs(angle_at(history, top, 1.0)); };
  const Swing peak = largest_swing(evidence.free_exact(), top);
  return {"Fig. 18", "At 1 s the top block's angle reaches 0.183 rad, more than at the start.",
          verdict(std::abs(at_one(evidence.free_exact()) - 0.183) <= 0.0005), "0.183 rad to the digits given",
          fmt::format("at 1 s, rad: {}; the peak is {:.4f} rad, at {:.3f} s",
                      each(evidence.free_answers, at_one), peak.peak, peak.peak_time)};
}

Statement impact_alone(const Evidence& evidence) {
  const auto& events = evidence.free_exact().events;
  const auto openings = std::ranges::count(events, EventKind::opening, &Event::kind);
  return {"Fig. 18", "In free rocking, patterns change by impact alone.", verdict(openings == 0),
          "no opening without impact",
          fmt::format("exact: {} opening, of the top block at {:.4f} s", openings, events.front().time)};
}

Statement periods_change(const Evidence& evidence) {
  const auto ratio = [](const History& history) {
    const auto list = swings(history, top);
    return list.size() > 4 ? (list[1].end - list[0].end) / (list[4].end - list[3].end) : 1;
  };
  return {"Fig. 18", "The period changes much from swing to swing.",
          verdict(ratio(evidence.free_exact()) > 1.5),
          "the top block's second swing lasts more than 1.5 times its fifth",
          fmt::format("second swing over fifth: {}", each(evidence.free_answers, ratio))};
}

Statement linear_deviates(const Evidence& evidence) {
  const History& exact = evidence.free_exact();
  std::array<double, 2> largest{};
  std::array<int, 2> beyond{};
  for (std::size_t i = 0; i < exact.size(); ++i)
    for (const std::size_t block : {base, top}) {
      const double apart = std::abs(exact.angles_at(i)[block] - evidence.free_linear.angles_at(i)[block]);
      largest[block] = std::max(largest[block], apart);
      if (apart > 0.1 * evidence.free.initial.angles[block]) ++beyond[block];
    }
  const auto share = [&](std::size_t block) {
    return 100.0 * beyond[block] / static_cast<double>(exact.size());
  };
  return {"Figs. 19, 20", "The linear equations deviate significantly, for times that cannot be neglected.",
          verdict(share(base) > 1 && share(top) > 1),
          "more than a tenth of the release angle for over 1 % of the time, both blocks",
          fmt::format("base: up to {:.4f} rad, {:.1f} % of the time; top: up to {:.4f} rad, {:.1f} %",
                      largest[base], share(base), largest[top], share(top))};
}

Statement base_moves_less(const Evidence& evidence) {
  const auto peak_ratio = [](const History& history) {
    return largest_swing(history, base).peak / largest_swing(history, top).peak;
  };
  return {"Fig. 22", "The base moves much less than the top block.",
          verdict(peak_ratio(evidence.shaken_exact()) < 0.5), "its peak is below half the top block's",
          fmt::format("peak of base over peak of top: {}", each(evidence.shaken_answers, peak_ratio))};
}

Statement peaks_come_late(const Evidence& evidence) {
  const History& exact = evidence.shaken_exact();
  const auto& samples = evidence.shaken.horizontal.samples;
  const auto strongest = std::ranges::max_element(samples, {}, [](double one) { return std::abs(one); });
  const double shock = evidence.shaken.horizontal.interval * static_cast<double>(strongest - samples.begin());
  const auto peak_time = [](std::size_t block) {
    return [block](const History& history) { return largest_swing(history, block).peak_time; };
  };
  const double base_time = peak_time(base)(exact), top_time = peak_time(top)(exact);
  return {"Fig. 22",
          "The blocks' largest angles come at different times, and not right after the peak of acceleration.",
          verdict(base_time != top_time && base_time - shock > 0.5 && top_time - shock > 0.5),
          "each more than 0.5 s after it",
          fmt::format("acceleration peaks at {:.2f} s; base at, s: {}; top at, s: {}", shock,
                      each(evidence.shaken_answers, peak_time(base)),
                      each(evidence.shaken_answers, peak_time(top)))};
}

Statement hit_base_rocks_as_one(const Evidence& evidence) {
  const auto& events = evidence.shaken_exact().events;
  const auto hits = std::ranges::count_if(events, hits_base);
  const auto as_one = std::ranges::count_if(
      events, [](const Event& event) { return hits_base(event) && event.to[1] == Contact::closed; });
  return {"Fig. 22", "Where the top block hits the base and sets it in motion, the stack rocks as one body.",
          verdict(hits > 0 && as_one == hits), "the pattern after each such impact is 3a or 3b",
          fmt::format("exact: {} of {} such impacts", as_one, hits)};
}

Statement ends_before_the_record(const Evidence& evidence) {
  const auto& events = evidence.shaken_exact().events;
  const double end = evidence.shaken.horizontal.end(), last = events.empty() ? 0 : events.back().time;
  return {"Fig. 22", "Rocking ends before the record does.",
          verdict(!events.empty() && is_closed(events.back().to) && last < end),
          "the last event is rest, before the last sample",
          fmt::format("exact: last event at {:.2f} s, the motion of the ground ends at {:.2f} s", last, end)};
}

std::vector<Answer> answers(const Suite& suite, const Scene& scene) {
  constexpr double usual_step = 1e-3;  // near which engines are asked, s
  std::vector<Answer> list{{"exact", solve(scene, {.sample_times = regular_times(1e-4, scene.duration)})}};
  for (const EngineSeries& series : suite.series) {
    if (series.settings != "tuned") continue;
    const double step = *std::ranges::min_element(
        series.steps, {}, [](double one) { return std::abs(std::log(one / usual_step)); });
    try {
      list.push_back({series.engine->name, simulate(*series.engine, scene, step, series.parameters).history});
    } catch (const std::runtime_error&) {
      continue;  // the comparison's own row of this run says why
    }
  }
  return list;
}

/// What keeps scenes from being held against what the paper says of its own; empty where nothing does.
std::string unlike_the_papers(const Evidence& evidence) {
  const auto& events = evidence.free_exact().events;
  const auto rocks = [](const std::vector<Answer>& answers) {
    return std::ranges::all_of(answers, [](const Answer& answer) {
      return largest_swing(answer.history, base).peak > 0 && largest_swing(answer.history, top).peak > 0;
    });
  };
  if (std::ranges::none_of(events, lands)) return "in the free scene no block lands on the ground";
  if (std::ranges::none_of(events, base_comes_to_rest) ||
      events.back().time <= first_of(evidence.free_exact(), lands).time)
    return "in the free scene the base does not come to rest";
  if (!rocks(evidence.free_answers)) return "in the free scene not both blocks rock";
  if (!rocks(evidence.shaken_answers)) return "in the shaken scene not both blocks rock";
  return evidence.shaken.horizontal.samples.empty() ? "the shaken scene has no record" : "";
}

}  // namespace

std::string name(Verdict verdict) {
  return verdict == Verdict::holds ? "holds" : verdict == Verdict::fails ? "fails" : "undecidable";
}

Evidence gather(const Suite& suite) {
  Evidence evidence;
  evidence.free = part_named(suite.scenes, suite.statements->free).scene;
  evidence.shaken = part_named(suite.scenes, suite.statements->shaken).scene;
  evidence.shaken.duration = std::max(evidence.shaken.duration, evidence.shaken.horizontal.end());
  evidence.free_answers = answers(suite, evidence.free);
  evidence.shaken_answers = answers(suite, evidence.shaken);
  Scene linear = evidence.free;
  linear.equations = Equations::linear;
  evidence.free_linear = solve(linear, {.sample_times = evidence.free_exact().times});
  return evidence;
}

std::vector<Statement> judge(const Evidence& evidence) {
  if (const std::string unlike = unlike_the_papers(evidence); !unlike.empty())
    return {{"Section 5", "What the paper says is of its own two examples.", Verdict::undecidable,
             "scenes that do what the paper's do", unlike}};
  std::vector<Statement> statements;
  for (const auto statement :
       {turns_as_one, goes_to_1b, faster_after_impact, base_rests_early, base_is_hit, amplitudes,
        angle_at_one_second, impact_alone, periods_change, linear_deviates})
    statements.push_back(statement(evidence));
  for (const auto statement :
       {base_moves_less, peaks_come_late, hit_base_rocks_as_one, ends_before_the_record}) {
    Statement& last = statements.emplace_back(statement(evidence));
    last.computed = fmt::format("under {}, where the paper has Simi Valley 1994: {}",
                                evidence.shaken.horizontal.source, last.computed);
    if (evidence.shaken.horizontal.made_up) last.verdict = Verdict::undecidable;
  }
  return statements;
}

}  // namespace rockstack
