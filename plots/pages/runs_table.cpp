#include "comparisons/measures/results/csv.hpp"
#include "comparisons/measures/results/tables.hpp"
#include "plots/pages/sections.hpp"

// What a page says of a comparison's runs: all numbers, parameters, files, contacts, parts of differences.

namespace rockstack::plots {
namespace {

/// What is shown at first, as far as any run has it; the name of the run is one of them.
constexpr std::size_t shown_columns = 12;
constexpr auto wanted =
    "rms_test_difference;rms_angle_difference;largest_angle_difference;slip_error;normal_force_error;impulse_error;"
    "first_impact_time;first_impact_time_difference;agreement_time;position_agreement_time;impacts_matched;impacts_missed;impacts_extra;toppled;stepping_time_minimum;energy_gain;"
    "rms_angle_difference_lower;rms_angle_difference_upper;steps";

/// Columns in the order of the page; the first `shown` of them without the switch.
struct Order {
  std::vector<const Column*> columns;
  std::size_t shown = 0;
};

Order order_of(const Comparison& comparison) {
  Order order{{&columns().front()}};
  for (const std::string& name : parts_of(wanted)) {
    const Column& column = column_named(name);
    const auto has_value = [&](const Run& run) { return !cell_text(column.cell(run)).empty(); };
    if (order.columns.size() < shown_columns && std::ranges::any_of(comparison.runs, has_value))
      order.columns.push_back(&column);
  }
  order.shown = order.columns.size();
  for (const Column& column : columns())
    if (std::ranges::find(order.columns, &column) == order.columns.end()) order.columns.push_back(&column);
  return order;
}

std::string run_anchor(std::size_t run) {
  return fmt::format("run-{}", run + 1);
}

std::string run_row(const Comparison& comparison, const Order& order, std::size_t index) {
  const Run& run = comparison.runs[index];
  std::string name = link("#" + run_anchor(index), escaped(run.run));
  if (!run.done()) name += " " + escaped(rockstack::name(run.status));
  std::string cells = element("th", name, fmt::format(" scope=\"row\" data-value=\"{}\"", escaped(run.run)));
  for (std::size_t i = 1; i < order.columns.size(); ++i) {
    const Column& column = *order.columns[i];
    cells += table_cell(column.name, cell_text(column.cell(run)), i < order.shown ? "" : "more");
  }
  const std::string kind = run.exact() ? " class=\"exact\"" : run.done() ? "" : " class=\"failed\"";
  return element("tr", cells, kind) + "\n";
}

/// What a run's summary says beside its scene and the columns of the table, its parameters above all.
Facts beside_columns(const Run& run) {
  Facts facts = read_json(run.folder / "summary.json", facts_of);
  std::erase_if(facts, [](const auto& fact) {
    return fact.first == "title" || fact.first == "scene_file" ||
           std::ranges::any_of(columns(), [&](const auto& column) { return column.name == fact.first; });
  });
  return facts;
}

/// Which replicate figures and player show, where it is not the run at the row's own step.
std::string shown_words(const Run& run) {
  const int number = run.shown_replicate.value_or(0);
  if (number == 0) return "";
  const double dt =
      read_columns(run.folder / "draws.csv", {"dt"}).front().at(static_cast<std::size_t>(number));
  return element(
      "p",
      fmt::format(
          "Figures and player show the replicate with the median error, {}: number {} of {} from 0, at a "
          "step of {}.",
          link(escaped(fmt::format("runs/{}/{}/history.csv", run.run, shown_name)), "history.csv"), number,
          *run.draws, duration_text(dt)));
}

/// A failed run may have stopped before it wrote anything.
std::string details_of(const Comparison& comparison, std::size_t index) {
  const Run& run = comparison.runs[index];
  std::string text;
  if (!run.done()) text += element("p", fmt::format("Failed: {}", escaped(run.reason)));
  const auto version = std::ranges::find_if(comparison.environment, [&](const auto& fact) {
    return fact.first == run.engine || (run.exact() && fact.first == "rockstack");
  });
  if (version != comparison.environment.end())
    text += element("p", escaped(fmt::format("Version: {} {}", version->first, version->second)));
  std::string files;
  for (const char* name : {"history.csv", "readings.csv", "difference.csv", "events.csv", "impacts.csv",
                           "parts.csv", "draws.csv", "summary.json"})
    if (fs::exists(run.folder / name))
      files += (files.empty() ? "" : ", ") + link(escaped(fmt::format("runs/{}/{}", run.run, name)), name);
  if (!files.empty()) text += element("p", "Files beside this page: " + files);
  text += shown_words(run);
  if (fs::exists(run.folder / "summary.json")) text += definition_list(beside_columns(run));
  return details(escaped(run.run), text, fmt::format(" id=\"{}\"", run_anchor(index)));
}

/// Per cent, without a sign of zero.
double percent_of(double share) {
  return std::round(100 * share) + 0.0;
}

std::string size_and_share(const std::optional<double>& size, const std::optional<double>& share) {
  const std::string text = fmt::format("{:.2g}", value_of(size));
  return share ? fmt::format("{} ({:.0f} %)", text, percent_of(*share)) : text;
}

std::string cell_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.2g}", *value) : "";
}

std::string sentence(std::vector<Run> runs) {
  std::erase_if(runs, [](const Run& run) { return !run.step_share; });
  if (runs.empty()) return "";
  const auto percent = [&](const auto& share) {
    return percent_of(median(mapped(runs, [&](const Run& run) { return value_of(run.*share); })));
  };
  return element(
      "p", fmt::format("In the median of {} runs the contact model makes {:.0f} % of the difference, contact "
                       "softness {:.0f} % and the time step {:.0f} %.",
                       runs.size(), percent(&Run::model_share), percent(&Run::softness_share),
                       percent(&Run::step_share)));
}

}  // namespace

std::string runs_table(const Comparison& comparison) {
  const Order order = order_of(comparison);
  std::string headings, rows;
  for (std::size_t i = 0; i < order.columns.size(); ++i)
    headings += heading(order.columns[i]->name, i < order.shown ? "" : "more");
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) rows += run_row(comparison, order, i);
  return element("table", element("thead", element("tr", headings)) + element("tbody", "\n" + rows),
                 " class=\"rows\"");
}

std::string run_details(const Comparison& comparison) {
  std::string text;
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) text += details_of(comparison, i);
  return text;
}

std::string terms_table(const Comparison& comparison, const std::string& scene) {
  const std::vector<std::string> columns = parts_of(
      "run;RMS difference (rad);contact model (share);contact softness (share);time step (share);"
      "stiffness of a point (N/m);damping ratio;restitution;spring softer by, then extrapolated");
  std::vector<Run> runs = done_runs(comparison, scene);
  std::erase_if(runs, [](const Run& run) { return !run.step_difference; });
  if (runs.empty()) return "";
  const std::string rows = joined_texts(runs, [&](const Run& run) {
    return table_row(columns, {run_label(run), fmt::format("{:.2g}", value_of(run.rms_angle_difference)),
                               size_and_share(run.model_difference, run.model_share),
                               size_and_share(run.softness_difference, run.softness_share),
                               size_and_share(run.step_difference, run.step_share),
                               cell_of(run.contact_stiffness), cell_of(run.contact_damping_ratio),
                               cell_of(run.contact_restitution), cell_of(run.spring_factor)});
  });
  return titled_table("What the differences are made of", columns, rows, sentence(runs));
}

std::string contact_section(const Comparison& comparison) {
  const std::vector<std::string> columns =
      parts_of("run;interface;slip left (m);largest slip (m);times it slid;highest lift (m);times it lifted");
  const auto metres = [](const Json& one, const char* key) {
    return fmt::format("{}", one.at(key).get<double>());
  };
  const auto times = [](const Json& one, const char* key) {
    return fmt::format("{}", one.at(key).get<int>());
  };
  std::string rows;
  std::vector<std::string> warnings;
  for (const Run& run : comparison.runs) {
    const fs::path file = run.folder / "summary.json";
    if (!run.done() || !fs::exists(file)) continue;
    const std::string label =
        comparison.scenes.size() > 1 ? fmt::format("{}: {}", run.scene, run_label(run)) : run_label(run);
    read_json(file, [&](const Json& json) {
      const Json contacts = json.value("contact", Json::array());
      int number = 0;
      for (const Json& one : contacts)
        rows += table_row(
            columns,
            {label, fmt::format("{}", ++number), metres(one, "final_slip"), metres(one, "largest_slip"),
             times(one, "slips"), metres(one, "highest_lift"), times(one, "lift_offs")},
            run.exact() ? " class=\"exact\"" : "");
      if (!contacts.empty())
        for (const std::string& warning : json.value("validity_warnings", std::vector<std::string>()))
          warnings.push_back(fmt::format("{}: {}", label, warning));
    });
  }
  if (rows.empty()) return "";
  std::string text = wide_table(columns, rows, "Slip and lift-off");
  if (!warnings.empty())
    text += element("h3", "Where the laws of contact have no single answer") + sentence_list(warnings);
  return section("Slip and lift-off", text, " id=\"contacts\"");
}

}  // namespace rockstack::plots
