#include "plots/pages/front.hpp"

#include "comparisons/measures/results/build.hpp"
#include "comparisons/measures/results/files.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_solver.hpp"
#include "plots/pages/player_data.hpp"

namespace rockstack::plots {
namespace {

/// Names as their projects write them.
std::string written_name(const std::string& engine) {
  static const std::map<std::string, std::string> names{
      {"bullet", "Bullet"}, {"mujoco", "MuJoCo"}, {"ode", "ODE"}, {"planck", "Planck"}};
  const auto known = names.find(engine);
  return known == names.end() ? engine : known->second;
}

Json run_json(const FrontRun& run) {
  constexpr std::size_t most = 1000;
  return run.failure.empty()
             ? player_track(run.history, stride_for(run.history.size(), most), {"", "", "solid"})
             : Json{{"failure", run.failure}};
}

Json data_of(const FrontPage& page) {
  Json data = stage_of(page.scene, page.exact);
  data["scene"] = parse_json(page.text, "the scene of a page ");
  data["exact"] = player_track(with_events(page.exact), 1, {"", "", "solid", true, true});
  data["duration"] = page.scene.duration;
  data["steps"] = page.steps;
  data["tolerance"] = page.tolerance;
  data["engines"] = mapped(page.engines, [](const FrontEngine& engine) {
    return Json{{"name", engine.name},
                {"written", written_name(engine.name)},
                {"parameters", engine.parameters},
                {"runs", mapped(engine.runs, run_json)}};
  });
  return data;
}

/// What is shown, for those who ask.
std::string front_facts(const FrontPage& page) {
  Facts facts{{"scene", page.scene.title},
              {"exact", fmt::format("rockstack {}, law {}", build::version, name(page.scene.law))}};
  for (const FrontEngine& engine : page.engines)
    facts.emplace_back(written_name(engine.name),
                       fmt::format("{}, its {} settings", engine.version, engine.settings));
  facts.emplace_back("this page", page.command);
  return definition_list(facts);
}

/// Why no impact of a law stops the picture; empty where impacts do.
std::string no_blows(Law law) {
  if (law == Law::unilateral)
    return " Under law unilateral blocks slide and fly as they land, and angles alone do not tell their centres' velocities: "
           "there are no such arrows here.";
  if (law == Law::compliant)
    return " On springs a landing takes its time and no velocity turns at once: there are no such arrows here.";
  return "";
}

}  // namespace

void write_front(const fs::path& file, const FrontPage& page) {
  const bool shaken = !page.scene.horizontal.empty() || !page.scene.vertical.empty();
  const bool solves = !solver_wasm.empty();
  const std::string content =
      filled_in(front_html,
                {{"begins", shaken ? "The ground moves under a stack of blocks."
                                   : "A stack of blocks is tilted and let go."},
                 {"hides", solves ? " hidden" : ""},
                 {"why", solves ? "this browser has no WebAssembly" : "it was made without the solver in it"},
                 {"no_blows", no_blows(page.scene.law)},
                 {"facts", front_facts(page)},
                 {"data", for_script(data_of(page))}});
  write_file(
      file,
      filled_in(page_html,
                {{"title", "How long do physics engines agree with the exact motion?"},
                 {"kind", "page"},
                 {"shared", ""},
                 {"css", std::string(page_css) + std::string(player_css) + std::string(front_css)},
                 {"content", content},
                 {"words", ""},
                 {"js", std::string(stack_js) + std::string(charts_js) + std::string(front_js)},
                 {"player_js", ""},
                 {"solver", solves ? solving_scripts({solver_js, engine_js, drag_js, share_js}) : ""}}));
}

}  // namespace rockstack::plots
