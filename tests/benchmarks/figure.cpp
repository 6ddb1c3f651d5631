#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "plots/drawing/gnuplot.hpp"
#include "tests/benchmarks/measurement.hpp"
#include "tests/benchmarks/tables.hpp"

namespace rockstack::benchmarks {
namespace {

struct MethodStyle {
  std::string_view method, colour;
  int mark;
};

/// Ours and the engines as in every other figure; other integrators in colours that no solver has.
constexpr std::array<MethodStyle, 10> styles{{{"taylor", "#000000", 7},
                                              {"rk4 with exact events", "#8A8A8A", 13},
                                              {"rk4 of the paper", "#5A5A5A", 9},
                                              {"odeint dopri5", "#CC0066", 11},
                                              {"odeint fehlberg78", "#5B8C00", 3},
                                              {"CVODE Adams", "#8A5AA8", 15},
                                              {"bullet", "#0072B2", 5},
                                              {"ode", "#C04A00", 7},
                                              {"box2d", "#8C2D04", 4},
                                              {"chipmunk", "#00695C", 6}}};

MethodStyle style_of(const std::string& method) {
  const auto found = std::find_if(styles.begin(), styles.end(),
                                  [&](const MethodStyle& style) { return style.method == method; });
  return found == styles.end() ? MethodStyle{method, "#000000", 1} : *found;
}

std::string block_name(std::size_t scene, std::size_t method) {
  return "$points_" + std::to_string(scene) + "_" + std::to_string(method);
}

}  // namespace

void draw(const std::vector<Measurement>& measurements, const std::filesystem::path& stem) {
  const auto scenes = distinct(measurements, &Measurement::scene);
  const auto methods = distinct(measurements, &Measurement::method);
  std::ostringstream data;
  std::ostringstream commands;
  commands
      << "set multiplot layout 2,2 margins 0.08,0.98,0.13,0.89 spacing 0.07,0.09\n"
         "set logscale xy\nset format xy '10^{%T}'\nset grid lc rgb '#E4E4E4'\n"
         "set yrange [1e-17:1]\nset ytics 1e-16,1e4\nset mytics 1\nset xrange [5e-6:5]\nset key at "
         "screen 0.53,0.005 center bottom maxrows 2 samplen 1.5 width -4 font ',12'\n"
         "set label 1 'What does accuracy cost, by which method?' at screen 0.53,0.97 center font ',17'\n";
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    commands << "set title '" << scenes[i] << "' noenhanced offset 0,-0.5\n"
             << (i >= 2 ? "set xlabel 'processor time (s)' offset 0,0.7\n" : "unset xlabel\n")
             << (i % 2 == 0 ? "set ylabel 'error (rad)' offset 1,0\n" : "unset ylabel\n")
             << (i + 1 == scenes.size() ? "set key\n" : "unset key\n") << "plot ";
    for (std::size_t j = 0; j < methods.size(); ++j) {
      data << block_name(i, j) << " << EOD\n";
      for (const Measurement& m : measurements)
        if (m.scene == scenes[i] && m.method == methods[j]) data << m.seconds << ' ' << m.error << '\n';
      data << "EOD\n";
      const MethodStyle style = style_of(methods[j]);
      commands << (j > 0 ? ", " : "") << block_name(i, j) << " using 1:2 with linespoints lw 2 pt "
               << style.mark << " ps 1.2*mark lc rgb '" << style.colour << "' title '" << methods[j] << "'";
    }
    commands << "\nunset label 1\n";
  }
  commands << "unset multiplot\n";
  plots::draw({1200, 900, data.str(), commands.str()}, stem);
}

}  // namespace rockstack::benchmarks
