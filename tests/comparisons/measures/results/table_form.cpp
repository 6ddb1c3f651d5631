#include "comparisons/measures/results/table_form.hpp"

#include <gtest/gtest.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cstdlib>
#include <regex>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack {
namespace {

/// Everything that a cell of the program may have in it, and what a document's language means by it.
const std::vector<TableCells> lines{
    {"", "set", "θ₂ (rad)", "value", "remark"},
    {"*", "ode:step (tuned)", "-0.15", "3.1e-07", "50 % of a_b & c#1, {x}, $5, ~1, a^b, c\\d"},
    {"", "my_engine|x", "12", "-2.5e+03", "3a > 1a < 2b, 9.81 m/s², 10⁻⁵ − 2°, *bold* `code` [link]"},
    {"", "", "0.5", "0.1", "1 – 2 … → ≤ ± × μ ω Δ ×"}};

/// Cells of a line of pipes, as GitHub reads them: a backslash takes a mark for itself.
TableCells markdown_cells(const std::string& line) {
  TableCells cells;
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == '\\') {
      cell += line[++i];
    } else if (line[i] == '|') {
      cells.push_back(std::regex_replace(cell, std::regex("^ *| *$"), ""));
      cell.clear();
    } else {
      cell += line[i];
    }
  }
  return cells;
}

/// Text of a cell of LaTeX: macros by their names in the standard, not by the table of the program.
std::string plain_text(std::string cell) {
  const std::pair<const char*, const char*> macros[]{
      {"$^{2}$", "²"},
      {"$^{-5}$", "⁻⁵"},
      {"$_{2}$", "₂"},
      {"$^\\circ$", "°"},
      {"$\\theta$", "θ"},
      {"$\\mu$", "μ"},
      {"$\\omega$", "ω"},
      {"$\\Delta$", "Δ"},
      {"$\\times$", "×"},
      {"$\\pm$", "±"},
      {"$\\le$", "≤"},
      {"$\\to$", "→"},
      {"\\ldots{}", "…"},
      {"--", "–"},
      {"$-$", "−"},
      {"$<$", "<"},
      {"$>$", ">"},
      {"$|$", "|"},
      {"\\textbackslash{}", "\x01"},
      {"\\textasciitilde{}", "~"},
      {"\\textasciicircum{}", "^"},
  };
  for (const auto& [macro, text] : macros) boost::replace_all(cell, macro, text);
  cell = std::regex_replace(cell, std::regex(R"(\$(-?[\d.]+) \\times 10\^\{(-?\d+)\}\$)"), "$1e$2");
  cell = std::regex_replace(cell, std::regex(R"(\$(-[\d.]+)\$)"), "$1");
  cell = std::regex_replace(cell, std::regex(R"(\\([&%#_{}$]))"), "$1");
  return boost::replace_all_copy(cell, "\x01", "\\");
}

/// Cells of a line of a tabular.
TableCells latex_cells(std::string line) {
  boost::replace_all(line, "\\&", "\x02");
  boost::replace_all(line, " \\\\", "");
  TableCells cells;
  for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 3) {
    to = line.find(" & ", from);
    cells.push_back(plain_text(boost::replace_all_copy(line.substr(from, to - from), "\x02", "\\&")));
  }
  return cells;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) parts.push_back(line);
  return parts;
}

/// Exponents without the sign and the zeros that print formats put there.
std::string shorter_exponents(const std::string& text) {
  return std::regex_replace(text, std::regex(R"((\d)e\+?(-?)0*(\d))"), "$1e$2$3");
}

TEST(TableForm, MarkdownIsReadBackToTheSameCells) {
  const std::vector<std::string> made = split(table_text(lines, TableForm::markdown));
  ASSERT_EQ(made.size(), lines.size() + 1);
  EXPECT_EQ(made[1], "| --- | --- | ---: | ---: | --- |") << "columns of numbers stand at the right";
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_EQ(markdown_cells(made[i == 0 ? 0 : i + 1]), lines[i]) << made[i];
}

TEST(TableForm, LatexIsReadBackToTheSameCells) {
  const std::vector<std::string> made = split(table_text(lines, TableForm::latex));
  ASSERT_EQ(made.size(), lines.size() + 6);
  EXPECT_EQ(made[1], "\\begin{tabular}{llrrl}");
  EXPECT_EQ(made[2], "\\toprule");
  EXPECT_EQ(made[4], "\\midrule");
  EXPECT_EQ(made[lines.size() + 4], "\\bottomrule");
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_EQ(latex_cells(made[i == 0 ? 3 : i + 4]), mapped(lines[i], shorter_exponents)) << made[i];
}

/// A special character of TeX outside a macro would be an error there, or end a cell.
TEST(TableForm, NoSpecialCharacterOfLatexIsLeftBare) {
  for (const std::string text : {"50 % of a_b & c#1", "{x}", "$5", "~1", "a^b", "c\\d", "θ₂ ω 10⁻⁵ m/s²"}) {
    std::string cell = latex_cell(text);
    cell = std::regex_replace(cell, std::regex(R"(\$[^$]*\$|\\[a-z]+\{\}|\\[&%#_{}$])"), "");
    EXPECT_EQ(cell.find_first_of("\\&%$#_{}~^"), std::string::npos) << latex_cell(text);
    for (const char letter : cell) EXPECT_GE(letter, 0) << latex_cell(text);
  }
}

TEST(TableForm, NumbersHaveSignsAndPowersOfTenInLatexAndNamesDoNot) {
  EXPECT_EQ(latex_cell("-0.5"), "$-0.5$");
  EXPECT_EQ(latex_cell("0.5"), "0.5");
  EXPECT_EQ(latex_cell("3.1e-07 (2e+04)"), "$3.1 \\times 10^{-7}$ ($2 \\times 10^{4}$)");
  EXPECT_EQ(latex_cell("1.5-2.5"), "1.5-2.5") << "a range";
  EXPECT_EQ(latex_cell("half-10e, box2e5"), "half-10e, box2e5") << "names";
}

TEST(TableForm, ALineThatEndsEarlyHasEmptyCellsInDocuments) {
  const std::vector<TableColumn> columns{{"a", 3, true, 0}, {"b", 2}, {"c"}};
  EXPECT_EQ(table_line(columns, {"1", "x"}, TableForm::text), "  1 x \n");
  EXPECT_EQ(table_line(columns, {"1", "x"}, TableForm::markdown), "| 1 | x |  |\n");
  EXPECT_EQ(table_line(columns, {"1", "x"}, TableForm::latex), "1 & x &  \\\\\n");
}

TEST(TableForm, TextHasColumnsAsWideAsTheirCells) {
  EXPECT_EQ(table_text({{"a", "θ"}, {"long", ""}, {"b", "2"}}, TableForm::text), "a     θ\nlong\nb     2\n");
}

TEST(TableForm, ANameThatIsNoneIsRefused) {
  EXPECT_EQ(named_table_form("tex"), TableForm::latex);
  EXPECT_THROW(named_table_form("html"), InputError);
}

/// The whole language judges, where it is installed.
TEST(TableForm, ADocumentWithTheTableCompiles) {
  if (std::system("pdflatex --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "pdflatex is not there";
  const TemporaryFolder folder;
  folder.write("table.tex", "\\documentclass{article}\n\\usepackage{booktabs}\n\\begin{document}\n" +
                                table_text(lines, TableForm::latex) + "\\end{document}\n");
  const std::string command = "cd " + folder.path().string() +
                              " && pdflatex -halt-on-error -interaction=nonstopmode table.tex >log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace rockstack
