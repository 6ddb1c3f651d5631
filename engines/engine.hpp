#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "engines/simulation.hpp"

namespace rockstack {

/// Every number that shapes an engine run, by the engine's own name; written into the results as it is.
using Parameters = std::map<std::string, double>;

/// What of a scene a setting is given the value of.
enum class SettingRole {
  own,                    ///< nothing
  restitution,            ///< Newton's coefficient of contact points
  restitution_threshold,  ///< the speed below which nothing bounces: the least that it takes, where points do
};

/// One setting of an engine: its own name, its value by default, and tuned to rocking blocks, and its range.
struct Setting {
  std::string name = {};
  std::string unit = {};                  ///< as "N/m"; empty for a number alone
  std::vector<std::string> choices = {};  ///< names of 0, 1, … where the number stands for a choice
  double default_value = 0;
  double tuned = default_value;
  double least = 0;
  double most =
      choices.empty() ? std::numeric_limits<double>::infinity() : static_cast<double>(choices.size()) - 1;
  bool whole = !choices.empty();  ///< only whole numbers
  SettingRole role = SettingRole::own;

  bool allows(double value) const {
    return value >= least && value <= most && (!whole || value == std::floor(value));
  }
};

/// N/m or N s/m: far beyond what a step resolves, and finite, as stiffness and damping are divided.
inline constexpr double stiffest = 1e18;

/// A setting that is off, 0 or false, or on, 1 or true.
Setting switch_setting(std::string name, double default_value, double tuned);

/// A setting that counts, from 1 to a million.
Setting count_setting(std::string name, double default_value, double tuned);

/// How an engine is shaken: "force", the ground's acceleration as a body force in its own frame, or "ground",
/// a ground that really moves and takes the blocks along.
Setting shaking_setting();

/// The number of a choice's name. @throws std::invalid_argument naming the choices.
double choice_value(const std::string& engine, const Setting& setting, const std::string& choice);

/// By what an adapter multiplies every mass, on which no angle depends: 1, or with the setting unitMass what
/// gives the stack that mass, kg: cfm, forces and limits of impulses mean the same for grams and tonnes.
double mass_factor(const Setup& setup, const Parameters& parameters);

/// Values of a set: &Setting::default_value or &Setting::tuned.
Parameters values_of(const std::vector<Setting>& settings, double Setting::*set);

/// The setting of that name. @throws std::invalid_argument naming the engine, the setting and all there are.
const Setting& find_setting(const std::string& engine, const std::vector<Setting>& settings,
                            const std::string& name);

/// Checks one value. @throws std::invalid_argument naming engine, setting, value and what is allowed.
void check_value(const std::string& engine, const std::vector<Setting>& settings, const std::string& name,
                 double value);

/// Checks what Engine::start was given. @throws std::invalid_argument as above, or for one that is missing.
void check(const std::string& engine, const std::vector<Setting>& settings, const Parameters& given);

/// What an engine is able to do, and by which rules it is to be judged.
struct Capabilities {
  /// The coefficient of friction that acts where a scene asks for more.
  double largest_friction = std::numeric_limits<double>::infinity();
  bool kinetic_friction = false;  ///< it has a second coefficient, of what slides; else that which sticks
  bool wall = false;              ///< it can have one beside the blocks; else scenes with one are refused
  bool applied_forces = false;    ///< it takes pushes and restraints; else scenes with them are refused
  bool single_precision = false;
  bool planar = false;          ///< by nature; else constraints or corrections hold its bodies in the plane
  bool center_of_mass = false;  ///< its bodies may have it off the middle of their boxes
  /// How many steps places are ahead under a constant force: ½ for semi-implicit Euler, 0 of higher order.
  double lead = 0.5;
  double tuned_lead = lead;  ///< with the tuned set, where the number of substeps is a setting
};

/// Who a physics engine with one of its constraint solvers is.
struct EngineDescription {
  std::string name = {};     ///< "bullet", "bullet-single", "ode"
  std::string solver = {};   ///< "sequential-impulse", "step", …
  std::string version = {};  ///< of the library in use, e.g. "3.24, double precision"
  std::string licence = {};  ///< of the library in use, by its SPDX name
  Capabilities capabilities = {};
  /// Steps that its runtime takes until they are as fast as they get; a worker takes so many before it times
  /// any. 0: the first is no slower than the last.
  std::size_t warm_up = 0;
  /// How many runs a process of its worker answers, one after the other, each as if it was the first.
  std::size_t runs_per_process = 1;
  /// Every setting, with its value in either set: `default_value` is what a user gets who sets nothing but
  /// friction and restitution, `tuned` suits this problem best; the adapter's head says why.
  std::vector<Setting> settings = {};

  std::string full_name() const { return name + ":" + solver; }
  Parameters default_parameters() const { return values_of(settings, &Setting::default_value); }
  Parameters tuned_parameters() const { return values_of(settings, &Setting::tuned); }
};

/// An engine inside this process: what worker programs run (engines/worker) and tests look into.
struct Engine : EngineDescription {
  /// Builds a scene anew, with parameters that are checked.
  std::function<std::unique_ptr<Simulation>(const Setup&, const Parameters&)> build = {};

  /// Checks the parameters, then builds. `parameters` holds exactly the keys of default_parameters().
  /// @throws std::invalid_argument for an unknown or missing parameter, or one out of range.
  std::unique_ptr<Simulation> start(const Setup& setup, const Parameters& parameters) const {
    check(name, settings, parameters);
    return build(setup, parameters);
  }
};

}  // namespace rockstack
