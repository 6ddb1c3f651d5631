#include "plots/data/run_files.hpp"

#include <fmt/core.h>

#include "comparisons/measures/results/csv.hpp"

namespace rockstack::plots {
namespace {

template <class Read>
auto kept(const Run& run, const fs::path& file, const Read& read) {
  return run.files ? run.files->get(file, read) : KeptFiles().get(file, read);
}

/// Nothing where the file is not there.
template <class Read>
auto kept_list(const Run& run, const fs::path& path, const Read& read) {
  return kept(run, path,
              [&](const auto& file) { return fs::exists(file) ? read(file) : decltype(read(file))(); });
}

/// The sample nearest before a time. Precondition: times rise and are not empty.
double at(const std::vector<double>& times, const std::vector<double>& values, double time) {
  const auto after = std::ranges::upper_bound(times, time);
  return values[after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1];
}

}  // namespace

std::shared_ptr<const History> history_of(const Run& run) {
  return kept(run, run.shown_folder() / "history.csv",
              [&](const auto& file) { return read_history(file.parent_path()); });
}

std::shared_ptr<const std::vector<AlignedImpact>> impacts_of(const Run& run) {
  return kept_list(run, run.shown_folder() / "impacts.csv", read_impacts);
}

std::shared_ptr<const EnergyHistory> energies_of(const Run& run) {
  return kept(run, run.shown_folder() / "energy.csv", [](const auto& file) {
    const auto columns = read_columns(file, {"time", "exact", "engine", "input", "balance"});
    return EnergyHistory{columns[0], columns[1], columns[2], columns[3], columns[4]};
  });
}

std::shared_ptr<const std::vector<MotionTally>> tallies_of(const Run& run) {
  return kept_list(run, run.folder / "perturbed.csv", read_tallies);
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

std::vector<double> impact_times(const History& history, int interface) {
  std::vector<double> times;
  for (const Event& event : history.events)
    if (event.kind == EventKind::impact && event.interface == interface) times.push_back(event.time);
  return times;
}

std::vector<ImpactLoss> impact_losses(const Run& run) {
  const auto energy = energies_of(run);
  const std::vector<double>& times = energy->times;
  std::vector<AlignedImpact> impacts = *impacts_of(run);
  std::erase_if(impacts, [](const AlignedImpact& one) { return !one.exact || !one.engine || !one.number; });
  std::ranges::stable_sort(impacts, {}, &AlignedImpact::exact);
  std::vector<ImpactLoss> losses;
  if (times.empty()) return losses;
  double exact_from = times.front(), engine_from = times.front();
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    const bool last = i + 1 == impacts.size();
    const double exact_to = last ? times.back() : (*impacts[i].exact + *impacts[i + 1].exact) / 2;
    const double engine_to = last ? times.back() : (*impacts[i].engine + *impacts[i + 1].engine) / 2;
    if (exact_to > exact_from && engine_to > engine_from)
      losses.push_back({static_cast<double>(*impacts[i].number),
                        at(times, energy->exact, exact_from) - at(times, energy->exact, exact_to),
                        at(times, energy->balance, engine_from) - at(times, energy->balance, engine_to)});
    exact_from = exact_to;
    engine_from = engine_to;
  }
  return losses;
}

std::vector<double> replicates_of(const Run& run, const std::string& quantity) {
  const auto file = run.folder / "draws.csv";
  if (!fs::exists(file)) return {};
  std::vector<double> values = read_columns(file, {quantity}).front();
  std::erase_if(values, [](double value) { return std::isnan(value); });
  std::ranges::sort(values);
  return values;
}

Share toppled_share(const std::vector<MotionTally>& tallies, const std::vector<MotionTally>& exact) {
  Share share;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    if (tallies[i].failed()) continue;
    ++share.of;
    if (tallies[i].topples) ++share.toppled;
    if (i < exact.size() && !exact[i].failed() && exact[i].topples == tallies[i].topples) ++share.agree;
  }
  return share;
}

}  // namespace rockstack::plots
