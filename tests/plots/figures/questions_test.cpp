// The table of plots/README.md says which question each figure answers; it must have a row for each kind of
// figure that the program draws, and none besides.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "plots/data/scores.hpp"
#include "plots/figures/comparison/figures.hpp"

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

/// The names of figure files that the code of sweeps, studies and records holds, as far as they are fixed:
/// all but what is filled in behind.
std::set<std::string> names_in_code() {
  const std::regex name(R"re((?:figures"? / |name =\s+|title = fmt::format\()"([a-z-]+[a-z.-]*))re");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ROCKSTACK_PLOTS) / "figures")) {
    if (entry.path().extension() != ".cpp" || entry.path().parent_path().filename() == "comparison") continue;
    const std::string code = text_of(entry.path());
    for (std::sregex_iterator at(code.begin(), code.end(), name), end; at != end; ++at)
      names.insert((*at)[1]);
  }
  return names;
}

bool begins_one_of(const std::string& stem, const std::map<std::string, std::string>& table) {
  return std::any_of(table.begin(), table.end(),
                     [&](const auto& row) { return row.first.starts_with(stem); });
}

TEST(Questions, EachFigureOfAComparisonHasTheOneOfItsCaption) {
  const auto table = questions();
  for (const FigureKind& kind : figure_kinds()) {
    const auto row = table.find(kind.name);
    ASSERT_NE(row, table.end()) << kind.name;
    EXPECT_EQ(row->second, kind.explanation.substr(0, kind.explanation.find('?') + 1)) << kind.name;
  }
}

TEST(Questions, EachOfAllSolversIsTheOneOfItsFigure) {
  const auto table = questions();
  for (const SolverQuestion& question : solver_questions()) {
    const auto row = table.find("solvers." + question.name);
    ASSERT_NE(row, table.end()) << question.name;
    EXPECT_EQ(row->second, question.question);
  }
}

TEST(Questions, EachFigureOfASweepAStudyOrARecordHasOne) {
  const auto table = questions();
  const std::set<std::string> names = names_in_code();
  for (const char* name : {"fragility", "impact-laws.", "overturning", "record", "stability."})
    EXPECT_TRUE(names.contains(name)) << "the code is read wrongly: " << name;
  for (const std::string& name : names) EXPECT_TRUE(begins_one_of(name, table)) << name;
}

TEST(Questions, NoneIsOfAFigureThatNobodyDraws) {
  std::set<std::string> known = names_in_code();
  for (const FigureKind& kind : figure_kinds()) known.insert(kind.name);
  for (const auto& [name, question] : questions())
    EXPECT_TRUE(std::any_of(known.begin(), known.end(), [&, &row = name](const std::string& one) {
      return row.starts_with(one);
    })) << name;
}

}  // namespace
}  // namespace rockstack::plots
