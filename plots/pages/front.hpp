#pragma once

#include <optional>

#include "analytic/scene/history.hpp"
#include "analytic/scene/input/json.hpp"
#include "analytic/scene/scene.hpp"
#include "plots/data/results.hpp"

namespace rockstack::plots {

/// Motion of an engine at one of the steps that the slider has; without one, why.
struct FrontRun {
  History history;
  std::string failure;
};

struct FrontEngine {
  std::string name, version;
  std::string settings;        ///< "default" or "tuned"
  Json parameters;             ///< by which the page runs an engine of this name that it holds
  std::vector<FrontRun> runs;  ///< one a step
};

/// What the front page shows of one scene.
struct FrontPage {
  const Scene& scene;
  std::string text;  ///< the scene on a page, as page_text()
  std::string command;
  History exact;              ///< with its events
  std::vector<double> steps;  ///< time steps of engines, s, from coarse to fine
  std::vector<FrontEngine> engines;
  double tolerance = 0.01;  ///< up to which motions agree, rad
};

/// Writes the page that shows a stack as the exact solver and engines move it; where the build can solve in a
/// page, it may be dragged there. It needs nothing beside itself.
/// @throws std::runtime_error where the file cannot be written.
void write_front(const fs::path& file, const FrontPage& page);

}  // namespace rockstack::plots
