#include "comparisons/studies/canon/canon.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "analytic/solve.hpp"
#include "comparisons/measures/metrics/difference.hpp"
#include "comparisons/measures/results/csv_writer.hpp"
#include "comparisons/measures/results/environment.hpp"
#include "comparisons/runs/execution/executor.hpp"

namespace rockstack {
namespace {

double largest_magnitude(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Of each block's slip over a step, m/s.
double largest_slip_speed(const History& history, double dt) {
  const auto blocks = static_cast<std::size_t>(history.blocks);
  double most = 0;
  for (std::size_t i = blocks; i < history.slips.size(); ++i)
    most = std::max(most, std::abs(history.slips[i] - history.slips[i - blocks]) / dt);
  return most;
}

/// Of the flattest turn: a corner falls freely for one step, rad/s.
double slowest_turn(const Scene& scene, double dt) {
  double widest = 0;
  for (const Block& block : scene.blocks) widest = std::max(widest, 2 * block.half_width);
  return scene.gravity * dt / widest;
}

/// @throws whatever kept the engine from answering.
Deviation answer_once(const Suite& suite, const NamedScene& scene, const EngineSeries& series, double dt,
                      int draw) {
  const Scene drawn = drawn_scene(scene.scene, suite.draws, draw);
  const double step = drawn_step(dt, suite.draws, draw);
  const History engine = simulate(*series.engine, drawn, step, series.parameters, suite.limits).history;
  return deviation_in_steps(drawn, solve(drawn, {.sample_times = engine.times}), engine, step);
}

/// That of the middle draw; draws use all cores. @throws whatever kept the engine from answering.
Deviation median_answer(const Suite& suite, const NamedScene& scene, const EngineSeries& series, double dt) {
  std::vector<Deviation> list(static_cast<std::size_t>(suite.draws.runs));
  std::vector<std::size_t> draws(list.size());
  std::iota(draws.begin(), draws.end(), 0);
  const auto compute = [&](std::size_t draw) {
    list[draw] = answer_once(suite, scene, series, dt, static_cast<int>(draw));
    return std::string();
  };
  const auto nothing = [](std::size_t /*draw*/, const std::string& /*text*/) {};
  make_threads(std::max(1U, std::thread::hardware_concurrency()))->run(draws, {compute, nothing, [] {
                                                                                 return false;
                                                                               }});
  std::sort(list.begin(), list.end(),
            [](const Deviation& one, const Deviation& other) { return one.steps < other.steps; });
  return list[(list.size() - 1) / 2];
}

}  // namespace

Deviation deviation_in_steps(const Scene& scene, const History& exact, const History& engine, double dt) {
  const double turn = std::max(largest_magnitude(exact.velocities), slowest_turn(scene, dt));
  const double angle = largest(difference(exact, engine));
  const Deviation angles{angle / (turn * dt), angle};
  const auto slips = slip_difference(exact, engine);
  if (!slips) return angles;
  const double speed = std::max(largest_slip_speed(exact, dt), scene.gravity * dt);
  const Deviation slip{slips->largest / (speed * dt), slips->largest};
  return slip.steps > angles.steps ? slip : angles;
}

std::string canon_verdict(const Deviation& coarse, const Deviation& fine) {
  if (fine.steps <= canon_agreement) return "agrees";
  return fine.amount <= 0.5 * coarse.amount ? "converges" : "another law";
}

CanonRow make_canon_row(const Suite& suite, const WorkerEngine& engine, const std::string& settings,
                        const std::function<void(const CanonAnswer&)>& done) {
  const EngineSeries series = make_series(engine, settings, {});
  CanonRow row{&engine, settings, {}};
  for (const NamedScene& scene : suite.scenes) {
    CanonAnswer answer{scene.name, {}, {}, "no run", ""};
    try {
      answer.coarse = median_answer(suite, scene, series, canon_steps().coarse);
      answer.fine = median_answer(suite, scene, series, canon_steps().fine);
      answer.verdict = canon_verdict(answer.coarse, answer.fine);
    } catch (const std::exception& error) {
      answer.reason = error.what();
    }
    done(answer);
    row.answers.push_back(std::move(answer));
  }
  return row;
}

std::string canon_json(const Suite& suite, const std::vector<CanonRow>& rows, const std::string& command) {
  using Json = nlohmann::ordered_json;
  Json json{{"title", suite.title},
            {"command", command},
            {"steps", {{"coarse", canon_steps().coarse}, {"fine", canon_steps().fine}}},
            {"agreement", canon_agreement},
            {"draws", suite.draws.runs},
            {"scenes", Json::array()},
            {"rows", Json::array()}};
  for (const NamedScene& scene : suite.scenes)
    json["scenes"].push_back(
        {{"name", scene.name}, {"title", scene.scene.title}, {"scene_file", scene.text}});
  std::vector<const WorkerEngine*> engines;
  engines.reserve(rows.size());
  for (const CanonRow& row : rows) {
    engines.push_back(row.engine);
    Json answers = Json::array();
    for (const CanonAnswer& answer : row.answers) {
      const bool ran = answer.verdict != "no run";
      answers.push_back({{"scene", answer.scene},
                         {"verdict", answer.verdict},
                         {"steps_off_coarse", ran ? Json(answer.coarse.steps) : Json()},
                         {"steps_off_fine", ran ? Json(answer.fine.steps) : Json()},
                         {"reason", answer.reason}});
    }
    json["rows"].push_back({{"engine", row.engine->name()},
                            {"solver", row.engine->solver()},
                            {"version", row.engine->version()},
                            {"settings", row.settings},
                            {"answers", std::move(answers)}});
  }
  json["environment"] = environment(engines);
  return json.dump(2) + "\n";
}

std::string canon_csv(const std::vector<CanonRow>& rows) {
  CsvWriter csv;
  csv.line("engine", "solver", "settings", "scene", "verdict", "steps_off_coarse", "steps_off_fine",
           "reason");
  for (const CanonRow& row : rows) {
    for (const CanonAnswer& answer : row.answers)
      csv.line(row.engine->name(), row.engine->solver(), row.settings, answer.scene, answer.verdict,
               answer.coarse.steps, answer.fine.steps, answer.reason);
  }
  return csv.text();
}

}  // namespace rockstack
