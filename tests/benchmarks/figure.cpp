#include <algorithm>
#include <sstream>

#include "plots/drawing/gnuplot.hpp"
#include "tests/benchmarks/measurement.hpp"

namespace rockstack::benchmarks {
namespace {

/// Values in the order of their first appearance.
std::vector<std::string> distinct(const std::vector<Measurement>& measurements,
                                  std::string Measurement::*field) {
  std::vector<std::string> result;
  for (const Measurement& measurement : measurements)
    if (std::find(result.begin(), result.end(), measurement.*field) == result.end())
      result.push_back(measurement.*field);
  return result;
}

/// Colours of Okabe & Ito's palette, which the colour-blind tell apart; ours is black.
constexpr const char* colours[] = {"#000000", "#999999", "#D55E00", "#0072B2",
                                   "#009E73", "#E69F00", "#CC79A7"};

std::string block_name(std::size_t scene, std::size_t method) {
  return "$points_" + std::to_string(scene) + "_" + std::to_string(method);
}

}  // namespace

void draw(const std::vector<Measurement>& measurements, const std::filesystem::path& stem) {
  const auto scenes = distinct(measurements, &Measurement::scene);
  const auto methods = distinct(measurements, &Measurement::method);
  std::ostringstream data;
  std::ostringstream commands;
  commands << "set multiplot layout 2,2 margins 0.08,0.98,0.13,0.96 spacing 0.07,0.09\n"
              "set logscale xy\nset format xy '10^{%T}'\nset grid lc rgb '#E4E4E4'\n"
              "set yrange [1e-17:1]\nset ytics 1e-16,1e4\nset mytics 1\nset xrange [1e-5:20]\nset key at "
              "screen 0.53,0.005 center bottom maxrows 2 samplen 1.5 width -1 font ',12'\n";
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
      commands << (j > 0 ? ", " : "") << block_name(i, j) << " using 1:2 with linespoints lw 2 pt " << j + 4
               << " ps 1.2*mark lc rgb '" << colours[j % std::size(colours)] << "' title '" << methods[j]
               << "'";
    }
    commands << '\n';
  }
  commands << "unset multiplot\n";
  plots::draw({1200, 900, data.str(), commands.str()}, stem);
}

}  // namespace rockstack::benchmarks
