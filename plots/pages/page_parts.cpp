#include "plots/pages/page_parts.hpp"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "analytic/scene/messages/input_error.hpp"
#include "plots/drawing/style.hpp"
#include "plots/pages/html.hpp"
#include "plots/pages/player.hpp"
#include "plots/pages/template.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

std::string contents_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string() + ": cannot be read; figures are drawn before the report");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The number in a cell, or nothing where it is text.
std::optional<double> number_in(const std::string& cell) {
  try {
    std::size_t used = 0;
    const double value = std::stod(cell, &used);
    return used == cell.size() ? std::optional(value) : std::nullopt;
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
}

}  // namespace

std::string page(const PageParts& parts) {
  return filled_in(page_html,
                   {{"title", escaped(parts.title)},
                    {"kind", parts.kind},
                    {"css", std::string(page_css) + std::string(player_css) + std::string(lesson_css)},
                    {"js", std::string(page_js)},
                    {"player_js", std::string(player_js)},
                    {"content", parts.content}});
}

std::string sentence_list(const std::vector<std::string>& sentences) {
  std::string items;
  for (const std::string& sentence : sentences) items += element("li", escaped(sentence)) + "\n";
  return element("ul", items) + "\n";
}

std::string table(const std::vector<std::string>& columns, const std::string& rows) {
  std::string headings;
  for (const std::string& column : columns) headings += heading(column);
  return element("table", element("thead", element("tr", headings)) + element("tbody", "\n" + rows));
}

std::string table_row(const std::vector<std::string>& columns, const std::vector<std::string>& cells,
                      const std::string& attributes) {
  std::string row;
  for (std::size_t i = 0; i < columns.size(); ++i) row += table_cell(columns[i], cells[i]);
  return element("tr", row, attributes) + "\n";
}

std::string definition_list(const Facts& facts) {
  std::string items;
  for (const auto& [name, text] : facts)
    items += element("dt", escaped(name)) + element("dd", escaped(text)) + "\n";
  return element("dl", items);
}

std::string table_cell(const std::string& column, const std::string& cell) {
  const bool is_count = cell.find_first_not_of("0123456789") == std::string::npos;
  if (const std::optional<double> value = number_in(cell))
    return element("td", is_count ? cell : fmt::format("{:.4g}", *value),
                   fmt::format(" class=\"number\" data-value=\"{0}\" title=\"{0}\"", escaped(cell)));
  return element("td", escaped(cell), column == "reason" && !cell.empty() ? " class=\"reason\"" : "");
}

std::string heading(std::string column) {
  for (char& c : column)
    if (c == '_') c = ' ';
  return element("th", element("button", escaped(column), " type=\"button\""), " scope=\"col\"");
}

std::string drawn_figure(const fs::path& file, const std::string& prefix, const std::string& label,
                         const std::string& explanation) {
  return element("figure",
                 inline_svg(contents_of(file), prefix, label) + element("figcaption", escaped(explanation)));
}

std::string figure_part(const fs::path& results, const Comparison& comparison, std::size_t scene,
                        const FigureKind& kind) {
  const ComparedScene& compared = comparison.scenes[scene];
  return drawn_figure(fs::path(figure_stem(results, compared.name, kind.name)).concat(".svg"),
                      fmt::format("s{}-{}-", scene + 1, kind.name),
                      fmt::format("{}: {}", kind.title, compared.title), kind.explanation);
}

std::string player_part(const Comparison& comparison, std::size_t scene) {
  return player(comparison, comparison.scenes[scene], assign_styles(comparison.runs),
                comparison.scenes.size(), fmt::format("player-{}", scene + 1));
}

}  // namespace rockstack::plots
