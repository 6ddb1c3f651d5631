#include "comparisons/measures/results/csv.hpp"
#include "plots/pages/sections.hpp"
#include "plots/pages/show.hpp"

namespace rockstack::plots {
namespace {

using Values = std::map<std::string, std::string>;

/// As many digits as tell a column's numbers apart, four at least: times of chatter need more than others.
int digits_of(const Json& rows, std::size_t column) {
  std::set<std::string> numbers;
  for (const Json& row : rows)
    if (const std::string cell = row.at(column).get<std::string>(); number_in(cell)) numbers.insert(cell);
  constexpr int fewest = 4, most = 9;
  for (int significant = fewest; significant < most; ++significant) {
    std::set<std::string> shown;
    for (const std::string& number : numbers)
      shown.insert(fmt::format("{:.{}g}", *number_in(number), significant));
    if (shown.size() == numbers.size()) return significant;
  }
  return most;
}

std::string lesson_table(const Json& json) {
  const auto columns = json.at("columns").get<std::vector<std::string>>();
  std::vector<int> significant;
  for (std::size_t i = 0; i < columns.size(); ++i) significant.push_back(digits_of(json.at("rows"), i));
  return table(columns, joined_texts(json.at("rows"), [&](const Json& row) {
                 std::string cells;
                 for (std::size_t i = 0; i < columns.size(); ++i)
                   cells += table_cell(columns[i], row.at(i), "", significant[i]);
                 return element("tr", cells) + "\n";
               }));
}

std::string choices_of(const Json& part, const std::string& name) {
  int place = 0;
  return joined_texts(part.at("choices"), [&](const Json& choice) {
    return fmt::format(
        "<label class=\"choice\"><input type=\"radio\" name=\"predict-{}\" value=\"{}\"> {}</label>\n", name,
        place++, choice.get<std::string>());
  });
}

std::string number_field(const Json& part, const std::string& name) {
  const std::string unit = escaped_at(part, "unit");
  return fmt::format(
      "<label>Your answer{}{}: <input type=\"text\" aria-describedby=\"ask-{}\" inputmode=\"decimal\" "
      "autocomplete=\"off\"></label>\n",
      unit.empty() ? "" : ", ", unit, name);
}

/// A question that is answered before the text goes on: `question` is as comparisons write it, `numbers` are
/// the lesson's. Its answer is told once a choice or a number has been committed to.
std::string prediction_section(const Json& question, Values numbers) {
  const std::string name = escaped_at(question, "name"), text = text_at(question, "text");
  const Json& part = question.at("parts").at(0);
  const std::string shown = text_at(part, "shown");
  numbers["answer"] = shown;
  const bool chosen = part.contains("right");
  return fmt::format(
      "<form class=\"predict\" data-name=\"{0}\" data-right=\"{1}\" data-value=\"{2}\" data-within=\"{3}\">\n"
      "<fieldset aria-labelledby=\"predict-{0} ask-{0}\"><legend id=\"predict-{0}\">Predict</legend>\n"
      "{4}<p class=\"ask\" id=\"ask-{0}\">{5}</p>\n{6}<p class=\"complaint\" role=\"alert\"></p>\n"
      "<button type=\"submit\">Commit</button> "
      "<button type=\"button\" class=\"skip\">Read on without</button></fieldset>\n"
      "<div class=\"revealed\" role=\"status\" tabindex=\"-1\"><p class=\"verdict\"></p>\n"
      "<p><strong>{7}</strong>{8} {9}</p></div>\n</form>",
      name, chosen ? part.at("right").dump() : "", part.at("value").dump(), part.at("within").dump(),
      text.empty() ? "" : element("p", text, " class=\"given\"") + "\n", text_at(part, "ask"),
      chosen ? choices_of(part, name) : number_field(part, name), shown, chosen ? "." : "",
      filled_in(text_at(part, "why"), numbers));
}

/// Names with a colon are parts of a page, others numbers. The figures of the text are drawn anew for slides.
void add_parts(const fs::path& results, const Comparison& comparison, const Json& lesson, bool on_slides,
               Values& values) {
  const std::string text = text_at(lesson, "text");
  const Json start = lesson.value("player", Json());
  for (std::size_t i = 0; i < comparison.scenes.size(); ++i) {
    const ComparedScene& scene = comparison.scenes[i];
    if (has_motion(comparison, scene)) values["player:" + scene.name] = player_section(comparison, i, start);
    for (const Figure* figure : figures_of(scene)) {
      const std::string place = fmt::format("figure:{}.{}", scene.name, figure->name);
      if (!on_slides) {
        values[place] = scene_figure(results, comparison, i, *figure);
      } else if (text.find("{{" + place + "}}") != std::string::npos) {
        const fs::path stem = fs::path("slides") / figure_stem("", scene, *figure).filename();
        draw(std::get<SceneFigure>(figure->of).draw({{*figure}, comparison, scene, true}),
             results / "figures" / stem);
        values[place] = drawn_figure(results, stem, figure->name + "-", figure->title + ": " + scene.title);
      }
    }
  }
}

Values values_of(const fs::path& results, const Comparison& comparison, const Json& lesson, bool on_slides) {
  Values values;
  for (const auto& [name, value] : lesson.at("numbers").items())
    values[name] = escaped(value.get<std::string>());
  const Values numbers = values;
  for (const auto& [name, value] : lesson.at("tables").items()) values["table:" + name] = lesson_table(value);
  for (const Json& question : lesson.at("predictions"))
    values["predict:" + text_at(question, "name")] = prediction_section(question, numbers);
  add_parts(results, comparison, lesson, on_slides, values);
  return values;
}

std::string list_of(const Json& texts) {
  const auto item = [](const Json& text) { return element("li", text.get<std::string>()) + "\n"; };
  return element("ul", joined_texts(texts, item));
}

/// To what the words mean, and to the course and the lessons beside this one, where they are.
std::string navigation(const Json& lesson) {
  std::string links = link("report.html#words", "What the words mean");
  if (lesson.contains("neighbours")) {
    links =
        link("../index.html", "All lessons") + " " + link("../glossary.html", "What the words mean") + " ";
    for (const auto& [key, words] : {std::pair{"previous", "◀ the one before"}, {"next", "the next one ▶"}})
      if (const std::string name = escaped_at(lesson.at("neighbours"), key); !name.empty())
        links += link("../" + name + "/lesson.html", words) + " ";
  }
  return element("nav", links, " class=\"bar\" aria-label=\"Course\"");
}

std::string titles_after(const Json& lesson) {
  const auto title = [&](const Json& one) {
    const std::string words = "“" + escaped_at(one, "title") + "”";
    return lesson.contains("neighbours") ? link("../" + escaped_at(one, "name") + "/lesson.html", words)
                                         : words;
  };
  const Json& before = lesson.at("after");
  return before.empty() ? "" : " · after " + joined_texts(before, title, ", ");
}

/// A lesson's page, or its slides, which are made of the same text in the browser.
std::string page_of(const fs::path& results, const Comparison& comparison, const Json& lesson,
                    bool on_slides) {
  Values values{
      {"after", titles_after(lesson)},
      {"navigation", navigation(lesson)},
      {"text", filled_in(text_at(lesson, "text"), values_of(results, comparison, lesson, on_slides))},
      {"command", escaped(comparison.command)},
      {"environment", definition_list(comparison.environment)},
      {"css", std::string(slides_css)},
      {"script", std::string(on_slides ? slides_js : lesson_js)}};
  for (const char* key : {"title", "name"}) values[key] = escaped_at(lesson, key);
  for (const char* key : {"number", "count", "minutes"}) values[key] = lesson.at(key).dump();
  for (const char* key : {"aims", "references"}) values[key] = list_of(lesson.at(key));
  return page(text_at(lesson, "title"), on_slides ? "slides" : "lesson",
              filled_in(on_slides ? slides_html : lesson_html, values), shared_solver(results));
}

}  // namespace

void write_lesson(const fs::path& results, const Comparison& comparison) {
  read_json(results / "lesson.json", [&](const Json& lesson) {
    const std::string page = page_of(results, comparison, lesson, false);
    const std::string slides = page_of(results, comparison, lesson, true);
    write_file(results / "lesson.html", page);
    write_file(results / "slides.html", slides);
  });
}

}  // namespace rockstack::plots
