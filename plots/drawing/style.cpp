#include "plots/drawing/style.hpp"

#include <fmt/core.h>

#include <cstdlib>

namespace rockstack::plots {
namespace {

struct NamedStyle {
  std::string_view solver;
  std::string_view colour;
  int mark;  ///< with the inside left open; the filled one is the next
  std::string_view dash;
};

constexpr int plus = 1, cross = 2, star = 3, square = 4, circle = 6, triangle = 8, triangle_down = 10,
              diamond = 12, pentagon = 14;

// Colours that keep apart under any form of colour blindness, after Okabe & Ito (2008) and Tol (2021), each
// with a contrast of 4.5 on white at least. A solver in single precision has the colour of its double twin
// and another mark. Gaps are wide because the line's round ends reach into them.
constexpr std::array<NamedStyle, 28> named{{
    {"exact", "#000000", circle, "solid"},
    {"linear:taylor", "#AA4499", diamond, "(12,9)"},
    {"nonlinear:taylor", "#AA4499", triangle, "(12,9)"},
    {"paper:taylor", "#AA4499", diamond, "(12,9)"},
    {"consistent:taylor", "#AA4499", triangle, "(5,8)"},
    {"unilateral:taylor", "#AA4499", circle, "(12,8,1,8)"},
    {"bullet:sequential-impulse", "#0072B2", square, "solid"},
    {"bullet:nncg", "#332288", diamond, "(12,9)"},
    {"bullet:mlcp-dantzig", "#117733", triangle, "(8,7,1,7)"},
    {"bullet:mlcp-lemke", "#882255", triangle_down, "(5,8)"},
    {"bullet:mlcp-pgs", "#AA4499", pentagon, "(12,8,1,8)"},
    {"bullet-single:sequential-impulse", "#0072B2", circle, "(12,9)"},
    {"bullet-single:nncg", "#332288", square, "(5,8)"},
    {"bullet-single:mlcp-dantzig", "#117733", diamond, "(12,9)"},
    {"bullet-single:mlcp-lemke", "#882255", pentagon, "(12,9)"},
    {"bullet-single:mlcp-pgs", "#AA4499", triangle, "(5,8)"},
    {"ode:step", "#C04A00", circle, "solid"},
    {"ode:quickstep", "#806600", pentagon, "(12,9)"},
    {"box2d:sequential-impulse", "#8C2D04", square, "(8,7,1,7)"},
    {"chipmunk:sequential-impulse", "#00695C", circle, "(12,8,1,8)"},
    {"dart:dantzig", "#6A1B9A", triangle, "solid"},
    {"dart:pgs", "#6A1B9A", diamond, "(5,8)"},
    {"mujoco:newton", "#B00020", circle, "solid"},
    {"mujoco:cg", "#B00020", square, "(12,9)"},
    {"mujoco:pgs", "#B00020", triangle_down, "(5,8)"},
    {"siconos:nsgs", "#4B5320", diamond, "(8,7,1,7)"},
    {"simbody:compliant", "#00566B", pentagon, "(12,8,1,8)"},
    {"measured", "#C2187A", cross, "(1,6)"},
}};

/// A number that a text always gives (Fowler, Noll & Vo's FNV-1a, 32 bits).
std::size_t number_of(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash >> 4U;
}

/// Styles of the exact motion with a friction of its own, from that coefficient on: the slipperier, the
/// redder.
constexpr std::array<std::pair<double, NamedStyle>, 5> frictions{
    {{1, {"", "#0072B2", square, "solid"}},
     {0.45, {"", "#117733", triangle, "(12,9)"}},
     {0.25, {"", "#C04A00", circle, "(8,7,1,7)"}},
     {0.12, {"", "#882255", diamond, "(5,8)"}},
     {0, {"", "#332288", pentagon, "(12,8,1,8)"}}}};

NamedStyle of_friction(const std::string& solver) {
  const double value = std::strtod(solver.c_str() + solver.find('=') + 1, nullptr);
  return std::find_if(frictions.begin(), frictions.end() - 1,
                      [&](const auto& one) { return value >= one.first; })
      ->second;
}

}  // namespace

Style style_of(const Run& run) {
  const std::string solver = run.solver_name();
  const auto found = std::ranges::find(named, solver, &NamedStyle::solver);
  const NamedStyle own = run.has_own_friction() ? of_friction(solver)
                         : found != named.end() ? *found
                                                : named.at(1 + number_of(solver) % (named.size() - 2));
  Style style{std::string(own.colour), own.mark + 1, std::string(own.dash)};
  if (run.settings == "default") {
    style.mark = own.mark;
    style.dash = "(1,6)";
  } else if (run.settings.find('+') != std::string::npos) {
    constexpr std::array marks{star, cross, plus};
    constexpr std::array dashes{"(10,7)", "(4,4)", "(12,4,1,4)"};
    const std::size_t number = number_of(run.settings);
    style.mark = marks.at(number % marks.size());
    style.dash = dashes.at(number / marks.size() % dashes.size());
  }
  return style;
}

std::string paler(const std::string& colour, double strength) {
  constexpr int white = 255, base = 16;
  std::string text = "#";
  for (const std::size_t at : {1U, 3U, 5U}) {
    const int own = std::stoi(colour.substr(at, 2), nullptr, base);
    text += fmt::format("{:02X}", static_cast<int>(std::lround(white + (own - white) * strength)));
  }
  return text;
}

std::string curve_style(const Run& run, std::size_t order) {
  if (run.exact()) return exact_style;
  const Style style = style_of(run);
  return fmt::format("with linespoints lw 2 lc rgb '{}' dt {} pt {} ps 1.1*mark pn {}", style.colour,
                     style.dash, style.mark, 6 + order);
}

std::string mark_style(const Run& run, double size) {
  const Style style = style_of(run);
  return fmt::format("with points lw 2 lc rgb '{}' pt {} ps {:.2f}*mark", style.colour, style.mark, size);
}

std::string floor_plot(const StepFit& fit, const std::string& colour) {
  return fmt::format("{} with lines lw 1.5 dt {} lc rgb '{}' notitle", fit.model_error.value,
                     fit.model_error.low > 0 ? "(8,8)" : "(1,9)", colour);
}

}  // namespace rockstack::plots
