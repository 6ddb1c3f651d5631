#include "comparisons/studies/lessons/course/answered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "comparisons/measures/results/files.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/studies/lessons/course/quantities.hpp"
#include "comparisons/studies/lessons/lesson.hpp"

namespace rockstack {
namespace {

using Places = std::map<std::string, std::string>;

std::vector<std::string> all_filled_in(const std::vector<std::string>& texts, const Places& places) {
  std::vector<std::string> list;
  list.reserve(texts.size());
  for (const std::string& text : texts) list.push_back(filled_in(text, places));
  return list;
}

std::size_t right_choice(const Part& part, double value) {
  const auto bound = std::lower_bound(part.bounds.begin(), part.bounds.end(), value);
  return static_cast<std::size_t>(bound - part.bounds.begin());
}

std::string shown(const Part& part, double value) {
  if (!part.choices.empty()) return part.choices[right_choice(part, value)];
  constexpr double large = 1e6;
  const std::string digits = std::abs(value) < large ? fixed(value, part.digits) : power(value, part.digits);
  return part.unit.empty() ? digits : fmt::format("{} {}", digits, part.unit);
}

Asked asked_in(const Problem& problem, const std::vector<std::string>& changes, const Places& places) {
  return problem.scene.empty() ? Asked() : asked_about(problem.scene, all_filled_in(changes, places));
}

/// Each value of the range as likely as any other, but for a share of 10⁻¹⁷ or so.
double drawn(const DrawnRange& range, std::mt19937_64& generator) {
  const auto count = static_cast<std::uint64_t>(std::floor((range.most - range.least) / range.step + 1.5));
  const double value = range.least + range.step * static_cast<double>(generator() % count);
  constexpr double digits = 1e9;  // 0.1 + 2 · 0.1 is 0.3
  return std::round(value * digits) / digits;
}

}  // namespace

Answered answered(const Problem& problem, const std::map<std::string, double>& numbers) {
  Places places;
  for (const auto& [name, number] : numbers) places[name] = cell(number);
  Asked asked = asked_in(problem, problem.changes, places);
  Asked other = problem.against.empty() ? Asked() : asked_in(problem, problem.against, places);
  asked.numbers = other.numbers = numbers;
  Answered result{problem.name, filled_in(problem.text, places), {}};
  for (Part part : problem.parts) {
    part.ask = filled_in(part.ask, places);
    part.choices = all_filled_in(part.choices, places);
    const double divisor = problem.against.empty() ? 1 : quantity(part.answer, other);
    const double value = quantity(part.answer, asked) / divisor;
    result.parts.push_back({part, value, shown(part, value)});
  }
  return result;
}

nlohmann::ordered_json to_json(const Answered& question) {
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for (const auto& [part, value, shown] : question.parts) {
    parts.push_back({{"ask", part.ask},
                     {"choices", part.choices},
                     {"unit", part.unit},
                     {"within", part.within},
                     {"value", value},
                     {"shown", shown},
                     {"why", part.why}});
    if (!part.choices.empty()) parts.back()["right"] = right_choice(part, value);
  }
  return {{"name", question.name}, {"text", question.text}, {"parts", parts}};
}

std::vector<Answered> drawn_problems(const std::string& lesson, std::uint64_t seed) {
  std::mt19937_64 generator(seed ^ checksum(lesson));
  std::vector<Answered> list;
  for (const Problem& problem : read_course(lesson).problems) {
    std::map<std::string, double> numbers;
    for (const DrawnRange& range : problem.draw) numbers[range.name] = drawn(range, generator);
    list.push_back(answered(problem, numbers));
  }
  return list;
}

nlohmann::ordered_json sheet_json(const std::string& lesson, const std::string& title, std::uint64_t seed) {
  nlohmann::ordered_json problems = nlohmann::ordered_json::array();
  for (const Answered& problem : drawn_problems(lesson, seed)) problems.push_back(to_json(problem));
  return {{"lesson", lesson}, {"title", title}, {"seed", seed}, {"problems", problems}};
}

}  // namespace rockstack
