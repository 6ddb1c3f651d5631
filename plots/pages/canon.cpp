#include "plots/pages/html.hpp"

namespace rockstack::plots {
namespace {

/// Two digits are enough to tell steps apart.
std::string steps_text(double steps) {
  if (steps < 0.01) return "&lt; 0.01";
  return steps < 100 ? fmt::format("{:.2g}", steps) : fmt::format("{:.0f}", steps);
}

std::string cell_of(const Json& answer) {
  std::string text = escaped_at(answer, "verdict"), name = text;
  std::ranges::replace(name, ' ', '-');  // the class of the style sheet: another-law
  if (answer.at("verdict") != "no run")
    text += fmt::format("<br>{} → {}", steps_text(answer.at("steps_off").front()),
                        steps_text(answer.at("steps_off").back()));
  return element("td", text, fmt::format(" class=\"{}\" title=\"{}\"", name, escaped_at(answer, "reason")));
}

/// Which sets agree or converge in the most scenes.
std::string answer_of(const Json& canon) {
  std::vector<std::string> first;
  std::ptrdiff_t most = 0;
  for (const Json& row : canon.at("rows")) {
    const auto follows = std::ranges::count_if(row.at("answers"), [](const Json& answer) {
      return answer.at("verdict") == "agrees" || answer.at("verdict") == "converges";
    });
    if (follows > most) first.clear();
    most = std::max(most, follows);
    if (follows == most) first.push_back(fmt::format("{} ({})", solver_named(row), text_at(row, "settings")));
  }
  const std::size_t sets = canon.at("rows").size();
  const auto scenes = std::ssize(canon.at("scenes"));
  if (most == 0)
    return fmt::format("No set agrees with the exact solution, or converges to it, in any of {} scenes.",
                       scenes);
  return fmt::format("{} {} with the exact solution, or {} to it, in {} of {} scenes{}.",
                     joined_up_to(3, first), first.size() == 1 ? "agrees" : "agree",
                     first.size() == 1 ? "converges" : "converge", most, scenes,
                     sets == 1 || most == scenes ? "" : fmt::format("; none of {} sets in more", sets));
}

std::string content(const Json& canon) {
  std::vector<std::string> columns{"engine, set"};
  std::string scenes;
  for (const Json& scene : canon.at("scenes")) {
    columns.push_back(scene.at("name"));
    scenes += details(escaped(text_at(scene, "name") + ": " + text_at(scene, "title")),
                      code_block(text_at(scene, "scene_file")));
  }
  const std::string rows = text_of_each(canon.at("rows"), [](const Json& row) {
    const std::string name = escaped(solver_named(row) + ", " + text_at(row, "settings"));
    return element("tr", element("th", name, " scope=\"row\"") + text_of_each(row.at("answers"), cell_of)) +
           "\n";
  });
  return filled_in(canon_html,
                   {{"title", escaped_at(canon, "title")},
                    {"answer", answer_box({answer_of(canon)})},
                    {"coarse", fmt::format("{:g}", 1000 * canon.at("steps").front().get<double>())},
                    {"fine", fmt::format("{:g}", 1000 * canon.at("steps").back().get<double>())},
                    {"agreement", fmt::format("{:g}", canon.at("agreement").get<double>())},
                    {"replicates", canon.at("replicates").dump()},
                    {"table", table(columns, rows)},
                    {"scenes", scenes},
                    {"command", escaped_at(canon, "command")}});
}

}  // namespace

void write_canon_report(const fs::path& results) {
  read_json(results / "canon.json", [&](const Json& canon) {
    write_file(results / "report.html", page(canon.at("title"), "report", content(canon)));
  });
}

}  // namespace rockstack::plots
