#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"
#include "comparisons/interfaces/program/arguments.hpp"
#include "comparisons/measures/metrics/motion_verdict.hpp"
#include "comparisons/runs/compare.hpp"
#include "comparisons/studies/impact_laws/study.hpp"
#include "comparisons/studies/sweep/sweep.hpp"

namespace rockstack {

// What the program says on standard output; progress goes to standard error, and only to a terminal.

/// A word as a shell reads it back.
std::string shell_word(const std::string& word);

/// A line that counts runs, names the one that is made and says how long the rest may take.
std::function<void(const Progress&)> progress(const Common& common);

/// Takes that line away, so that something else can be printed there.
void clear_progress(const Common& common);

/// A line that counts runs done and says how long the rest will take.
std::function<void(std::size_t, std::size_t, std::size_t)> sweep_progress(const Common& common);

/// How far a sweep came that was stopped, and how to go on; on standard error.
void print_stopped(const SweepResult& result, const Common& common);

/// Runs done, and where the results are.
void print_sweep(const SweepResult& result, const std::filesystem::path& folder, const Common& common);

/// The verdict on a motion, its events by kind, peak angles, warnings, and where the files are.
void print_history(const Scene& scene, const History& history, const Support& support,
                   const std::filesystem::path& folder, const Common& common);

/// Shares by kind of impact, and what the engines follow.
void print_impact_laws(const ImpactLawResults& results, const std::filesystem::path& folder,
                       const Common& common);

/// Says on standard error how many runs failed, and which file says why. Returns the exit code.
int end_of_runs(std::size_t failed, std::size_t runs, const char* file);

/// Where figures and report are.
void print_report(const std::filesystem::path& folder, const Common& common);

/// Draws the figures and the report of a folder, as far as this build can, and says where they are.
void show_report(const std::filesystem::path& folder, const Common& common);

/// The program's name and version.
std::string version_text();

}  // namespace rockstack
