#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

#include "comparisons/interfaces/program/commands.hpp"

namespace rockstack {

/// A subcommand with what it does once its options are read.
struct Command {
  CLI::App* app;
  std::function<int()> run;
};

/// Adds every subcommand with its options to the program, which must outlive what is returned.
std::vector<Command> add_commands(CLI::App& app, const Common& common);

}  // namespace rockstack
