#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/analytic/paper/effects.hpp"
#include "tests/analytic/paper/verdicts.hpp"

// The page that reports the audit says what the tests hold.

namespace rockstack::paper {
namespace {

/// The lines that have a form, with its parts.
std::vector<std::smatch> rows(const std::vector<std::string>& lines, const std::regex& form) {
  std::vector<std::smatch> found;
  for (const std::string& line : lines) {
    std::smatch match;
    if (std::regex_match(line, match, form)) found.push_back(match);
  }
  return found;
}

const std::vector<std::string>& page() {
  static const std::vector<std::string> lines = [] {
    std::ifstream file(AUDIT_PAGE);
    std::vector<std::string> result;
    for (std::string line; std::getline(file, line);) result.push_back(line);
    return result;
  }();
  return lines;
}

/// Verdicts of the page by equation; rows are "| (12) | subject | verdict | note |" or "| (12)–(15) | …".
std::map<int, std::string> page_verdicts() {
  static const std::regex form(
      R"(\| \((\d+)\)(?:–\((\d+)\))? \| [^|]+ \| (definition|agrees|misprint|ambiguous) \|[^|]*\|)");
  std::map<int, std::string> found;
  for (const std::smatch& row : rows(page(), form)) {
    const int first = std::stoi(row[1]);
    const int last = row[2].matched ? std::stoi(row[2]) : first;
    for (int number = first; number <= last; ++number) {
      EXPECT_EQ(found.count(number), 0U) << "equation (" << number << ") stands twice in " << AUDIT_PAGE;
      found[number] = row[3];
    }
  }
  return found;
}

TEST(AuditPage, GivesEveryEquationTheVerdictThatTheTestsHold) {
  const auto found = page_verdicts();
  EXPECT_EQ(found.size(), static_cast<std::size_t>(equation_count));
  for (int number = 1; number <= equation_count; ++number) {
    const auto entry = found.find(number);
    ASSERT_NE(entry, found.end()) << "equation (" << number << ") is missing in " << AUDIT_PAGE;
    EXPECT_EQ(entry->second, name(verdict_of(number))) << "equation (" << number << ")";
  }
}

TEST(AuditPage, HasAParagraphForEveryEquationThatIsNotRight) {
  static const std::regex heading(R"(\*\*((?:\(\d+\)[–, and]*)+)\.\*\*.*)");
  std::map<int, bool> told;
  for (const std::smatch& row : rows(page(), heading)) {
    const std::string numbers = row[1];
    static const std::regex range(R"(\((\d+)\)(?:–\((\d+)\))?)");
    for (std::sregex_iterator it(numbers.begin(), numbers.end(), range), end; it != end; ++it) {
      const int first = std::stoi((*it)[1]);
      const int last = (*it)[2].matched ? std::stoi((*it)[2]) : first;
      for (int number = first; number <= last; ++number) told[number] = true;
    }
  }
  for (int number = 1; number <= equation_count; ++number) {
    const Verdict verdict = verdict_of(number);
    if (verdict == Verdict::misprint || verdict == Verdict::ambiguous) {
      EXPECT_TRUE(told[number]) << "equation (" << number << ")";
    }
  }
}

/// A number as the page prints it.
void expect_printed(const std::string& cell, double value, const std::string& subject) {
  if (cell == "never") {
    EXPECT_TRUE(std::isinf(value)) << subject;
    return;
  }
  // Three decimals, half of the last one either way.
  EXPECT_NEAR(std::stod(cell), value, 0.0005 * (1 + 1e-9)) << subject;
}

TEST(AuditPage, QuotesTheEffectsOnThePapersExampleAsComputed) {
  static const std::regex form(R"(\| (\([^|]*?) \| [^|]+ \| (-?[\d.]+|never) \| (-?[\d.]+|never) \|)");
  const auto found = rows(page(), form);
  const auto expected = effects();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found[i][1], expected[i].subject);
    expect_printed(found[i][2], expected[i].printed, expected[i].subject);
    expect_printed(found[i][3], expected[i].right, expected[i].subject);
  }
}

}  // namespace
}  // namespace rockstack::paper
