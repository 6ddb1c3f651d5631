#include "plots/pages/pages.hpp"

#include <fmt/format.h>

#include "comparisons/measures/results/files.hpp"
#include "plots/data/results.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/templates.hpp"

namespace rockstack::plots {
namespace {

/// Room for an answer, or the answer.
std::string part_text(const Json& part, bool with_answer) {
  const auto unit = part.at("unit").get<std::string>();
  std::string choices;
  for (const Json& choice : part.at("choices"))
    choices += (choices.empty() ? " " : " / ") + choice.get<std::string>();
  const std::string answer = with_answer
                                 ? element("strong", part.at("shown").get<std::string>(), " class=\"key\"")
                                 : fmt::format("<span class=\"blank\"></span> {}", escaped(unit));
  return element("li", fmt::format("{}{} {}", part.at("ask").get<std::string>(), choices, answer)) + "\n";
}

std::string problem_text(const Json& problem, bool with_answers) {
  std::string parts;
  for (const Json& part : problem.at("parts")) parts += part_text(part, with_answers);
  return element("li", element("p", problem.at("text").get<std::string>()) +
                           element("ol", "\n" + parts, " class=\"parts\"") +
                           (with_answers ? "" : "<div class=\"work\"></div>")) +
         "\n";
}

std::string sheet_page(const Json& sheet, bool with_answers) {
  std::string problems;
  for (const Json& problem : sheet.at("problems")) problems += problem_text(problem, with_answers);
  const auto lesson = sheet.at("lesson").get<std::string>(), title = sheet.at("title").get<std::string>();
  const std::string seed = sheet.at("seed").dump(), kind = with_answers ? "Key" : "Problem sheet";
  const char* name_line = "<p class=\"name\">Name: <span class=\"blank\"></span></p>";
  const std::string note =
      with_answers
          ? fmt::format(
                "Answers are computed by the exact solver and closed forms: "
                "<code>rockstack teach {} --sheet {} --out DIR</code>.",
                escaped(lesson), seed)
          : "Angles in rad, clockwise positive; gravity is 9.81 m/s². Give answers to the digits that your "
            "way of computing supports, and say what you assumed.";
  return page({fmt::format("{}: {} {}", title, kind, seed), "sheet",
               filled_in(sheet_html, {{"kind", kind},
                                      {"lesson", element("code", escaped(lesson))},
                                      {"seed", seed},
                                      {"title", escaped(title)},
                                      {"name_line", with_answers ? "" : name_line},
                                      {"problems", problems},
                                      {"note", note},
                                      {"css", std::string(sheet_css)}})});
}

}  // namespace

SheetPages write_sheet(const std::filesystem::path& answers) {
  return read_json(answers, [&](const Json& sheet) {
    const auto place = [&](const char* kind) {
      return answers.parent_path() / fmt::format("{}-{}-{}.html", sheet.at("lesson").get<std::string>(), kind,
                                                 sheet.at("seed").dump());
    };
    SheetPages pages{place("sheet"), place("key")};
    write_file(pages.sheet, sheet_page(sheet, false));
    write_file(pages.key, sheet_page(sheet, true));
    return pages;
  });
}

}  // namespace rockstack::plots
