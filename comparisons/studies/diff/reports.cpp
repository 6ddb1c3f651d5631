#include "comparisons/studies/diff/reports.hpp"

#include <fmt/format.h>

#include <boost/property_tree/xml_parser.hpp>
#include <sstream>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/results/table_form.hpp"
#include "comparisons/measures/verdict/verdict.hpp"

namespace rockstack {
namespace {

using Tree = boost::property_tree::ptree;

/// Set, step and scene of a row; of all rows of a set its name.
std::string row_words(const RunMetrics& row) {
  if (row.scene.empty()) return set_name(row) + ", all rows";
  return fmt::format("{} at {} in {}", set_name(row), quantity_text(row.dt.value_or(0), "s"), row.scene);
}

std::string chance_words(const QuantityChange& change) {
  return change.adjusted_p_value ? fmt::format(", p = {:.1g}", *change.adjusted_p_value) : "";
}

/// Adds a test case, with what is wrong where something is.
void add_case(const std::string& of, const std::string& name, const char* kind, const std::string& fault,
              Tree& suite) {
  Tree& one = suite.add("testcase", "");
  one.put("<xmlattr>.classname", of);
  one.put("<xmlattr>.name", name);
  if (!fault.empty()) one.put(std::string(kind) + ".<xmlattr>.message", fault);
}

bool counts(const QuantityChange& change) {
  return change.could_show || change.trend != Trend::none;
}

/// Suite of a row, or of all rows of a set.
Tree suite_of(const JudgedChange& judged, const RowChange& row) {
  const std::string name = row.new_row.run.empty() ? row_words(row.new_row) : row.new_row.run;
  Tree suite;
  suite.put("<xmlattr>.name", name);
  for (const QuantityChange& change : row.quantities)
    if (counts(change))
      add_case(name, quantity_named(change.quantity).words, "failure",
               change.trend == Trend::worse ? change_text(change) + chance_words(change) : "", suite);
  for (const BoundedRow& bound : judged.bounds)
    if (!row.new_row.run.empty() && bound.run->row.run == row.new_row.run)
      add_case(name,
               fmt::format("{} at most {}", bound.bound->quantity->words,
                           bound.bound->quantity->text(bound.bound->value)),
               "failure", bound.above() ? bound.text() : "", suite);
  return suite;
}

void count_cases(Tree& suite) {
  int tests = 0, failures = 0, errors = 0;
  for (const auto& [name, one] : suite) {
    if (name != "testcase") continue;
    ++tests;
    failures += static_cast<int>(one.count("failure"));
    errors += static_cast<int>(one.count("error"));
  }
  suite.put("<xmlattr>.tests", tests);
  suite.put("<xmlattr>.failures", failures);
  suite.put("<xmlattr>.errors", errors);
}

/// The numbers that stand in columns of a summary: those that headlines tell and some row has.
std::vector<std::string> shown_numbers(const ResultsChange& result) {
  std::vector<std::string> names;
  for (const ReportedQuantity& quantity : reported_quantities())
    if (quantity.told) names.push_back(quantity.name);
  names.emplace_back("step_time");
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::none_of(result.rows, [&](const RowChange& row) {
      return std::ranges::any_of(row.quantities, [&](const QuantityChange& change) {
        return change.quantity == name &&
               std::max(change.old_values.greatest, change.new_values.greatest) > 0;
      });
    });
  });
  return names;
}

/// In Markdown.
std::string cell_of(const RowChange& row, const std::string& quantity) {
  const auto change = std::ranges::find(row.quantities, quantity, &QuantityChange::quantity);
  if (change == row.quantities.end() ||
      std::max(change->old_values.greatest, change->new_values.greatest) == 0)
    return "";
  const std::string text = markdown_cell(change_text(*change));
  return change->trend == Trend::none ? text : "**" + text + "**";
}

std::string rows_table(const ResultsChange& result) {
  const std::vector<std::string> names = shown_numbers(result);
  TableCells heading{"", "scene", "engine", "step"};
  for (const std::string& name : names) heading.push_back(quantity_named(name).words);
  std::string text = markdown_line(heading) + markdown_line(TableCells(heading.size(), "---"));
  for (const RowChange& row : result.rows) {
    if (!row.old_row.steps) continue;
    TableCells cells{name(row.worst()), markdown_cell(one_line(row.new_row.scene)),
                     markdown_cell(set_name(row.new_row)), quantity_text(row.new_row.dt.value_or(0), "s")};
    for (const std::string& name : names) cells.push_back(cell_of(row, name));
    text += markdown_line(cells);
  }
  return text;
}

/// All that has turned, the worst first, up to as many as are read.
std::string turned_list(const ResultsChange& result) {
  constexpr std::size_t most = 20;
  const std::vector<TurnedNumber> turned = turned_numbers(result);
  std::string text;
  for (std::size_t i = 0; i < std::min(most, turned.size()); ++i) {
    const auto& [row, change] = turned[i];
    text += fmt::format("- {}: {} {}, {}{}\n", name(change->trend), quantity_named(change->quantity).words,
                        change_text(*change), row_words(row->new_row), chance_words(*change));
  }
  if (turned.size() > most) text += fmt::format("- and {} more\n", turned.size() - most);
  return text;
}

}  // namespace

std::string JudgedChange::headline() const {
  std::vector<std::string> above;
  for (const BoundedRow& bound : bounds)
    if (bound.above()) above.push_back(row_words(bound.run->row) + ": " + bound.text());
  return above.empty() ? change.headline()
                       : fmt::format("Above a bound: {}. {}", joined_up_to(3, above), change.headline());
}

int JudgedChange::exit_code() const {
  constexpr int undecided = 3;
  if (change.worse() || std::ranges::any_of(bounds, &BoundedRow::above)) return 1;
  return change.decided() ? 0 : undecided;
}

std::string junit_xml(const JudgedChange& judged) {
  Tree suites;
  suites.put("<xmlattr>.name", "rockstack diff");
  for (const std::vector<RowChange>* rows : {&judged.change.rows, &judged.change.sets})
    for (const RowChange& row : *rows)
      if (Tree suite = suite_of(judged, row); suite.count("testcase") > 0)
        suites.add_child("testsuite", suite);
  Tree whole;
  whole.put("<xmlattr>.name", "all rows");
  add_case("all rows", "decided", "error", judged.change.decided() ? "" : judged.change.headline(), whole);
  suites.add_child("testsuite", whole);
  for (auto& [name, suite] : suites)
    if (name == "testsuite") count_cases(suite);
  Tree document;
  document.add_child("testsuites", suites);
  std::ostringstream text;
  boost::property_tree::write_xml(text, document,
                                  boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return text.str();
}

std::string summary_markdown(const JudgedChange& judged) {
  const ResultsChange& result = judged.change;
  std::string text = fmt::format("**{}**\n\n", one_line(judged.headline())) + rows_table(result);
  if (const std::string list = turned_list(result); !list.empty()) text += "\n" + list;
  for (const std::string& other : result.other_environment)
    text += "\nMade otherwise: " + one_line(other) + "\n";
  return text +
         fmt::format(
             "\nMedians of replicates, before → now, bold where a test shows a change; chance of a false "
             "alarm among all {} numbers: {}.\n",
             result.counted, result.level);
}

}  // namespace rockstack
