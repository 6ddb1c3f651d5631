#include "comparisons/studies/lessons/course/sheet.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "comparisons/measures/results/files.hpp"

namespace rockstack {
namespace {

/// Each value of the range as likely as any other, but for a share of 10⁻¹⁷ or so.
double drawn(const DrawnRange& range, std::mt19937_64& generator) {
  const auto count = static_cast<std::uint64_t>(std::floor((range.most - range.least) / range.step + 1.5));
  const double value = range.least + range.step * static_cast<double>(generator() % count);
  constexpr double digits = 1e9;  // 0.1 + 2 · 0.1 is 0.3
  return std::round(value * digits) / digits;
}

}  // namespace

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
