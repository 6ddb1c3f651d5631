#include "plots/data/run_files.hpp"

#include <fmt/core.h>

#include <utility>

#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

template <class Read>
auto kept(const Run& run, const char* name, const Read& read) {
  return run.files ? run.files->get(run.folder / name, read) : KeptFiles().get(run.folder / name, read);
}

/// Nothing where the file is not there.
template <class List, class Read>
std::shared_ptr<const List> kept_list(const Run& run, const char* name, const Read& read) {
  return kept(run, name,
              [&](const auto& file) { return std::filesystem::exists(file) ? read(file) : List(); });
}

EnergyHistory read_energies(const std::filesystem::path& file) {
  auto columns = read_columns(file, {"time", "exact", "engine", "input", "balance"});
  return {std::move(columns[0]), std::move(columns[1]), std::move(columns[2]), std::move(columns[3]),
          std::move(columns[4])};
}

}  // namespace

std::shared_ptr<const History> history_of(const Run& run) {
  return kept(run, "history.csv", [&](const auto& file) { return read_history(file.parent_path()); });
}

std::shared_ptr<const std::vector<AlignedImpact>> impacts_of(const Run& run) {
  return kept_list<std::vector<AlignedImpact>>(run, "impacts.csv", read_impacts);
}

std::shared_ptr<const EnergyHistory> energies_of(const Run& run) {
  return kept(run, "energy.csv", read_energies);
}

std::shared_ptr<const std::vector<MotionTally>> tallies_of(const Run& run) {
  return kept_list<std::vector<MotionTally>>(run, "perturbed.csv", read_tallies);
}

std::vector<double> column_of(const History& history, std::vector<double> History::*rows, int block) {
  if (block >= history.blocks)
    throw InputError(fmt::format("history.csv: {} blocks; must be those of the scene", history.blocks));
  const std::vector<double>& all = history.*rows;
  std::vector<double> values;
  values.reserve(history.size());
  for (auto at = static_cast<std::size_t>(block); at < all.size();
       at += static_cast<std::size_t>(history.blocks))
    values.push_back(all[at]);
  return values;
}

}  // namespace rockstack::plots
