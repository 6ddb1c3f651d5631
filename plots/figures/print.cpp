#include "comparisons/measures/results/long_table.hpp"
#include "comparisons/measures/results/print_style.hpp"
#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

constexpr auto folder_for_print = "paper";

/// @throws InputError where the font is known not to be there: another one would be taken.
void require_font(const std::string& font) {
  if (!has_program("fc-list")) return;
  const std::string ask = fmt::format("fc-list {} family | grep -q .", quoted_for_shell(font));
  if (std::system(ask.c_str()) != 0)
    throw InputError(fmt::format("font = \"{}\": must be a family that is installed, from `fc-list : family`",
                                 one_line(font)));
}

void add(const Printed& printed, const fs::path& stem, PrintedFigures& all) {
  draw(printed.drawing, stem);
  all.stems.push_back(stem);
  all.left_out.insert(all.left_out.end(), printed.left_out.begin(), printed.left_out.end());
}

PrintedFigures print_motions(const fs::path& results, const Comparison& comparison, const PrintStyle& style) {
  PrintedFigures all;
  for (const ComparedScene& scene : comparison.scenes)
    for (const Figure& figure : figures())
      if (const auto* of = std::get_if<PrintFigure>(&figure.of); of != nullptr && of->needs(scene))
        add(of->draw({figure, comparison, scene, style}),
            results / folder_for_print / figure_stem("", scene, figure).filename(), all);
  if (all.stems.empty())
    throw InputError(results.string() + ": has no histories: must be results that have some to be printed");
  return all;
}

/// What only panels over time can do.
void refuse_panels(const PrintStyle& style, const std::string& there) {
  const std::string given = !style.panels.empty()                       ? "panels"
                            : style.from > 0                            ? "from"
                            : style.to < HUGE_VAL                       ? "to"
                            : style.unit != PrintStyle::Unit::automatic ? "unit"
                                                                        : "";
  if (!given.empty())
    throw InputError(fmt::format("{}: must be left out: it is of motions, and here is {}", given, there));
}

PrintedFigures print_study(const fs::path& results, const PrintStyle& style) {
  PrintedFigures all;
  std::vector<std::string> can;
  for (const Figure& figure : figures()) {
    const auto* of = std::get_if<FolderFigure>(&figure.of);
    if (of == nullptr || !of->narrow) continue;
    can.push_back(figure.name);
    if (!fs::exists(table_file(results / of->needs))) continue;
    refuse_panels(style, "the figure " + figure.name);
    for (const auto& [part, drawing] : of->draw({figure, results, print_width(style), &style}))
      add({drawing}, results / folder_for_print / (part.empty() ? figure.name : figure.name + "." + part),
          all);
  }
  if (all.stems.empty())
    throw InputError(
        fmt::format("{}: has no figure for print: must be results with motions, or with one of {}",
                    results.string(), fmt::join(can, ", ")));
  return all;
}

}  // namespace

PrintedFigures print_figures(const fs::path& results, const PrintStyle& style) {
  require_font(style.font);
  if (fs::exists(results / "summary.json") && fs::exists(results / "history.csv"))
    return print_motions(results, read_motion(results).comparison, style);
  if (fs::exists(results / "comparison.json") && !fs::exists(results / "stability.json"))
    return print_motions(results, read_comparison(results), style);
  return print_study(results, style);
}

PrintedFigures print_figures(const fs::path& results, const Comparison& comparison) {
  if (!comparison.print) return {};
  require_font(comparison.print->font);
  return print_motions(results, comparison, *comparison.print);
}

}  // namespace rockstack::plots
