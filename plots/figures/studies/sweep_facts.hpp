#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "plots/figures/studies/initiation.hpp"

namespace rockstack::plots {

/// What figures of a sweep say beside their data.
struct SweepFacts {
  std::string title;
  std::string intensity;  ///< title of its axis
  /// Of a scene of one block, whose intensity is an acceleration: g tan α, m/s², and p, rad/s; else 0.
  double least_acceleration = 0, frequency_parameter = 0;
  std::optional<StruckBlock> struck = {};  ///< where a map over friction is of one under such pulses
};

/// From sweep.json. @throws InputError naming the file that is missing or malformed.
SweepFacts sweep_facts(const std::filesystem::path& results);

/// The title of an axis along which a scene's key varies, with its unit where the key has one.
std::string axis_title(const std::string& key);

/// A value with the words of its axis: "a peak ground acceleration of 4.8 m/s²".
std::string value_on(const std::string& axis, double value);

/// Room for a second axis along the upper edge of a panel, pixels.
inline constexpr double axis_above = 52;

/// A second axis, "x2" or "y2", opposite of "x" or "y" with its range, on which values are divided by `unit`;
/// nothing where that is 0.
std::string dimensionless_axis(const std::string& axis, double low, double high, double unit,
                               const std::string& words);

}  // namespace rockstack::plots
