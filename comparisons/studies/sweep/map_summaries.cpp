#include "comparisons/studies/sweep/map_summaries.hpp"

#include "comparisons/measures/metrics/run_outcome.hpp"
#include "comparisons/studies/sweep/counted_rows.hpp"

namespace rockstack {
namespace {

/// A run on a map: its place, and which of some kinds it is of, as bits.
struct Spot {
  double across = 0, up = 0;
  std::uint32_t kinds = 0;

  std::pair<double, double> place() const { return {across, up}; }
};

/// Writes how many runs of each kind there are at each place, which is told by columns of its own.
void write_map(const std::filesystem::path& file, std::vector<Spot> spots,
               const std::vector<std::pair<std::string, std::function<double(const Spot&)>>>& axes,
               const std::vector<std::string>& kinds) {
  std::ranges::sort(spots, {}, &Spot::place);
  std::vector<std::size_t> begins;  // of places, and the end
  for (std::size_t i = 0; i < spots.size(); ++i)
    if (i == 0 || spots[i].place() != spots[i - 1].place()) begins.push_back(i);
  begins.push_back(spots.size());
  std::vector<FileColumn> columns;
  columns.reserve(axes.size() + kinds.size());
  for (const auto& [name, of] : axes)
    columns.push_back(
        {name, FileColumn::Number([&, of = of](std::size_t row) { return of(spots[begins[row]]); })});
  for (std::size_t k = 0; k < kinds.size(); ++k)
    columns.push_back({kinds[k], FileColumn::Count([&, k](std::size_t row) {
                         std::size_t count = 0;
                         for (std::size_t i = begins[row]; i < begins[row + 1]; ++i)
                           count += spots[i].kinds >> k & 1U;
                         return count;
                       })});
  write_table(file, columns, begins.size() - 1);
}

/// The place of a name among kinds, as a bit.
std::uint32_t bit_of(const std::vector<std::string>& kinds, const std::string& name) {
  return 1U << static_cast<unsigned>(std::ranges::find(kinds, name) - kinds.begin());
}

/// "slide_rock" of slide-rock.
std::string column_of(std::string mode) {
  std::ranges::replace_if(
      mode, [](char c) { return c == '-' || c == ' '; }, '_');
  return mode;
}

}  // namespace

void write_overturning(const std::filesystem::path& runs, const SummaryKeys& keys,
                       const std::filesystem::path& file) {
  const std::vector<std::string> kinds{
      "runs", "rest", "rocking", "toppled_after_impact", "toppled_without_impact", "failed"};
  std::vector<Spot> spots;
  each_counted(runs, {keys.period, keys.intensity, "status", "toppled", "events", "impacts"},
               [&](const TableRows& row) {
                 const std::string kind = row.text(2) == "failed" ? "failed"
                                          : !(row.value(3) > 0)   ? (row.value(4) > 0 ? "rocking" : "rest")
                                          : row.value(5) > 0      ? "toppled_after_impact"
                                                                  : "toppled_without_impact";
                 spots.push_back({row.value(0), row.value(1), bit_of(kinds, "runs") | bit_of(kinds, kind)});
               });
  write_map(file, std::move(spots),
            {{"period", &Spot::across},
             {"frequency", [](const Spot& spot) { return 1 / spot.across; }},
             {"intensity", &Spot::up}},
            kinds);
}

void write_modes(const std::filesystem::path& runs, const SummaryKeys& keys,
                 const std::filesystem::path& file) {
  std::vector<std::string> kinds{"runs"};
  for (const MotionMode mode : motion_modes)
    if (mode <= MotionMode::free_flight) kinds.push_back("onset_" + column_of(name(mode)));
  for (const MotionMode mode : motion_modes) kinds.push_back(column_of(name(mode)));
  kinds.emplace_back("failed");
  std::vector<Spot> spots;
  each_counted(runs, {keys.intensity, keys.friction, "status", "onset", "motion"}, [&](const TableRows& row) {
    const std::uint32_t kind = row.text(2) == "failed" ? bit_of(kinds, "failed")
                                                       : bit_of(kinds, "onset_" + column_of(row.text(3))) |
                                                             bit_of(kinds, column_of(row.text(4)));
    spots.push_back({row.value(0), row.value(1), bit_of(kinds, "runs") | kind});
  });
  write_map(file, std::move(spots), {{"intensity", &Spot::across}, {"friction", &Spot::up}}, kinds);
}

}  // namespace rockstack
