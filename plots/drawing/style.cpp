#include "plots/drawing/style.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace rockstack::plots {
namespace {

struct NamedStyle {
  std::string_view solver;
  std::string_view colour;
  int mark;
  std::string_view dash;
};

constexpr int plus = 1, cross = 2, star = 3, square = 4, circle = 6, triangle = 8, triangle_down = 10,
              diamond = 12, pentagon = 14;

// The colours of Okabe and Ito (2008), told apart by people with any form of colour blindness.
// Gaps are wide because the line's round ends reach into them.
constexpr std::array<NamedStyle, 8> own{{
    {"exact", "#000000", circle, "solid"},
    {"bullet:sequential-impulse", "#0072B2", square, "solid"},
    {"bullet:nncg", "#56B4E9", diamond, "(12,9)"},
    {"bullet:mlcp-dantzig", "#009E73", triangle, "(8,7,1,7)"},
    {"bullet:mlcp-lemke", "#8B5E3C", square, "(5,8)"},
    {"bullet:mlcp-pgs", "#CC79A7", triangle_down, "(1,6)"},
    {"ode:step", "#D55E00", circle, "solid"},
    {"ode:quickstep", "#E69F00", pentagon, "(12,9)"},
}};

constexpr std::array<NamedStyle, 6> spare{{
    {"", "#CC79A7", triangle_down, "(12,8,1,8)"},
    {"", "#009E73", pentagon, "(5,8)"},
    {"", "#56B4E9", triangle, "(1,6)"},
    {"", "#E69F00", diamond, "(8,7,1,7)"},
    {"", "#0072B2", circle, "(1,6)"},
    {"", "#D55E00", square, "(8,7,1,7)"},
}};

constexpr std::array<std::string_view, 9> tints{"#DCE9F5", "#FBE3C4", "#D5EFE3", "#F4D9E6", "#EFEBC0",
                                                "#E3DDF3", "#E2E2E2", "#F7D3C5", "#CDE6EC"};

Style style_from(const NamedStyle& named) {
  return {std::string(named.colour), named.mark, std::string(named.dash)};
}

/// What tells settings in which single parameters differ from their set.
template <class Kind, std::size_t count>
Kind by_turns(const Style& style, const std::string& settings, const std::array<Kind, count>& kinds) {
  const auto place = std::find(style.changed.begin(), style.changed.end(), settings) - style.changed.begin();
  return kinds[static_cast<std::size_t>(place) % count];
}

bool has_changes(const std::string& settings) {
  return settings.find('+') != std::string::npos;
}

}  // namespace

Styles assign_styles(const std::vector<Run>& runs) {
  Styles styles;
  for (const NamedStyle& named : own) styles[std::string(named.solver)] = style_from(named);
  std::size_t next = 0;
  for (const Run& run : runs)
    if (!styles.contains(solver_name(run)))
      styles[solver_name(run)] = style_from(spare[next++ % spare.size()]);
  for (const Run& run : runs) {
    std::vector<std::string>& changed = styles[solver_name(run)].changed;
    if (has_changes(run.settings) && std::find(changed.begin(), changed.end(), run.settings) == changed.end())
      changed.push_back(run.settings);
  }
  return styles;
}

std::string pattern_tint(std::size_t index) {
  return std::string(tints[index % tints.size()]);
}

std::string curve_style(const Styles& styles, const Run& run, std::size_t order) {
  if (run.exact()) return exact_style;
  const Style& style = styles.at(solver_name(run));
  const bool changed = has_changes(run.settings);
  return fmt::format("with linespoints lw 2 lc rgb '{}' dt {} pt {} ps 1.1*mark pn {}", style.colour,
                     changed ? dash_of(style, run.settings, style.dash) : style.dash,
                     changed ? mark_of(style, run.settings) : style.mark, 6 + order);
}

std::string floor_line(const Fit& fit, const std::string& colour) {
  if (!(fit.model_error > 0)) return "";
  return fmt::format(
      "set arrow from graph 0, first {0:.8g} to graph 1, first {0:.8g} nohead lw 1.5 dt {1} lc rgb '{2}' "
      "back\n",
      fit.model_error, fit.model_error_low > 0 ? "(8,8)" : "(1,9)", colour);
}

int mark_of(const Style& style, const std::string& settings) {
  if (settings == "default") return style.mark;
  return has_changes(settings) ? by_turns(style, settings, std::array{star, cross, plus}) : style.mark + 1;
}

std::string dash_of(const Style& style, const std::string& settings, const std::string& whole) {
  if (settings == "default") return "(1,6)";
  return has_changes(settings) ? by_turns(style, settings, std::array{"(10,7)", "(4,4)", "(12,4,1,4)"})
                               : whole;
}

std::string mark_style(const Style& style, bool filled, double size) {
  return fmt::format("with points lw 2 lc rgb '{}' pt {} ps {:.2f}*mark", style.colour,
                     style.mark + (filled ? 1 : 0), size);
}

}  // namespace rockstack::plots
