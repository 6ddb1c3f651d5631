#pragma once

#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "tests/benchmarks/measurement.hpp"

namespace rockstack::benchmarks {

/// Values of a field in the order of their first appearance.
std::vector<std::string> distinct(const std::vector<Measurement>& measurements,
                                  std::string Measurement::*field);

/// The time in which a method errs by no more than `error`, s: between its settings by straight lines of
/// logarithms, along those settings that no faster one betters; none where it does not get there.
std::optional<double> seconds_at(const std::vector<Measurement>& measurements, const std::string& scene,
                                 const std::string& method, double error);

/// A line a measurement, apart by tabulators.
void write_columns(const std::vector<Measurement>& measurements, std::ostream& out);

/// As CSV, a row a scene and error: the time of the first method there, ms, and how many times as long others
/// take, "-" where one does not get there.
void write_equal_errors(const std::vector<Measurement>& measurements, std::span<const double> errors,
                        std::ostream& out);

}  // namespace rockstack::benchmarks
