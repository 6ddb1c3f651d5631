#include "plots/pages/pages.hpp"

#include <fmt/core.h>

#include <map>
#include <string>
#include <vector>

#include "comparisons/measures/results/files.hpp"
#include "plots/data/results.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/page_parts.hpp"
#include "plots/pages/templates.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// A verdict as a class of the style sheet.
std::string class_of(const std::string& verdict) {
  static const std::map<std::string, std::string> classes{{"agrees", "agrees"},
                                                          {"converges", "converges"},
                                                          {"another law", "another-law"},
                                                          {"cannot tell", "cannot-tell"},
                                                          {"no run", "no-run"}};
  const auto found = classes.find(verdict);
  return found == classes.end() ? "" : found->second;
}

/// Two digits are enough to tell steps apart.
std::string steps_text(double steps) {
  if (steps < 0.01) return "&lt; 0.01";
  return steps < 100 ? fmt::format("{:.2g}", steps) : fmt::format("{:.0f}", steps);
}

std::string cell_of(const Json& answer) {
  const std::string verdict = answer.at("verdict");
  const std::string reason = escaped(answer.at("reason").get<std::string>());
  std::string text = escaped(verdict);
  if (verdict != "no run")
    text += fmt::format("<br>{} → {}", steps_text(answer.at("steps_off").front()),
                        steps_text(answer.at("steps_off").back()));
  return element("td", text, fmt::format(" class=\"{}\" title=\"{}\"", class_of(verdict), reason));
}

std::string rows_of(const Json& canon) {
  std::string rows;
  for (const Json& row : canon.at("rows")) {
    std::string cells = element(
        "th",
        escaped(fmt::format("{}:{}, {}", row.at("engine").get<std::string>(),
                            row.at("solver").get<std::string>(), row.at("settings").get<std::string>())),
        " scope=\"row\"");
    for (const Json& answer : row.at("answers")) cells += cell_of(answer);
    rows += element("tr", cells) + "\n";
  }
  return rows;
}

std::string scenes_of(const Json& canon) {
  std::string text;
  for (const Json& scene : canon.at("scenes"))
    text += element("details",
                    element("summary", escaped(fmt::format("{}: {}", scene.at("name").get<std::string>(),
                                                           scene.at("title").get<std::string>()))) +
                        element("pre", element("code", escaped(scene.at("scene_file").get<std::string>()))));
  return text;
}

/// How many engines agree or converge on each scene, and which do on all.
std::vector<std::string> answer_of(const Json& canon) {
  std::vector<std::string> sentences;
  std::string all;
  std::size_t whole = 0;
  for (const Json& row : canon.at("rows")) {
    bool follows = true;
    for (const Json& answer : row.at("answers")) {
      const std::string verdict = answer.at("verdict");
      follows = follows && (verdict == "agrees" || verdict == "converges");
    }
    if (!follows) continue;
    ++whole;
    all += fmt::format("{}{}:{} ({})", all.empty() ? "" : ", ", row.at("engine").get<std::string>(),
                       row.at("solver").get<std::string>(), row.at("settings").get<std::string>());
  }
  sentences.push_back(
      fmt::format("{} of {} rows agree with the exact solution or converge to it on every scene{}.", whole,
                  canon.at("rows").size(), all.empty() ? "" : ": " + all));
  return sentences;
}

std::string content(const Json& canon) {
  std::vector<std::string> columns{"engine, set"};
  columns.reserve(1 + canon.at("scenes").size());
  for (const Json& scene : canon.at("scenes")) columns.push_back(scene.at("name"));
  return filled_in(canon_html,
                   {{"title", escaped(canon.at("title").get<std::string>())},
                    {"answer", answer_box(answer_of(canon))},
                    {"coarse", fmt::format("{:g}", 1000 * canon.at("steps").front().get<double>())},
                    {"fine", fmt::format("{:g}", 1000 * canon.at("steps").back().get<double>())},
                    {"agreement", fmt::format("{:g}", canon.at("agreement").get<double>())},
                    {"replicates", fmt::format("{}", canon.at("replicates").get<int>())},
                    {"table", table(columns, rows_of(canon))},
                    {"scenes", scenes_of(canon)},
                    {"command", escaped(canon.at("command").get<std::string>())}});
}

}  // namespace

void write_canon_report(const fs::path& results) {
  read_json(results / "canon.json", [&](const Json& canon) {
    write_file(results / "report.html", page({canon.at("title"), "report", content(canon)}));
  });
}

}  // namespace rockstack::plots
