#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/runs/job.hpp"

namespace rockstack {

/// True for a job that has more runs behind its numbers than the nominal one.
bool is_drawn(const Job& job);

/// Makes the draws of a job but the nominal one, `threads` at a time: an engine's runs at nearby steps of
/// scenes that hardly differ, each held against the exact solution of its own scene. None is timed. A draw
/// that fails has a row that says why; one that runs out of time or memory ends the set, and those after it
/// fail likewise.
std::vector<RunMetrics> make_draws(const Job& job, std::size_t threads);

/// Between draws and the text that a message or a file holds. @throws nlohmann::json::exception
std::string pack_draws(const std::vector<RunMetrics>& draws, const std::string& identity);

/// The draws in such a text, where they are of that identity.
std::optional<std::vector<RunMetrics>> unpack_draws(const std::string& text, const std::string& identity);

/// Writes draws.json and, for readers, draws.csv into a run's folder.
void write_draws(const std::string& packed, const RunMetrics& nominal, const std::filesystem::path& folder);

/// Puts medians over the nominal run and its draws in the place of the nominal row's numbers, with quartiles,
/// and says how many there were. A quantile is the value of a draw: that of rank ⌈q n⌉ of those that are done
/// and have one.
void summarise(const std::vector<RunMetrics>& draws, RunMetrics& nominal);

/// A line a run and quantity: run,quantity,draws,least,lower_quartile,median,upper_quartile,greatest, of
/// rows with their draws.
struct DrawnRow {
  RunMetrics nominal;
  std::vector<RunMetrics> draws;
};
std::string spread_csv(const std::vector<DrawnRow>& rows);

}  // namespace rockstack
