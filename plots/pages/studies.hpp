#pragma once

#include <filesystem>

namespace rockstack::plots {

// Pages of what is neither a comparison nor a lesson: results/report.html with the answer in a sentence,
// every figure of the folder, its short tables and links to all of them. Each page needs nothing beside
// itself, and appears whole or not at all. All throw InputError naming the file that is missing or malformed,
// and std::runtime_error where the page cannot be written.

/// From sweep.json, runs.csv and the summaries that are there.
void write_sweep_report(const std::filesystem::path& results);

/// From stability.json, stability.csv and steps.csv.
void write_stability_report(const std::filesystem::path& results);

/// From record.json.
void write_record_report(const std::filesystem::path& results);

}  // namespace rockstack::plots
