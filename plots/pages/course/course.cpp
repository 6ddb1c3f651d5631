#include <sys/wait.h>
#include <unistd.h>

#include "plots/pages/html.hpp"
#include "plots/pages/show.hpp"

// The list of all lessons, problem sheets, and slides on paper.

namespace rockstack::plots {
namespace {

/// The player that pictures which move are copies of.
std::string hidden_player() {
  return element("div", filled_in(player_html, {{"id", "player"}, {"title", "a word"}, {"data", "null"}}),
                 " hidden");
}

/// The first scene of a lesson as a picture that moves, at once or when asked to; nothing where its folder is
/// not beside the page.
std::string picture_of(const fs::path& lesson, bool at_once) {
  const fs::path file = lesson / "comparison.json";
  const std::string scene = fs::exists(file) ? read_json(file).at("scenes").at(0).value("page", "") : "";
  return scene.empty() ? ""
                       : element("figure", "",
                                 fmt::format(" class=\"moving\" data-scene=\"{}\"{}", escaped(scene),
                                             at_once ? " data-moves" : ""));
}

std::string entry(const fs::path& results, const Json& lesson, bool first) {
  std::string aims, after;
  for (const Json& aim : lesson.at("aims")) aims += element("li", aim.get<std::string>()) + "\n";
  for (const Json& one : lesson.at("after"))
    after +=
        (after.empty() ? " After: " : "; ") + link("#" + escaped_at(one, "name"), escaped_at(one, "title"));
  return fmt::format(
      "<li id=\"{0}\"><h2 data-pattern=\"{6}\"><a href=\"{0}/lesson.html\">{1}</a></h2>\n<p class=\"hint\">{2} minutes · "
      "<code>{0}</code> · <a href=\"{0}/slides.html\">slides</a>.{3}</p>\n{5}<ul>\n{4}</ul></li>\n",
      escaped_at(lesson, "name"), escaped_at(lesson, "title"), lesson.at("minutes").dump(), after, aims,
      picture_of(results / text_at(lesson, "name"), first), escaped_at(lesson, "pattern"));
}

std::string course_page(const fs::path& results, const Json& course) {
  std::string lessons;
  double minutes = 0;
  for (const Json& lesson : course.at("lessons")) {
    lessons += entry(results, lesson, lessons.empty());
    minutes += lesson.at("minutes").get<double>();
  }
  return page("Contact modelling: a course", "course",
              filled_in(course_html, {{"count", fmt::format("{}", course.at("lessons").size())},
                                      {"hours", fmt::format("{:.0f}", minutes / 60)},
                                      {"lessons", lessons}}) +
                  hidden_player(),
              shared_solver(results));
}

/// Room for an answer, or the answer.
std::string question_text(const Json& question, bool with_answer) {
  std::string choices;
  for (const Json& choice : question.at("choices"))
    choices += (choices.empty() ? " " : " / ") + choice.get<std::string>();
  const std::string answer = with_answer ? element("strong", text_at(question, "shown"), " class=\"key\"")
                                         : "<span class=\"blank\"></span> " + escaped_at(question, "unit");
  return element("li", fmt::format("{}{} {}", text_at(question, "ask"), choices, answer)) + "\n";
}

std::string problem_text(const Json& problem, bool with_answers) {
  std::string questions;
  for (const Json& question : problem.at("parts")) questions += question_text(question, with_answers);
  return element("li", element("p", text_at(problem, "text")) +
                           element("ol", "\n" + questions, " class=\"parts\"") +
                           (with_answers ? "" : "<div class=\"work\"></div>")) +
         "\n";
}

std::string sheet_page(const Json& sheet, bool with_answers) {
  std::string problems;
  for (const Json& problem : sheet.at("problems")) problems += problem_text(problem, with_answers);
  const std::string lesson = escaped_at(sheet, "lesson"), title = text_at(sheet, "title");
  const std::string seed = sheet.at("seed").dump(), kind = with_answers ? "Key" : "Problem sheet";
  const char* name_line = "<p class=\"name\">Name: <span class=\"blank\"></span></p>";
  const std::string note =
      with_answers
          ? fmt::format(
                "Answers are computed by the exact solver and closed forms: "
                "<code>rockstack teach {} --sheet {} --out DIR</code>.",
                lesson, seed)
          : "Angles in rad, clockwise positive; gravity is 9.81 m/s². Give answers to the digits that your "
            "way of computing supports, and say what you assumed.";
  return page(fmt::format("{}: {} {}", title, kind, seed), "sheet",
              filled_in(sheet_html, {{"kind", kind},
                                     {"lesson", element("code", lesson)},
                                     {"seed", seed},
                                     {"title", escaped(title)},
                                     {"name_line", with_answers ? "" : name_line},
                                     {"problems", problems},
                                     {"note", note},
                                     {"css", std::string(sheet_css)}}));
}

}  // namespace

void write_course(const fs::path& results, const Json& course) {
  write_file(results / "index.html", course_page(results, course));
  write_file(
      results / "glossary.html",
      page("Glossary", "course",
           element("nav", link("index.html", "All lessons"), " class=\"bar\"") + element("h1", "Glossary") +
               element("main", std::string(glossary_html)) + hidden_player(),
           shared_solver(results)));
}

SheetPages write_sheet(const fs::path& answers) {
  return read_json(answers, [&](const Json& sheet) {
    const auto place = [&](const char* kind) {
      return answers.parent_path() /
             fmt::format("{}-{}-{}.html", text_at(sheet, "lesson"), kind, sheet.at("seed").dump());
    };
    SheetPages pages{place("sheet"), place("key")};
    write_file(pages.sheet, sheet_page(sheet, false));
    write_file(pages.key, sheet_page(sheet, true));
    return pages;
  });
}

void print_pdf(const fs::path& page, const fs::path& pdf) {
  if (!has_program("chromium"))
    throw InputError("--pdf: must be asked where the program chromium is; slides.html is written");
  const Scratch scratch(pdf.parent_path().empty() ? fs::path(".") : pdf.parent_path(), ".printing");
  const fs::path made = fs::absolute(scratch.folder / "slides.pdf");
  std::string line =
      "chromium --headless --disable-gpu --no-first-run --disable-quic --disable-background-networking "
      "--disable-component-update --disable-sync --no-pdf-header-footer --window-size=1280,768 "
      "--virtual-time-budget=20000";
  if (geteuid() == 0) line += " --no-sandbox";  // which it does not have for root
  for (const std::string& word : {"--user-data-dir=" + fs::absolute(scratch.folder / "profile").string(),
                                  "--print-to-pdf=" + made.string(), fs::absolute(page).string()})
    line += " " + quoted_for_shell(word);
  line += " >/dev/null 2>&1";
  const int status = std::system(line.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code != 0 || !fs::exists(made))
    throw std::runtime_error(fmt::format("chromium: printing {} ended with {}", page.string(), code));
  fs::rename(made, pdf);
}

}  // namespace rockstack::plots
