#pragma once

#include "comparisons/measures/metrics/run_outcome.hpp"
#include "comparisons/studies/sweep/sweep.hpp"
#include "comparisons/suites/varied_key.hpp"

namespace rockstack {

/// What a motion may come to.
struct ThresholdOutcome {
  std::string happens, otherwise;  ///< "topples", "stands"
  std::function<bool(const RunOutcome&)> of;
};

/// "topples": a block topples or falls off, or is past balance at the end and turns on; "lifts": an interface
/// opens; or COLUMN>VALUE of a column of numbers that a sweep's runs.csv has, such as "peak_ratio>0.5" or
/// "slip>0.01". @throws InputError with what is allowed.
ThresholdOutcome outcome_named(const std::string& text, std::size_t blocks);

struct ThresholdRequest {
  VariedKey vary;
  ThresholdOutcome outcome;
  std::size_t values = 200;  ///< tried at equal distances before thresholds are closed in on, 2 at least
};

/// A value of the key, and what becomes of it.
struct TriedValue {
  double value = 0;
  std::optional<RunOutcome> outcome;  ///< empty where the scene is out of range or cannot be solved
  std::string reason = {};            ///< then why
};

/// Neighbouring values with one outcome, up to the last that was found to have it.
struct OutcomeRange {
  double from = 0, to = 0;
  bool happens = false;
};

/// What was tried, and the ranges that came of it, both rising.
struct Threshold {
  std::vector<TriedValue> tried;
  std::vector<OutcomeRange> ranges;  ///< values that failed lie in none

  /// The least value found at which the outcome happens; none where it happens at the range's lower end.
  std::optional<double> first() const;
};

/// Tries values at equal distances, since toppling is not monotone, and between neighbours that differ closes
/// in on the first change to twelve digits of the value. Ranges narrower than the distance may be missed.
/// @throws InputError where the scene has no place for the key, or none of the values has a motion, with the
/// reason of the first.
Threshold threshold(const SceneDocument& document, const ThresholdRequest& request, MotionLibrary& library);

/// The first threshold for each value of a second key: an overturning spectrum where that is a pulse's period
/// or a block's size.
struct ThresholdSpectrum {
  VariedKey over;
  std::vector<double> values;
  std::vector<Threshold> thresholds;  ///< of each value
};

/// For so many values of the second key, at equal distances. @throws InputError as threshold().
ThresholdSpectrum threshold_spectrum(const SceneDocument& document, const ThresholdRequest& request,
                                     const VariedKey& over, std::size_t values, MotionLibrary& library,
                                     const std::function<void(std::size_t done)>& progress);

/// What was found, in sentences.
std::vector<std::string> threshold_headline(const ThresholdRequest& request, const Threshold& found);

/// Writes FOLDER/threshold.csv, a line a value that was tried at equal distances, threshold-ranges.csv and,
/// of a spectrum, threshold-spectrum.csv; and FOLDER/threshold.json. @returns that.
Json write_threshold(const std::string& title, const ThresholdRequest& request, const Threshold& found,
                     const ThresholdSpectrum* spectrum, const std::filesystem::path& folder,
                     const std::string& command);

}  // namespace rockstack
