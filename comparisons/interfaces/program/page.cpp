#include <fmt/format.h>

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/solve.hpp"
#include "comparisons/interfaces/program/commands.hpp"
#include "engines/scene_setup.hpp"
#ifdef ROCKSTACK_WITH_PLOTS
#include "plots/pages/front.hpp"
#endif

namespace rockstack {
namespace {

struct PageArguments {
  std::string scene = "spanos-free-rocking";
  std::filesystem::path out;
  std::string settings = "tuned";
};

#ifdef ROCKSTACK_WITH_PLOTS
/// Time steps to choose from, s.
const std::vector<double> page_steps{0.02, 1.0 / 60, 0.01, 0.005, 0.002, 0.001};

/// Those of Bullet, ODE and Planck that there are, with their first solvers; a page can hold the last.
EngineList engines_of_page() {
  EngineList list;
  for (const char* name : {"bullet", "ode", "planck"})
    if (const EngineList solvers = engines_called(name); !solvers.empty()) list.push_back(solvers.front());
  return list;
}

plots::FrontRun front_run(const WorkerEngine& engine, const Scene& scene, double dt,
                          const Parameters& parameters) {
  try {
    EngineRun run = simulate(engine, scene, dt, parameters, {}, true);
    run.history.centres = std::move(run.bodies->centres);
    return {std::move(run.history), ""};
  } catch (const std::runtime_error& error) {
    return {{}, error.what()};
  }
}

plots::FrontEngine front_engine(const WorkerEngine& engine, const Scene& scene, const std::string& settings) {
  const EngineSeries series = make_series(engine, settings, page_steps);
  return {engine.name, engine.version, settings, with_restitution(engine, scene, series.parameters),
          mapped(page_steps, [&](double dt) { return front_run(engine, scene, dt, series.parameters); })};
}

/// The page that is asked for: a file, or page.html in a folder. @throws InputError where it would write over
/// what is no page.
std::filesystem::path page_file(const PageArguments& arguments) {
  std::filesystem::path out =
      arguments.out.empty() ? default_results("page", arguments.scene) : arguments.out;
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(out, ignored);
  if (out.extension() == ".html" && !folder) return out;
  if (!folder && std::filesystem::exists(out, ignored))
    throw InputError(
        fmt::format("--out {}: must be a folder, or a file whose name ends in .html", out.string()));
  return out / "page.html";
}

int run_page(const PageArguments& arguments, const Common& common) {
  const std::filesystem::path out = page_file(arguments);
  const NamedScene named = read_one_scene(arguments.scene, common);
  const Scene& scene = named.scene;
  for (const double dt : page_steps) check_step(dt, scene.duration);
  constexpr int samples = 1000;
  History exact = solve(scene, {.sample_times = regular_times(scene.duration / samples, scene.duration)});
  const auto engines = mapped(engines_of_page(), [&](const WorkerEngine& one) {
    return front_engine(one, scene, arguments.settings);
  });
  if (out.has_parent_path()) std::filesystem::create_directories(out.parent_path());
  plots::write_front(
      out, {scene, page_text(named.document, scene), common.command, std::move(exact), page_steps, engines});
  if (print_json({{"page", out.string()}}, common)) fmt::print("page: {}\n", one_line(out.string()));
  return 0;
}
#else
int run_page(const PageArguments& /*arguments*/, const Common& /*common*/) {
  throw InputError("page: must be asked of a build with ROCKSTACK_PLOTS=ON");
}
#endif

void add_page(CLI::App& command, PageArguments& arguments) {
  command.add_option("scene", arguments.scene, scene_help)->capture_default_str();
  command.add_option("--out", arguments.out,
                     fmt::format("folder for page.html, or the page's file; left out: {}",
                                 default_results("page", "SCENE").string()));
  command.add_option("--settings", arguments.settings, "their parameter set")
      ->check(one_of({"default", "tuned"}))
      ->capture_default_str();
}

}  // namespace

Command page_command() {
  return make_command("page", "write one page in which a stack is dragged, the exact motion beside engines",
                      add_page, run_page);
}

}  // namespace rockstack
