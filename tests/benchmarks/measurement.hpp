#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rockstack::benchmarks {

/// One method at one setting on one scene.
struct Measurement {
  std::string scene, method;
  double setting;  ///< tolerance, or step in s
  double error;    ///< rad
  double seconds;  ///< processor time of the whole scene
};

/// Error over time, a panel a scene and a line a method: `stem`.png and `stem`.svg.
void draw(const std::vector<Measurement>& measurements, const std::filesystem::path& stem);

}  // namespace rockstack::benchmarks
