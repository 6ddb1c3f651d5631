#pragma once

#include <map>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// What a question is about: a scene with its exact solution, where it has one, and numbers by name.
struct Asked {
  Scene scene;
  History history;
  std::map<std::string, double> numbers;
};

/// Solves a shipped scene with changes, with all that quantities need.
Asked asked_about(const std::string& scene, const std::vector<std::string>& changes);

/// A quantity by its name, as questions of lessons have them; the name of a number is that number.
/// @throws InputError for a name that is none, std::runtime_error where what is asked about never happens.
double quantity(const std::string& name, const Asked& asked);

/// All names, in order, besides those of numbers.
std::vector<std::string> quantity_names();

}  // namespace rockstack
