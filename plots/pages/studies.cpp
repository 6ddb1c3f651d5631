#include "comparisons/measures/results/csv.hpp"
#include "plots/figures/studies/sweep_facts.hpp"
#include "plots/pages/html.hpp"

namespace rockstack::plots {
namespace {

using Sentences = std::vector<std::string>;

/// What the pages differ in.
struct Study {
  std::string title;
  Sentences answers;
  std::vector<std::string> tables = {};  ///< files to be shown, where they are there
};

void write_study(const fs::path& results, const Json& json, const Study& study) {
  std::string tables;
  for (const std::string& name : study.tables) {
    if (!fs::exists(results / name)) continue;
    const auto [columns, rows] = read_table(results / name);
    std::string text;
    for (const auto& row : rows) text += table_row(columns, row);
    tables += element("h3", escaped(name)) + wide_table(columns, text, "Table") + "\n";
  }
  Facts facts = facts_of(json);  // that the page has nowhere else
  std::erase_if(facts, [](const auto& fact) {
    return fact.first == "command" || fact.first == "title" || fact.first.starts_with("trials.");
  });
  // A sweep's command stands beside its results, which are the same bytes whatever it is.
  const fs::path timing = results / "timing.json";
  const std::string command =
      json.value("command", fs::exists(timing) ? read_json(timing).value("command", "") : "");
  const std::string content = filled_in(
      study_html, {{"title", escaped(study.title)},
                   {"answer", answer_box(study.answers)},
                   {"figures", drawn_figures(results)},
                   {"files", file_links(results)},
                   {"tables", tables},
                   {"command", command.empty() ? "" : element("h2", "To run it again") + code_block(command)},
                   {"facts", definition_list(facts)}});
  write_file(results / "report.html", page(study.title, "report", content));
}

std::string verdicts(const fs::path& results) {
  std::map<std::string, std::size_t> counts;
  std::size_t all = 0;
  for (CsvLine row(results / "stability.csv"); row.next();)
    if (!row.text("dt").empty()) ++counts[row.text("verdict")], ++all;
  Sentences parts;
  for (const char* name : {"sound", "inexact", "unstable", "failed"})
    if (counts[name] > 0)
      parts.push_back(fmt::format("{} {} {}", counts[name], counts[name] == 1 ? "is" : "are", name));
  return fmt::format("Of {} {}.", counted(all, "engine run"), joined(parts));
}

void add_stable_steps(const fs::path& results, const std::string& axis, Sentences& sentences) {
  std::map<std::string, std::vector<double>> lists;
  for (CsvLine row(results / "steps.csv"); row.next();)
    lists[fmt::format("{} {}, {}", row.text("engine"), row.text("solver"), row.text("settings"))].push_back(
        row.value("largest_stable_step"));
  const auto words = [](double step) { return step > 0 ? duration_text(step) : std::string("none"); };
  for (const auto& [name, list] : lists) {
    const auto [least, most] = std::ranges::minmax_element(list);
    sentences.push_back(fmt::format("{}: the largest stable step is {} {} values of {}.", name,
                                    *least == *most
                                        ? fmt::format("{} at all", words(*least))
                                        : fmt::format("between {} and {} over", words(*least), words(*most)),
                                    list.size(), axis));
  }
}

/// "3.974 m/s² at 2.92 s".
std::string peak(const Json& json, const char* unit) {
  return fmt::format("{:.4g} {} at {:.4g} s", json.at("value").get<double>(), unit,
                     json.at("time").get<double>());
}

/// Two digits are enough to tell steps apart.
std::string steps_text(double steps) {
  if (steps < 0.01) return "&lt; 0.01";
  return steps < 100 ? fmt::format("{:.2g}", steps) : fmt::format("{:.0f}", steps);
}

std::string verdict_cell(const Json& answer) {
  std::string text = escaped_at(answer, "verdict"), name = text;
  std::ranges::replace(name, ' ', '-');  // the class of the style sheet: another-law
  if (answer.at("verdict") != "no run")
    text += fmt::format("<br>{} → {}", steps_text(answer.at("steps_off").front()),
                        steps_text(answer.at("steps_off").back()));
  return element("td", text, fmt::format(" class=\"{}\" title=\"{}\"", name, escaped_at(answer, "reason")));
}

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

std::string canon_content(const Json& canon) {
  std::vector<std::string> columns{"engine, set"};
  std::string scenes;
  for (const Json& scene : canon.at("scenes")) {
    columns.push_back(scene.at("name"));
    scenes += details(escaped(text_at(scene, "name") + ": " + text_at(scene, "title")),
                      code_block(text_at(scene, "scene_file")));
  }
  const std::string rows = joined_texts(canon.at("rows"), [](const Json& row) {
    const std::string name = escaped(solver_named(row) + ", " + text_at(row, "settings"));
    return element("tr",
                   element("th", name, " scope=\"row\"") + joined_texts(row.at("answers"), verdict_cell)) +
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

void write_sweep_report(const fs::path& results, const Json& json) {
  write_study(results, json,
              {text_at(json, "title"),
               json.at("headline").get<Sentences>(),
               {"fragility-fit.csv", "fragility.csv", "incremental-fractiles.csv"}});
}

void write_stability_report(const fs::path& results, const Json& json) {
  Study study{"Stability: " + text_at(json, "title"), {verdicts(results)}, {"steps.csv", "stability.csv"}};
  add_stable_steps(results, text_at(json, "axis"), study.answers);
  write_study(results, json, study);
}

void write_advice_report(const fs::path& results, const Json& json) {
  write_study(results, json,
              {"Advice: " + text_at(json, "title"), json.at("headline").get<Sentences>(), {"advice.csv"}});
}

void write_fit_report(const fs::path& results, const Json& json) {
  Sentences answers;
  for (const Json& one : json.at("parameters")) {
    const std::string found = fmt::format("{} = {:.6g}", text_at(one, "key"), one.at("value").get<double>());
    answers.push_back(one.at("lower").is_null()
                          ? found + "."
                          : fmt::format("{}, with 95 % confidence from {:.6g} to {:.6g}.", found,
                                        one.at("lower").get<double>(), one.at("upper").get<double>()));
  }
  for (const Json& sentence : json.at("meaning")) answers.push_back(sentence);
  write_study(results, json, {"Fit: " + text_at(json, "title"), answers});
}

void write_record_report(const fs::path& results, const Json& json) {
  const double gravity = json.at("gravity").get<double>();
  const double most = std::abs(json.at("peak_acceleration").at("value").get<double>());
  const Json& span = json.at("significant_5_95");
  write_study(
      results, json,
      {"Record " + fs::path(text_at(json, "file")).filename().string(),
       {fmt::format("The peak acceleration is {:.3g} g: {}.", most / gravity,
                    peak(json.at("peak_acceleration"), "m/s²")),
        fmt::format("The peak velocity is {}, the peak displacement {}.",
                    peak(json.at("peak_velocity"), "m/s"), peak(json.at("peak_displacement"), "m")),
        fmt::format(
            "The significant duration is {:.4g} s, from 5 to 95 % of the Arias intensity of {:.4g} m/s.",
            span.at("length").get<double>(), json.at("arias_intensity").get<double>())}});
}

void write_canon_report(const fs::path& results, const Json& canon) {
  write_file(results / "report.html", page(canon.at("title"), "report", canon_content(canon)));
}

}  // namespace rockstack::plots
