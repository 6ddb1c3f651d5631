#include "comparisons/measures/results/table_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <span>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {
namespace {

bool continues_letter(char byte) {
  return (byte & 0xC0) == 0x80;
}

std::size_t letters(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues_letter));
}

/// Bytes of the letter that begins at a place of a text in UTF-8.
std::string letter_at(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && continues_letter(text[end])) ++end;
  return text.substr(at, end - at);
}

const std::map<std::string, std::string> latex_letters{{"\\", "\\textbackslash{}"},
                                                       {"&", "\\&"},
                                                       {"%", "\\%"},
                                                       {"$", "\\$"},
                                                       {"#", "\\#"},
                                                       {"_", "\\_"},
                                                       {"{", "\\{"},
                                                       {"}", "\\}"},
                                                       {"~", "\\textasciitilde{}"},
                                                       {"^", "\\textasciicircum{}"},
                                                       {"<", "$<$"},
                                                       {">", "$>$"},
                                                       {"|", "$|$"},
                                                       {"…", "\\ldots{}"},
                                                       {"–", "--"},
                                                       {"—", "---"},
                                                       {"−", "$-$"},
                                                       {"×", "$\\times$"},
                                                       {"·", "$\\cdot$"},
                                                       {"±", "$\\pm$"},
                                                       {"≤", "$\\le$"},
                                                       {"≥", "$\\ge$"},
                                                       {"→", "$\\to$"},
                                                       {"∞", "$\\infty$"},
                                                       {"√", "$\\surd$"},
                                                       {"½", "$\\frac{1}{2}$"},
                                                       {"°", "$^\\circ$"},
                                                       {"α", "$\\alpha$"},
                                                       {"β", "$\\beta$"},
                                                       {"γ", "$\\gamma$"},
                                                       {"δ", "$\\delta$"},
                                                       {"ε", "$\\varepsilon$"},
                                                       {"θ", "$\\theta$"},
                                                       {"λ", "$\\lambda$"},
                                                       {"μ", "$\\mu$"},
                                                       {"µ", "$\\mu$"},
                                                       {"π", "$\\pi$"},
                                                       {"ρ", "$\\rho$"},
                                                       {"σ", "$\\sigma$"},
                                                       {"φ", "$\\varphi$"},
                                                       {"ω", "$\\omega$"},
                                                       {"Δ", "$\\Delta$"}};

const std::map<std::string, std::string> raised_letters{{"⁰", "0"}, {"¹", "1"}, {"²", "2"}, {"³", "3"},
                                                        {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"},
                                                        {"⁸", "8"}, {"⁹", "9"}, {"⁻", "-"}};

const std::map<std::string, std::string> lowered_letters{{"₀", "0"}, {"₁", "1"}, {"₂", "2"}, {"₃", "3"},
                                                         {"₄", "4"}, {"₅", "5"}, {"₆", "6"}, {"₇", "7"},
                                                         {"₈", "8"}, {"₉", "9"}};

/// A number with a sign or an exponent, where no name goes on with it.
const std::regex signed_number(R"((-?)(\d+\.?\d*)(?:e([+-]?)0*(\d+))?(?![\w.]))");

/// Reads a run of raised or lowered letters, and goes on behind it.
std::string script(const std::string& text, std::size_t& at,
                   const std::map<std::string, std::string>& letters, char mark) {
  std::string run;
  while (at < text.size()) {
    const std::string letter = letter_at(text, at);
    const auto found = letters.find(letter);
    if (found == letters.end()) break;
    run += found->second;
    at += letter.size();
  }
  return run.empty() ? run : fmt::format("${}{{{}}}$", mark, run);
}

/// Reads a number that needs the mathematics of LaTeX, and goes on behind it; empty where there is none.
std::string latex_number(const std::string& text, std::size_t& at) {
  const auto is_name = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '.';
  };
  std::smatch found;
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(at);
  if ((at > 0 && is_name(text[at - 1])) ||
      !std::regex_search(from, text.end(), found, signed_number, std::regex_constants::match_continuous))
    return "";
  if (found.length(1) == 0 && found.length(4) == 0) return "";
  at += static_cast<std::size_t>(found.length());
  const std::string power = found.length(4) == 0 ? ""
                                                 : fmt::format(" \\times 10^{{{}{}}}",
                                                               found.str(3) == "-" ? "-" : "", found.str(4));
  return fmt::format("${}{}{}$", found.str(1), found.str(2), power);
}

/// A cell in a form for documents.
std::string escaped(const std::string& cell, TableForm form) {
  const std::string text(trimmed(one_line(cell), " "));
  return form == TableForm::markdown ? markdown_cell(text) : latex_cell(text);
}

/// Cells of a document's table, one for each column.
TableCells escaped(const std::vector<TableColumn>& columns, const TableCells& cells, TableForm form) {
  TableCells all = mapped(cells, [form](const std::string& cell) { return escaped(cell, form); });
  all.resize(columns.size());
  return all;
}

std::string latex_line(const TableCells& cells) {
  return fmt::format("{} \\\\\n", fmt::join(cells, " & "));
}

std::string text_line(const std::vector<TableColumn>& columns, const TableCells& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const TableColumn& column = columns[i];
    const std::string padding(column.width - std::min(column.width, letters(cells[i])), ' ');
    line.append(column.gap, ' ');
    line += column.right ? padding + cells[i] : cells[i] + padding;
  }
  return line + "\n";
}

/// Whether a column has numbers alone, perhaps with quartiles behind them, and one at least.
bool is_of_numbers(const std::vector<TableCells>& lines, std::size_t column) {
  const auto cells =
      mapped(std::span(lines).subspan(1), [column](const TableCells& line) { return line[column]; });
  const auto is_number = [](const std::string& cell) {
    return cell.find_first_not_of("0123456789+-.e() …") == std::string::npos;
  };
  return std::ranges::all_of(cells, is_number) &&
         std::ranges::any_of(cells, std::not_fn(&std::string::empty));
}

}  // namespace

TableForm named_table_form(const std::string& name) {
  const auto found = std::ranges::find(table_form_names, name);
  if (found == table_form_names.end())
    throw InputError(fmt::format("{}: must be one of {}", one_line(name), fmt::join(table_form_names, ", ")));
  return static_cast<TableForm>(found - table_form_names.begin());
}

std::string table_head(const std::vector<TableColumn>& columns, TableForm form) {
  const TableCells headings = mapped(columns, &TableColumn::heading);
  std::string line = table_line(columns, headings, form);
  if (form == TableForm::text) return line;
  if (form == TableForm::markdown)
    return line + markdown_line(mapped(columns, [](const TableColumn& column) {
             return std::string(column.right ? "---:" : "---");
           }));
  return fmt::format(
      "% needs \\usepackage{{booktabs}}\n\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\midrule\n",
      joined_texts(columns, [](const TableColumn& column) { return column.right ? "r" : "l"; }), line);
}

std::string table_line(const std::vector<TableColumn>& columns, const TableCells& cells, TableForm form) {
  if (form == TableForm::text) return text_line(columns, cells);
  const TableCells all = escaped(columns, cells, form);
  return form == TableForm::markdown ? markdown_line(all) : latex_line(all);
}

std::string table_foot(TableForm form) {
  return form == TableForm::latex ? "\\bottomrule\n\\end{tabular}\n" : "";
}

std::string table_text(const std::vector<TableCells>& lines, TableForm form) {
  std::vector<TableColumn> columns;
  for (std::size_t i = 0; i < lines.front().size(); ++i) {
    const std::size_t gap = i == 0 ? 0 : 2;
    TableColumn& column = columns.emplace_back(TableColumn{.heading = lines.front()[i], .gap = gap});
    if (form != TableForm::text) column.right = is_of_numbers(lines, i);
    for (const TableCells& line : lines) column.width = std::max(column.width, letters(line[i]));
  }
  std::string text = table_head(columns, form);
  for (std::size_t i = 1; i < lines.size(); ++i) text += table_line(columns, lines[i], form);
  text += table_foot(form);
  return form == TableForm::text ? std::regex_replace(text, std::regex(" +\n"), "\n") : text;
}

std::string markdown_cell(const std::string& text) {
  std::string cell;
  for (const char letter : text) {
    if (std::string_view("\\|*_`<[").find(letter) != std::string_view::npos) cell += '\\';
    cell += letter;
  }
  return cell;
}

std::string latex_cell(const std::string& text) {
  std::string cell;
  for (std::size_t at = 0; at < text.size();) {
    std::string read = latex_number(text, at);
    if (read.empty()) read = script(text, at, raised_letters, '^');
    if (read.empty()) read = script(text, at, lowered_letters, '_');
    if (read.empty()) {
      const std::string letter = letter_at(text, at);
      const auto found = latex_letters.find(letter);
      read = found != latex_letters.end() ? found->second : letter;
      at += letter.size();
    }
    cell += read;
  }
  return cell;
}

std::string markdown_line(const TableCells& cells) {
  return "|" + joined_texts(cells, [](const std::string& cell) { return " " + cell + " |"; }) + "\n";
}

}  // namespace rockstack
