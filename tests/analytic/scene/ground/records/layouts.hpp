#pragma once

#include <string>
#include <vector>

#include "analytic/scene/ground/records/record_file.hpp"

namespace rockstack {

inline constexpr double g = 9.80665;  // m/s², by definition
inline constexpr double gal = 0.01;   // m/s²

/// Made-up samples with at most three decimals, from -0.9 to 0.9, so that each layout can write them exactly.
std::vector<double> made_up_samples(std::size_t count = 19);

/// Values as fixed columns, "%10.5f" and the like, so many a line.
std::string in_columns(const std::vector<double>& values, const char* format, std::size_t per_line);

/// Small files of made-up content, one a layout; counts and time steps can be spoilt by the argument.
std::string peer_text(const std::vector<double>& samples, const std::string& npts = "19",
                      const std::string& interval = "0.005");
std::string cosmos_channel(const std::vector<double>& samples, const std::string& quantity = "acceleration",
                           const std::string& units = "cm/sec2(04)");
std::string volume2_channel(const std::vector<double>& samples);
std::string smc_text(const std::vector<double>& samples,
                     const std::string& title = "2 CORRECTED ACCELEROGRAM");
std::string esm_text(const std::vector<double>& samples, const std::string& units = "cm/s^2");
/// One component, its samples in mm/s², with as many values of velocity.
std::string geonet_component(const std::vector<double>& samples);
/// Counts are 1000 times the samples plus 7; 1000 counts are 1 gal.
std::string knet_text(const std::vector<double>& samples);
std::string one_column_text(const std::vector<double>& samples);
std::string two_column_text(const std::vector<double>& samples, double interval);

/// A text with its n-th line (from 1) put in place of another, or taken out where there is no replacement.
std::string with_line(const std::string& text, std::size_t number, const std::string& replacement);
std::string without_line(const std::string& text, std::size_t number);
/// A text with the first place of `from` turned into `to`. Fails loudly where there is none.
std::string with(const std::string& text, const std::string& from, const std::string& to);
std::string with_windows_line_ends(const std::string& text);

/// The only series in a text under the name "file".
Record read_text(const std::string& text);
/// The line of the InputError that a text gives, empty where it gives none.
std::string error_of_text(const std::string& text);

}  // namespace rockstack
