#pragma once

#include "comparisons/interfaces/program/commands.hpp"

namespace rockstack {

/// Arguments of `rockstack live`.
struct LiveArguments {
  std::string input = "spanos-free-rocking";   ///< scene, lesson, folder of lessons, or a page's link
  std::vector<std::filesystem::path> records;  ///< that the page may choose
  int port = 0;                                ///< 0: any that is free
  bool browser = true;                         ///< is opened where there is one
};

/// Serves the page until the program is ended. The library of the web makes a start of every program that is
/// linked with it dear, so that a program of its own serves, which this one becomes.
int serve_live(const LiveArguments& arguments, const Common& common);

}  // namespace rockstack
