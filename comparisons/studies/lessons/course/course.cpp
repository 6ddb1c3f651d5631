#include "comparisons/studies/lessons/course/course.hpp"

#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/suites/shipped.hpp"

namespace rockstack {
namespace {

// Of files that nobody but the lessons has; what keys mean stands at the members that they fill.

constexpr KeyTable course_keys{
    "",
    "a lesson as part of a course",
    {{"minutes"}, {"pattern"}, {"after"}, {"aims"}, {"references"}, {"predictions"}, {"problems"}}};

constexpr KeyTable problem_keys{"[[problems]]",
                                "a question with its scene",
                                {{"name"}, {"text"}, {"scene"}, {"set"}, {"against"}, {"draw"}, {"parts"}}};

constexpr KeyTable part_keys{
    "parts",
    "one thing that is asked",
    {{"ask"}, {"answer"}, {"choices"}, {"bounds"}, {"unit"}, {"digits"}, {"within"}, {"why"}}};

std::vector<std::string> texts(const Node& table, const char* key) {
  const Node* node = find(table, key);
  if (node == nullptr || node->children.empty()) return {};
  return each_of(entries(*node, "an array of texts"), text);
}

std::string text_or_none(const Node& table, const char* key) {
  const Node* node = find(table, key);
  return node == nullptr ? "" : text(*node);
}

std::vector<double> read_bounds(const Node& table, std::size_t choices) {
  const Node* node = find(table, "bounds");
  if (node == nullptr && choices == 0) return {};
  const Node& array = node == nullptr ? required(table, "bounds", "given beside choices") : *node;
  std::vector<double> bounds = numbers(array);
  if (bounds.size() + 1 != choices || !std::is_sorted(bounds.begin(), bounds.end()))
    throw wrong_value(array, "ascending numbers, one fewer than choices");
  return bounds;
}

Part read_part(const Node& table) {
  require_table(table, part_keys);
  Part part;
  part.ask = text(required(table, "ask", "a text"));
  part.answer = text(required(table, "answer", "a quantity"));
  part.choices = texts(table, "choices");
  part.bounds = read_bounds(table, part.choices.size());
  part.unit = text_or_none(table, "unit");
  if (const Node* node = find(table, "digits")) part.digits = static_cast<int>(whole_number(*node, 0, 9));
  if (const Node* node = find(table, "within")) part.within = number_above_zero(*node);
  part.why = text_or_none(table, "why");
  return part;
}

DrawnRange read_drawn_range(const Node& node) {
  const std::vector<double> values = numbers(node);
  if (values.size() != 3 || !(values[1] >= values[0]) || !(values[2] > 0))
    throw wrong_value(node, "[least, most, step] with least ≤ most and step > 0");
  return {node.name, values[0], values[1], values[2]};
}

Problem read_problem(const Node& table) {
  require_table(table, problem_keys);
  const Node* draw = find(table, "draw");
  return {
      .name = text_or_none(table, "name"),
      .text = text_or_none(table, "text"),
      .scene = text_or_none(table, "scene"),
      .changes = texts(table, "set"),
      .against = texts(table, "against"),
      .draw = each_of(draw == nullptr ? std::vector<Node>() : draw->children, read_drawn_range),
      .parts = each_of(entries(required(table, "parts", "what is asked"), "an array of tables"), read_part)};
}

std::vector<Problem> read_problems(const Node& root, const char* key) {
  return each_of(entries(required(root, key, "an array of tables"), "an array of tables"), read_problem);
}

}  // namespace

CourseEntry read_course(const std::string& lesson) {
  const Node root = read_toml(shipped("studies/lessons") / "course" / (lesson + ".toml"));
  require_table(root, course_keys);
  constexpr double longest = 600;
  return {.aims = texts(root, "aims"),
          .minutes = static_cast<int>(whole_number(required(root, "minutes", "a whole number"), 1, longest)),
          .pattern = text(required(root, "pattern", "a pattern's name")),
          .after = texts(root, "after"),
          .references = texts(root, "references"),
          .predictions = read_problems(root, "predictions"),
          .problems = read_problems(root, "problems")};
}

}  // namespace rockstack
