#include "comparisons/studies/canon/canon.hpp"

#include <fmt/format.h>

#include <numeric>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/statistics/fits.hpp"
#include "comparisons/measures/statistics/samples.hpp"
#include "comparisons/runs/execution/executor.hpp"
#include "comparisons/runs/job.hpp"

namespace rockstack {
namespace {

namespace fs = std::filesystem;

constexpr double usual_step = 1e-3;  ///< s
constexpr double vanishing = 1e-9;   ///< a deviation that is less is none, s

/// Largest speed of each block's slips or gaps between samples, m/s; over nothing there is no gap.
double largest_speed(const History& history, const std::vector<double>& ways) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  double most = 0;
  for (std::size_t i = blocks; i < ways.size(); ++i) {
    const double interval = history.times[i / blocks] - history.times[i / blocks - 1];
    const double speed = std::abs(ways[i] - ways[i - blocks]) / interval;
    if (std::isfinite(speed)) most = std::max(most, speed);
  }
  return most;
}

/// How far gaps differ at most, m, negative where blocks overlap.
double gap_difference(const History& exact, const History& engine) {
  double most = 0;
  for (std::size_t i = 0; i < std::min(exact.gaps.size(), engine.gaps.size()); ++i) {
    const double differs = std::abs(engine.gaps[i] - exact.gaps[i]);
    if (std::isfinite(differs)) most = std::max(most, differs);
  }
  return most;
}

/// Speed of the flattest turn: a corner falls freely for one step, rad/s.
double slowest_turn(const Scene& scene) {
  const Block& widest = *std::ranges::max_element(scene.blocks, {}, &Block::half_width);
  return scene.gravity * usual_step / (2 * widest.half_width);
}

/// At all steps, the finest and longest first, on all cores. @throws whatever kept the engine from answering.
std::vector<CanonErrors> errors_at_all_steps(const Suite& suite, const NamedScene& scene,
                                             const EngineSeries& series) {
  const auto runs = static_cast<std::size_t>(suite.replicates.runs);
  std::vector<CanonErrors> errors = mapped(canon_steps, [&](double step) {
    return CanonErrors{step, std::vector<std::vector<Deviation>>(runs)};
  });
  std::vector<std::size_t> all(errors.size() * runs);
  std::iota(all.rbegin(), all.rend(), 0);
  const auto compute = [&](std::size_t run) {
    CanonErrors& at = errors[run / runs];
    const auto number = static_cast<int>(run % runs);
    const Scene drawn = replicate_scene(scene.scene, suite.replicates, number);
    const double step = replicate_step(at.step, suite.replicates, number);
    const History engine = simulate(*series.engine, drawn, step, series.parameters, suite.limits).history;
    at.replicates[run % runs] = deviations(drawn, solve(drawn, {.sample_times = engine.times}), engine);
    return std::string();
  };
  make_threads(all_cores())->run(all, {compute});
  return errors;
}

/// Deviation of the replicate in the middle, by a quantity.
Deviation middle_of(const CanonErrors& errors, std::size_t quantity) {
  auto replicates = mapped(errors.replicates, [&](const auto& each) { return each.at(quantity); });
  const auto middle = replicates.begin() + static_cast<std::ptrdiff_t>((replicates.size() - 1) / 2);
  std::ranges::nth_element(replicates, middle, {}, &Deviation::time);
  return *middle;
}

/// Verdict and reason, from the fit and what the medians are.
std::pair<std::string, std::string> verdict_on(const std::vector<Deviation>& medians, const StepFit& fit) {
  const Deviation &coarsest = medians.front(), &finest = medians.back();
  const Bounded& left = fit.model_error;
  const auto amount = [&](double time) { return quantity_text(time * finest.speed, finest.unit(), 2); };
  // The three finest steps differ by four: under any order from a half on, the error falls by a
  // factor of two or more between them.
  const auto [finest_least, finest_most] =
      std::ranges::minmax_element(std::span(medians).last(3), {}, &Deviation::time);
  const double least = finest_least->time, most = finest_most->time;
  if (most <= canon_resolution)
    return {"agrees", "off by a tenth of a step of 1 ms at most at the three finest steps"};
  if (least > canon_resolution && most <= std::sqrt(2) * least)
    return {"another law",
            fmt::format("{}: {} to {} whatever the step", finest.of, amount(least), amount(most))};
  if (left.low > canon_resolution)
    return {"another law", fmt::format("{}: {} is left at any step ({} to {})", finest.of, amount(left.value),
                                       amount(left.low), amount(left.high))};
  if (std::max(finest.time, medians.end()[-2].time) <= vanishing)
    return {"converges", finest.of + ": nothing is left at the two finest steps"};
  if (!(finest.time <= 0.5 * coarsest.time))
    return {"cannot tell", fmt::format("{}: the errors do not fall with the step, {} at {} and {} at {}",
                                       finest.of, quantity_text(coarsest.amount(), coarsest.unit(), 2),
                                       quantity_text(canon_steps.front(), "s"), amount(finest.time),
                                       quantity_text(canon_steps.back(), "s"))};
  if (fit.points < medians.size() || fit.scatter > std::log(3))
    return {"cannot tell", finest.of + ": " + fit.reason};
  if (left.high > canon_agreement * usual_step)
    return {"cannot tell", fmt::format("{}: up to {} may be left at any step", finest.of, amount(left.high))};
  const char* verdict = finest.time <= canon_agreement * canon_steps.back() ? "agrees" : "converges";
  if (fit.holds())
    return {verdict, fmt::format("{}: fall with order {:.2g} ({:.2g} to {:.2g})", finest.of, fit.order.value,
                                 fit.order.low, fit.order.high)};
  return {verdict,
          fmt::format("{}: fall to {:.2g} steps at the finest", finest.of, finest.time / canon_steps.back())};
}

Json answer_json(const CanonAnswer& answer) {
  Json json{{"scene", answer.scene}, {"verdict", answer.verdict}, {"reason", answer.reason}};
  for (const char* list : {"steps_off", "amounts"}) json[list] = Json::array();
  if (answer.deviations.empty()) return json;
  json["quantity"] = answer.deviations.back().of;
  json["unit"] = answer.deviations.back().unit();
  for (std::size_t i = 0; i < answer.deviations.size(); ++i) {
    json["steps_off"].push_back(answer.deviations[i].time / canon_steps[i]);
    json["amounts"].push_back(answer.deviations[i].amount());
  }
  return json;
}

std::optional<CanonAnswer> kept_answer(const fs::path& file, const std::string& identity) {
  try {
    return read_json(file, [&](const Json& json) -> std::optional<CanonAnswer> {
      const Json& told = json.at("answer");
      if (json.at("identity") != identity) return {};
      CanonAnswer answer{told.at("scene"), {}, told.at("verdict"), told.at("reason")};
      for (const Json& one : json.at("deviations"))
        answer.deviations.push_back({one.at(0), one.at(1), one.at(2)});
      return answer;
    });
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

std::vector<Deviation> deviations(const Scene& scene, const History& exact, const History& engine) {
  const double turn = std::max(largest_magnitude(exact.velocities), slowest_turn(scene));
  std::vector<Deviation> all{{largest(difference(exact, engine)) / turn, turn, "angles"}};
  const auto slips = slip_difference(exact, engine);
  if (!slips) return all;
  const auto add = [&](const char* quantity, double way, const std::vector<double>& ways, double slowest) {
    const double speed = std::max(largest_speed(exact, ways), slowest);
    all.push_back({way / speed, speed, quantity});
  };
  add("slips", slips->largest, exact.slips, scene.gravity * usual_step);
  add("gaps", gap_difference(exact, engine), exact.gaps,
      told_sinking * least_height(scene.blocks) / canon_resolution);
  return all;
}

CanonAnswer judge_canon(const std::string& scene, const std::vector<CanonErrors>& errors) {
  const std::vector<std::string> from_best{"agrees", "converges", "cannot tell", "another law"};
  const auto off = [&](const CanonAnswer& answer) {
    return std::pair(std::ranges::find(from_best, answer.verdict), answer.deviations.back().time);
  };
  std::vector<CanonAnswer> answers;
  for (std::size_t quantity = 0; quantity < errors.front().replicates.front().size(); ++quantity) {
    CanonAnswer& answer = answers.emplace_back(CanonAnswer{scene, {}, "", ""});
    std::vector<StepError> medians;
    for (const CanonErrors& at : errors) {
      answer.deviations.push_back(middle_of(at, quantity));
      medians.push_back({at.step, answer.deviations.back().time});
    }
    std::tie(answer.verdict, answer.reason) = verdict_on(answer.deviations, fit_steps(medians));
  }
  return *std::ranges::max_element(answers,
                                   [&](const auto& one, const auto& other) { return off(one) < off(other); });
}

CanonAnswer answer_canon(const Suite& suite, const NamedScene& scene, const WorkerEngine& engine,
                         const std::string& settings) {
  const EngineSeries series = make_series(engine, settings, {});
  try {
    return judge_canon(scene.name, errors_at_all_steps(suite, scene, series));
  } catch (const std::exception& error) {
    return {.scene = scene.name, .deviations = {}, .reason = error.what()};
  }
}

CanonAnswer kept_canon_answer(const Suite& suite, const NamedScene& scene, const WorkerEngine& engine,
                              const std::string& settings, const fs::path& folder) {
  const EngineSeries series = make_series(engine, settings, {});
  std::string text;
  for (const double step : canon_steps) text += replicates_identity({suite, scene, step, &series});
  const std::string identity = fmt::format("{:016x}", checksum(text));
  const fs::path file =
      folder /
      (folder_name(fmt::format("{}-{}-{}-{}", engine.name, engine.solver, settings, scene.name)) + ".json");
  if (auto kept = kept_answer(file, identity)) return *std::move(kept);
  CanonAnswer answer = answer_canon(suite, scene, engine, settings);
  if (answer.deviations.empty()) return answer;
  fs::create_directories(folder);
  Json whole{{"identity", identity}, {"answer", answer_json(answer)}, {"deviations", Json::array()}};
  for (const Deviation& one : answer.deviations) whole["deviations"].push_back({one.time, one.speed, one.of});
  write_file(file, whole.dump(2) + "\n");
  return answer;
}

bool follows_law(const CanonAnswer& answer) {
  return answer.verdict == "agrees" || answer.verdict == "converges";
}

std::string canon_headline(const Suite& suite, const std::vector<CanonRow>& rows) {
  std::vector<std::string> first;
  std::ptrdiff_t most = 0;
  for (const CanonRow& row : rows) {
    const auto follows = std::ranges::count_if(row.answers, follows_law);
    if (follows > most) first.clear();
    most = std::max(most, follows);
    if (follows == most) first.push_back(fmt::format("{} ({})", row.engine->full_name(), row.settings));
  }
  const auto scenes = std::ssize(suite.scenes);
  if (most == 0)
    return fmt::format("No set agrees with the exact solution, or converges to it, in any of {} scenes.",
                       scenes);
  const bool one = first.size() == 1;
  return fmt::format(
      "{} {} with the exact solution, or {} to it, in {} of {} scenes{}.", joined_up_to(3, first),
      one ? "agrees" : "agree", one ? "converges" : "converge", most, scenes,
      rows.size() == 1 || most == scenes ? "" : fmt::format("; none of {} sets in more", rows.size()));
}

std::string canon_json(const Suite& suite, const std::vector<CanonRow>& rows, const std::string& command) {
  const auto scene_of = [](const NamedScene& scene) {
    return Json{{"name", scene.name}, {"title", scene.scene.title}, {"scene_file", scene.text}};
  };
  const auto row_of = [](const CanonRow& row) {
    return Json{{"engine", row.engine->name},
                {"solver", row.engine->solver},
                {"version", row.engine->version},
                {"settings", row.settings},
                {"answers", mapped(row.answers, answer_json)}};
  };
  const Json json{{"title", suite.title},
                  {"headline", {canon_headline(suite, rows)}},
                  {"command", command},
                  {"steps", canon_steps},
                  {"agreement", canon_agreement},
                  {"replicates", suite.replicates.runs},
                  {"scenes", mapped(suite.scenes, scene_of)},
                  {"rows", mapped(rows, row_of)},
                  {"environment", environment(mapped(rows, &CanonRow::engine))}};
  return json.dump(2) + "\n";
}

std::string canon_csv(const std::vector<CanonRow>& rows) {
  CsvWriter csv;
  csv.line("engine", "solver", "settings", "scene", "verdict", "reason", "quantity", "dt", "steps_off",
           "amount", "unit");
  for (const CanonRow& row : rows) {
    const auto line = [&](const CanonAnswer& answer, const auto&... values) {
      csv.line(row.engine->name, row.engine->solver, row.settings, answer.scene, answer.verdict,
               answer.reason, values...);
    };
    for (const CanonAnswer& answer : row.answers) {
      for (std::size_t i = 0; i < answer.deviations.size(); ++i) {
        const Deviation& one = answer.deviations[i];
        line(answer, one.of, canon_steps[i], one.time / canon_steps[i], one.amount(), one.unit());
      }
      if (answer.deviations.empty()) line(answer, "", "", "", "", "");
    }
  }
  return csv.text();
}

}  // namespace rockstack
