#include "plots/pages/html.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/results/csv.hpp"
#include "plots/pages/page_solver.hpp"
#include "plots/pages/player_data.hpp"
#include "plots/pages/show.hpp"

namespace rockstack::plots {
namespace {

/// Sentences, each in an element and a line of its own.
std::string elements(const std::string& name, const std::vector<std::string>& sentences) {
  return joined_texts(sentences,
                      [&](const std::string& sentence) { return element(name, escaped(sentence)) + "\n"; });
}

std::string class_attribute(const std::string& classes) {
  return classes.empty() ? "" : fmt::format(" class=\"{}\"", classes);
}

constexpr auto shared_name = "solver.js";

using Packages = std::vector<std::pair<const char*, std::string_view>>;

/// What a page solves with, by its id; nothing in a build without it.
Packages packages() {
  Packages list{{"solver", solver_wasm}, {"engine", engine_package}};
  std::erase_if(list, [](const auto& package) { return package.second.empty(); });
  return list;
}

/// A script that puts packages into the page which loads it.
std::string shared_script() {
  std::string list;
  for (const auto& [id, package] : packages()) list += fmt::format("[\"{}\", \"{}\"],\n", id, package);
  return "for (const [id, textContent] of [" + list +
         "]) document.body.append(Object.assign(document.createElement(\"script\"), "
         "{ type: \"application/gzip\", id, textContent }));\n";
}

constexpr auto curves_of_figure = " type=\"application/json\" class=\"curves\"";

/// The panels of a table of curves, as charts read them; without curves that turn back.
Json panels_of(const fs::path& table) {
  Json panels = Json::array();
  DrawnCurve curve;
  const auto end_curve = [&] {
    const bool is_chart = curve.curve.size() > 0 && std::ranges::is_sorted(curve.curve.times);
    if (is_chart)
      panels.back()["curves"].push_back({{"label", curve.words},
                                         {"colour", curve.colour},
                                         {"x", packed(curve.curve.times, 1, 1)},
                                         {"y", packed(curve.curve.values, 1, 1)}});
    curve.curve = {};
  };
  CsvLine line(table);
  while (line.next()) {
    const bool fresh = panels.empty() || panels.back()["up"] != line.text("panel");
    if (fresh || curve.words != line.text("curve")) end_curve();
    if (fresh)
      panels.push_back({{"up", line.text("panel")},
                        {"across", line.text("across")},
                        {"logarithmic", line.text("scale") == "logarithmic"},
                        {"curves", Json::array()}});
    curve.words = line.text("curve"), curve.colour = "#" + line.text("colour");
    curve.curve.add(line.value("x"), line.value("y"));
  }
  end_curve();
  std::erase_if(panels.get_ref<Json::array_t&>(), [](const Json& panel) { return panel["curves"].empty(); });
  return panels;
}

/// The curves of a figure that has a table of them, for charts; nothing in a build without these.
std::string curves_script(const fs::path& table) {
  const Json panels = uplot_js.empty() || !fs::exists(table) ? Json() : panels_of(table);
  return panels.empty() ? "" : element("script", for_script(panels), curves_of_figure);
}

/// What draws the charts of a page that has some.
std::string chart_scripts(const std::string& content) {
  if (content.find(curves_of_figure) == std::string::npos) return "";
  return element("style", std::string(uplot_css)) + element("script", std::string(uplot_js)) + "\n" +
         element("script", "\n" + std::string(curves_js)) + "\n";
}

/// Whether a page's players and pictures solve, or sliders have to say that nothing does.
bool solves(const std::string& content) {
  const auto has = [&](const char* part) { return content.find(part) != std::string::npos; };
  return solver_wasm.empty() ? has("class=\"try\"") : has("\"scene\":{") || has("class=\"moving\"");
}

}  // namespace

std::set<std::string> names_in(const fs::path& folder, const std::set<std::string>& endings) {
  std::set<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (endings.contains(entry.path().extension())) names.insert(entry.path().filename());
  return names;
}

std::string escaped(std::string_view text) {
  std::string result(text);
  for (const auto& [mark, entity] :
       {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}, {"'", "&#39;"}})
    boost::replace_all(result, mark, entity);
  return result;
}

std::string inline_svg(const std::string& file, const std::string& prefix, const std::string& label) {
  const std::size_t start = std::min(file.find("<svg"), file.size());
  std::string svg = file.substr(start);
  for (const std::string name : {"title", "desc"}) {  // which browsers would show as tooltips
    const std::string closing = "</" + name + ">";
    const std::size_t begin = svg.find("<" + name + ">");
    const std::size_t end = svg.find(closing, std::min(begin, svg.size()));
    if (end != std::string::npos) svg.erase(begin, end + closing.size() - begin);
  }
  for (const char* mark : {"id=\"", "id='", "href='#", "href=\"#", "url(#"})
    boost::replace_all(svg, mark, mark + prefix);
  constexpr std::size_t tag_length = 4;
  if (svg.size() > tag_length)
    svg.insert(tag_length, fmt::format(" role=\"img\" aria-label=\"{}\"", escaped(label)));
  return svg;
}

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  boost::split(parts, text, [](char letter) { return letter == ';'; });
  return parts;
}

std::string page(const std::string& title, const std::string& kind, const std::string& content,
                 const std::string& solver) {
  const auto scripts = {solver_js, engine_js, charts_js, drag_js, share_js, try_js};
  return filled_in(
      page_html,
      {{"title", escaped(title)},
       {"shared", solver.empty() ? "" : "'self' file: "},
       {"kind", kind},
       {"css", std::string(page_css) + std::string(player_css) + std::string(lesson_css)},
       {"js", std::string(page_js)},
       {"player_js", player_scripts()},
       {"solver", (solves(content) ? solving_scripts(scripts, solver) : "") + chart_scripts(content)},
       {"content", content},
       {"words", kind == "report"
                     ? details("What the words mean", std::string(glossary_html), " id=\"words\"")
                     : ""}});
}

void share_solver(const fs::path& course) {
  if (!solver_wasm.empty()) write_file(course / shared_name, shared_script());
}

std::string shared_solver(const fs::path& folder) {
  const std::string up = fs::exists(folder / "lesson.json") ? "../" : "";
  const fs::path file = folder / (up + shared_name);
  return fs::exists(file) && file_text(file, largest_results) == shared_script() ? up + shared_name : "";
}

std::string solving_scripts(std::initializer_list<std::string_view> list, const std::string& shared) {
  std::string scripts;
  if (!shared.empty()) scripts = element("script", "", fmt::format(" src=\"{}\"", shared)) + "\n";
  for (const auto& [id, package] : shared.empty() ? packages() : Packages())
    scripts +=
        element("script", std::string(package), fmt::format(" type=\"application/gzip\" id=\"{}\"", id)) +
        "\n";
  for (const std::string_view script : list) scripts += element("script", "\n" + std::string(script)) + "\n";
  return scripts;
}

std::string answer_box(const std::vector<std::string>& sentences) {
  return sentences.empty() ? "" : element("div", elements("p", sentences), " class=\"answer\"");
}

std::string sentence_list(const std::vector<std::string>& sentences) {
  return element("ul", elements("li", sentences)) + "\n";
}

std::string table(const std::vector<std::string>& columns, const std::string& rows) {
  const std::string headings = joined_texts(columns, [](const std::string& name) { return heading(name); });
  return element("table", element("thead", element("tr", headings)) + element("tbody", "\n" + rows));
}

std::string table_row(const std::vector<std::string>& columns, const std::vector<std::string>& cells,
                      const std::string& attributes) {
  std::string row;
  for (std::size_t i = 0; i < columns.size(); ++i) row += table_cell(columns[i], cells[i]);
  return element("tr", row, attributes) + "\n";
}

std::string definition_list(const Facts& facts) {
  return element("dl", joined_texts(facts, [](const auto& fact) {
                   return element("dt", escaped(fact.first)) + element("dd", escaped(fact.second)) + "\n";
                 }));
}

std::string table_cell(const std::string& column, const std::string& cell, const std::string& kind,
                       int significant) {
  const bool is_count = cell.find_first_not_of("0123456789") == std::string::npos;
  if (const std::optional<double> value = number_in(cell))
    return element("td", is_count ? cell : with_power(fmt::format("{:.{}g}", *value, significant)),
                   fmt::format(" class=\"number{1}{2}\" data-value=\"{0}\" title=\"{0}\"", escaped(cell),
                               kind.empty() ? "" : " ", kind));
  const std::string classes = column == "reason" && !cell.empty() ? "reason " + kind : kind;
  return element("td", escaped(cell), class_attribute(classes));
}

std::string heading(std::string column, const std::string& kind) {
  std::ranges::replace(column, '_', ' ');
  const std::string words = column.empty() ? "" : element("button", escaped(column), " type=\"button\"");
  return element("th", words, " scope=\"col\"" + class_attribute(kind));
}

std::string drawn_figure(const fs::path& results, const std::string& stem, const std::string& prefix,
                         const std::string& label) {
  const Figure* figure = figure_in(stem);
  const std::string words = figure == nullptr ? "" : figure->question + " " + figure->explanation;
  const auto drawing = [&](const std::string& part, const std::string& before) {
    const fs::path file = results / "figures" / (stem + part + ".svg");
    return inline_svg(file_text(file), before + prefix, label);
  };
  const std::string narrow = std::string(".") + narrow_part;
  const std::string drawings = fs::exists(results / "figures" / (stem + narrow + ".svg"))
                                   ? element("div", drawing("", ""), class_attribute("wide")) +
                                         element("div", drawing(narrow, "n-"), class_attribute(narrow_part))
                                   : drawing("", "");
  const std::string curves = curves_script(results / "figures" / (stem + ".csv"));
  return element("figure", drawings + curves + element("figcaption", escaped(words)));
}

std::string drawn_figures(const fs::path& results, const std::set<std::string>& known) {
  std::string text;
  for (const std::string& name : names_in(results / "figures", {".svg"})) {
    const std::string stem = fs::path(name).stem();
    if (known.contains(stem) || stem.ends_with(narrow_part)) continue;
    std::string title = boost::replace_all_copy(boost::replace_all_copy(stem, ".", " "), "-", " ");
    if (const Figure* figure = figure_in(stem); figure != nullptr)
      title = figure->title + (stem == figure->name ? "" : ": " + stem.substr(figure->name.size() + 1));
    text += element("h3", escaped(title)) + drawn_figure(results, stem, escaped(stem) + "-", title) + "\n";
  }
  return text;
}

std::string scene_figure(const fs::path& results, const Comparison& comparison, std::size_t scene,
                         const Figure& figure) {
  const ComparedScene& compared = comparison.scenes[scene];
  return drawn_figure(results, figure_stem("", compared, figure).filename(),
                      fmt::format("s{}-{}-", scene + 1, figure.name),
                      fmt::format("{}: {}", figure.title, compared.title));
}

std::string file_links(const fs::path& results) {
  const auto to = [](const std::string& name) { return link(escaped(name), escaped(name)); };
  return joined_texts(names_in(results, {".csv", ".json", ".npz"}), to, ", ");
}

}  // namespace rockstack::plots
