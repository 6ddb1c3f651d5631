#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "engines/setup.hpp"

namespace rockstack {

/// Every number that shapes an engine run, by the engine's own name for it; written into the results as it
/// is.
using Parameters = std::map<std::string, double>;

/// One setting of an engine: its own name for it, what the engine starts with, what suits rocking blocks
/// best, and the range an adapter takes.
struct Setting {
  std::string name = {};
  std::string unit = {};                  ///< as "N/m"; empty for a number alone
  std::vector<std::string> choices = {};  ///< names of 0, 1, … where the number stands for a choice
  double standard = 0;
  double tuned = standard;
  double least = 0;
  double most =
      choices.empty() ? std::numeric_limits<double>::infinity() : static_cast<double>(choices.size()) - 1;
  bool whole = !choices.empty();  ///< only whole numbers
};

/// A setting that is off, 0, or on, 1.
Setting switch_setting(std::string name, bool standard, bool tuned);

/// How an engine is shaken: "force", the ground's acceleration as a body force in its own frame, or "ground",
/// a ground that really moves and takes the blocks along.
Setting shaking_setting();

/// The number of a choice's name. @throws std::invalid_argument naming the choices.
double choice_value(const std::string& engine, const Setting& setting, const std::string& choice);

/// By what an adapter multiplies every mass, on which no angle depends: 1, or with the setting unitMass
/// what gives the stack that mass, kg, so that cfm, contact forces and limits of impulses mean the same for
/// grams and tonnes.
double mass_factor(const Setup& setup, const Parameters& parameters);

Parameters standard_values(const std::vector<Setting>& settings);
Parameters tuned_values(const std::vector<Setting>& settings);

/// The setting of that name. @throws std::invalid_argument naming the engine, the setting and those that
/// there are.
const Setting& find_setting(const std::string& engine, const std::vector<Setting>& settings,
                            const std::string& name);

/// Checks one value. @throws std::invalid_argument naming the engine, the setting, its value and what is
/// allowed: unknown or out of range.
void check_value(const std::string& engine, const std::vector<Setting>& settings, const std::string& name,
                 double value);

/// Checks what Engine::start was given.
/// @throws std::invalid_argument as above, or for one that is missing.
void check(const std::string& engine, const std::vector<Setting>& settings, const Parameters& given);

}  // namespace rockstack
