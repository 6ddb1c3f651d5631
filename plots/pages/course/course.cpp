#include "plots/pages/pages.hpp"

#include <fmt/format.h>

#include "comparisons/measures/results/files.hpp"
#include "plots/data/results.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/templates.hpp"

namespace rockstack::plots {
namespace {

std::string entry(const Json& lesson) {
  const auto name = lesson.at("name").get<std::string>();
  std::string aims, after;
  for (const Json& aim : lesson.at("aims")) aims += element("li", aim.get<std::string>()) + "\n";
  for (const Json& one : lesson.at("after"))
    after +=
        fmt::format("{}<a href=\"#{}\">{}</a>", after.empty() ? " After: " : "; ",
                    escaped(one.at("name").get<std::string>()), escaped(one.at("title").get<std::string>()));
  return fmt::format(
      "<li id=\"{0}\"><h2><a href=\"{0}/lesson.html\">{1}</a></h2>\n<p class=\"hint\">{2} minutes · "
      "<code>{0}</code> · <a href=\"{0}/slides.html\">slides</a>.{3}</p>\n<ul>\n{4}</ul></li>\n",
      escaped(name), escaped(lesson.at("title").get<std::string>()), lesson.at("minutes").dump(), after,
      aims);
}

std::string course_page(const Json& course) {
  std::string lessons;
  double minutes = 0;
  for (const Json& lesson : course.at("lessons")) {
    lessons += entry(lesson);
    minutes += lesson.at("minutes").get<double>();
  }
  constexpr double hour = 60;  // min
  return page({"Contact modelling: a course", "course",
               filled_in(course_html, {{"count", fmt::format("{}", course.at("lessons").size())},
                                       {"hours", fmt::format("{:.0f}", minutes / hour)},
                                       {"lessons", lessons}})});
}

}  // namespace

void write_course(const std::filesystem::path& results) {
  read_json(results / "course.json",
            [&](const Json& course) { write_file(results / "index.html", course_page(course)); });
}

}  // namespace rockstack::plots
