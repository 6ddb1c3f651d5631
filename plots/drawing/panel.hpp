#pragma once

#include "plots/drawing/gnuplot.hpp"

namespace rockstack::plots {

/// One entry of a legend: a gnuplot style ("with lines …") and its words.
using Legend = std::vector<std::pair<std::string, std::string>>;

/// One of the panels that stand side by side; settings and plots as of Sheet::panel().
struct SidePanel {
  std::string settings;
  std::vector<std::string> plots;
};

}  // namespace rockstack::plots
