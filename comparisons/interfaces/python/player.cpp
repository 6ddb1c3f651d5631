#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "comparisons/interfaces/python/convert.hpp"

#ifdef ROCKSTACK_WITH_PLOTS
#include <tuple>

#include "comparisons/measures/results/print_style.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/player_data.hpp"

namespace rockstack::python {
namespace {

/// A motion, its name, and whether it is exact.
using Shown = std::tuple<std::shared_ptr<HeldMotion>, std::string, bool>;

Json track_of(const Shown& shown, const std::string& colour) {
  constexpr std::size_t most_samples = 2000;
  const auto& [motion, label, exact] = shown;
  const Scene& scene = motion->scene->scene;
  const History& history = motion->history;
  const std::size_t stride = plots::stride_for(history.size(), most_samples);
  auto track = plots::player_track(exact ? plots::with_events(history) : history, stride,
                                   {label, colour, exact ? "solid" : "(8,3)", true, exact});
  const double chatter = chatter_speed(scene);
  track["impacts"] = Json::array();
  for (const ImpactTime& impact :
       exact ? reported_impacts(scene, history, chatter) : observed_impacts(scene, history, chatter))
    track["impacts"].push_back(impact.time);
  if (exact && history.patterns.size() == history.size()) plots::add_forces(scene, history, stride, track);
  return track;
}

/// A page with nothing but the player of some motions, those of the first one's scene.
std::string player(const std::vector<Shown>& motions) {
  static constexpr std::array colours{"#1a1a1a", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"};
  const HeldMotion& first = *std::get<0>(motions.front());
  History samples;
  samples.times = first.history.times;
  auto data = plots::stage_of(first.scene->scene, std::get<2>(motions.front()) ? first.history : samples);
  data["tracks"] = Json::array();
  for (const Shown& shown : motions)
    data["tracks"].push_back(track_of(shown, colours[data["tracks"].size() % colours.size()]));
  const std::string& title = first.scene->scene.title;
  return plots::page(
      title, "player",
      filled_in(plots::player_html,
                {{"id", "player"}, {"title", plots::escaped(title)}, {"data", plots::for_script(data)}}));
}

/// Without ending the files that were drawn for print, and what was left out.
std::pair<std::vector<std::filesystem::path>, std::vector<std::string>> draw_for_print(
    const std::filesystem::path& results, const py::dict& style) {
  const PrintStyle asked = read_print_style(read_document(style, "draw"));
  plots::PrintedFigures printed;
  beside_interpreter([&](const std::function<bool()>&) { printed = plots::print_figures(results, asked); });
  return {printed.stems, printed.left_out};
}

}  // namespace

void add_player(py::module_& core) {
  core.def("player", &player);
  core.def("draw", &draw_for_print);
}

}  // namespace rockstack::python
#else
void rockstack::python::add_player(py::module_& core) {
  core.attr("player") = core.attr("draw") = py::none();
}
#endif
