// The table of plots/README.md says which question each figure answers; it must have a row for each kind of
// figure that the program draws, and none besides.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include "plots/figures/figure.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The table's questions by the names of figures.
std::map<std::string, std::string> questions() {
  const std::string whole = text_of(fs::path(ROCKSTACK_PLOTS) / "README.md");
  const std::size_t begin = whole.find("\n## Which question"), end_of_part = whole.find("\n## ", begin + 1);
  const std::string page = whole.substr(begin, end_of_part - begin);
  const std::regex row(R"(\n\| `([^`]+)` \| ([^|]+) \| [^|]+ \|)");
  std::map<std::string, std::string> found;
  for (std::sregex_iterator at(page.begin(), page.end(), row), end; at != end; ++at)
    found[(*at)[1]] = (*at)[2];
  return found;
}

TEST(Questions, EachFigureHasTheOneOfItsRow) {
  const auto table = questions();
  for (const Figure& figure : figures()) {
    bool any = false;
    for (const auto& [name, question] : table) {
      if (figure_in(name) != &figure) continue;
      any = true;
      EXPECT_EQ(question, figure.question) << name;
    }
    EXPECT_TRUE(any) << figure.name;
    EXPECT_TRUE(figure.question.ends_with('?')) << figure.name;
  }
}

TEST(Questions, NoneIsOfAFigureThatNobodyDraws) {
  for (const auto& [name, question] : questions()) EXPECT_NE(figure_in(name), nullptr) << name;
}

TEST(Questions, AFileIsOfTheFigureInItsName) {
  for (const auto& [stem, name] : {std::pair{"spanos.error-time", "error-time"},
                                   {"energy", "energy"},
                                   {"solvers.energy", "solvers.energy"},
                                   {"stability.ode-step-tuned", "stability"},
                                   {"impact-laws.engines", "impact-laws.engines"},
                                   {"impact-laws.3-blocks", "impact-laws"}})
    EXPECT_EQ(figure_in(stem)->name, name) << stem;
  EXPECT_EQ(figure_in("spanos.motion"), nullptr);
}

}  // namespace
}  // namespace rockstack::plots
