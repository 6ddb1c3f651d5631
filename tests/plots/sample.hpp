#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// One engine of a made-up comparison: it runs late by a little more at each impact, the more so at larger
/// steps.
struct SampleEngine {
  std::string engine, solver, settings;
  double lateness;  ///< s for each impact and each millisecond of time step
};

/// What a made-up results folder holds. Nothing is solved: decaying zigzags stand for rocking.
struct Sample {
  std::string title = "A made-up scene";
  int blocks = 2;
  int impacts = 9;
  int draws = 1;  ///< replicates that a row is the median of
  std::vector<SampleEngine> engines{{"bullet", "sequential-impulse", "tuned", 2e-3}};
  std::vector<double> steps{1e-2, 1e-3};  ///< s
  bool failed_row = false;
  double predictable_time = 5;  ///< s, of 5
  double rests_from = 5;        ///< s; angles stay what they are there
  bool shaken = false;          ///< whether the ground moves, along both axes
  bool tested = false;          ///< whether a point was measured
  double readings = 0.1;        ///< s, between them
  bool slides = false;          ///< whether blocks slip, fly and land
  Law law = Law::unilateral;    ///< of blocks that slide, or `compliant`
  std::vector<std::string> results{"angles", "impacts", "patterns", "bodies",
                                   "histories"};  ///< what was computed
  std::string distributions = "[]";               ///< over perturbed scenes, as JSON
  std::string fits = "[]";                        ///< of the errors over time steps, likewise
};

/// Writes the sample as `rockstack compare` would, scene name "sample".
void write_sample(const std::filesystem::path& folder, const Sample& sample);

/// An empty folder for the running test, or for all of its suite.
std::filesystem::path fresh_folder();

/// The bytes of a file.
std::string bytes_of(const std::filesystem::path& file);

}  // namespace rockstack::testing
