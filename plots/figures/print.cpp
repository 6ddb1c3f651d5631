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

/// A figure that a folder has, and what draws it.
struct FigureInPrint {
  const Figure* figure;
  std::string stem;
  std::function<Drawings()> draw;
};

using FiguresInPrint = std::vector<FigureInPrint>;

void add_comparison(FiguresInPrint& list, const Comparison& comparison, const PrintStyle& style) {
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<ComparisonFigure>(&figure.of); of != nullptr)
      list.push_back({&figure, figure.name, [&, of] { return of->draw({{figure, &style}, comparison}); }});
  for (const ComparedScene& scene : comparison.scenes)
    for (const Figure* figure : figures_of(scene, true))
      list.push_back(
          {figure, figure_stem("", scene, *figure).filename().string(), [&, figure] {
             return Drawings{
                 {"", std::get<SceneFigure>(figure->of).draw({{*figure, &style}, comparison, scene})}};
           }});
}

void add_folder(FiguresInPrint& list, const fs::path& results, const PrintStyle& style) {
  for (const Figure& figure : figures())
    if (const auto* of = std::get_if<FolderFigure>(&figure.of);
        of != nullptr && fs::exists(table_file(results / of->needs)))
      list.push_back({&figure, figure.name, [&, of] {
                        return of->draw({{figure, &style}, results, print_width(style)});
                      }});
}

std::string names_of(const FiguresInPrint& list) {
  std::set<std::string> names;
  for (const FigureInPrint& one : list) names.insert(one.figure->name);
  return joined_texts(std::vector(names.begin(), names.end()), std::identity(), ", ");
}

/// Leaves those that a style names. @throws InputError where there is none of a name.
void choose_named(FiguresInPrint& list, const PrintStyle& style, const fs::path& results) {
  for (const std::string& name : style.figures)
    if (std::ranges::none_of(list, [&](const FigureInPrint& one) { return one.figure->name == name; }))
      throw InputError(fmt::format("figures = \"{}\": must be among {}, which {} has", one_line(name),
                                   names_of(list), results.string()));
  if (!style.figures.empty())
    std::erase_if(list, [&](const FigureInPrint& one) {
      return std::ranges::find(style.figures, one.figure->name) == style.figures.end();
    });
}

/// What a style asks that only some figures can do.
std::vector<std::pair<std::string, Trait>> asked_traits(const PrintStyle& style) {
  std::vector<std::pair<std::string, Trait>> asked;
  if (!style.panels.empty()) asked.emplace_back("panels", of_panels);
  if (style.from > 0) asked.emplace_back("from", over_time);
  if (style.to < HUGE_VAL) asked.emplace_back("to", over_time);
  if (style.unit != PrintStyle::Unit::automatic) asked.emplace_back("unit", in_angles);
  return asked;
}

/// Leaves those for which all that a style asks has a meaning. @throws InputError where there are none, or
/// where one of those that it names is not among them.
void choose_able(FiguresInPrint& list, const PrintStyle& style) {
  for (const auto& [key, trait] : asked_traits(style)) {
    const auto has = [trait = trait](const FigureInPrint& one) { return one.figure->has(trait); };
    FiguresInPrint able = list;
    std::erase_if(able, std::not_fn(has));
    if (able.empty() || (!style.figures.empty() && able.size() < list.size())) {
      std::erase_if(list, has);
      throw InputError(fmt::format("{}: must be left out: it has no meaning for {}{}", key, names_of(list),
                                   able.empty() ? "" : ", but for " + names_of(able)));
    }
    list = std::move(able);
  }
}

PrintedFigures draw_chosen(FiguresInPrint list, const fs::path& results, const PrintStyle& style) {
  if (list.empty())
    throw InputError(results.string() + ": has no figures: must be a folder with results that have some");
  choose_named(list, style, results);
  choose_able(list, style);
  PrintedFigures all;
  for (const FigureInPrint& one : list)
    for (const auto& [part, drawing] : one.draw()) {
      const std::string stem = part.empty() ? one.stem : one.stem + "." + part;
      for (const std::string& reason : drawing.left_out) all.left_out.push_back(reason);
      if (!drawing.nothing.empty()) {
        all.left_out.push_back(stem + ": " + drawing.nothing);
        continue;
      }
      all.stems.push_back(results / folder_for_print / stem);
      draw(drawing, all.stems.back());
    }
  if (all.stems.empty())
    throw InputError(fmt::format("{}: must have something that {} can show{}{}", results.string(),
                                 names_of(list), all.left_out.empty() ? "" : "; ",
                                 joined_texts(all.left_out, std::identity(), "; ")));
  return all;
}

PrintedFigures print_compared(const fs::path& results, const Comparison& comparison, const PrintStyle& style,
                              bool with_folder) {
  FiguresInPrint list;
  add_comparison(list, comparison, style);
  if (with_folder) add_folder(list, results, style);
  return draw_chosen(std::move(list), results, style);
}

}  // namespace

PrintedFigures print_figures(const fs::path& results, const PrintStyle& style) {
  require_font(style.font);
  if (fs::exists(results / "summary.json") && fs::exists(results / "history.csv"))
    return print_compared(results, read_motion(results).comparison, style, true);
  if (fs::exists(results / "comparison.json") && !fs::exists(results / "stability.json"))
    return print_compared(results, read_comparison(results), style, false);
  FiguresInPrint list;
  add_folder(list, results, style);
  return draw_chosen(std::move(list), results, style);
}

PrintedFigures print_figures(const fs::path& results, const Comparison& comparison) {
  if (!comparison.print) return {};
  require_font(comparison.print->font);
  return print_compared(results, comparison, *comparison.print, false);
}

}  // namespace rockstack::plots
