#include "comparisons/measures/results/tables.hpp"

#include <fmt/format.h>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/restraint_law.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/metrics/contact.hpp"
#include "comparisons/measures/results/csv.hpp"

namespace rockstack {
namespace {

/// To the digits that the accelerations behind it are good for.
std::string shortened(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "";
}

struct HistoryTable {
  const char *name, *file;
  std::string (*csv)(const Scene&, const History&);
};

constexpr std::array history_tables{HistoryTable{"corners", "corners.csv", &corners_csv},
                                    HistoryTable{"energies", "energies.csv", &energies_csv},
                                    HistoryTable{"forces", "reactions.csv", &reactions_csv}};

/// A corner of a block and its sign from the middle.
struct Corner {
  const char* name;
  int x, y;
};
constexpr std::array corners{Corner{"lower_left", -1, -1}, Corner{"lower_right", 1, -1},
                             Corner{"upper_left", -1, 1}, Corner{"upper_right", 1, 1}};

/// Where the corners of all blocks are, x and y in turn, m.
std::vector<double> corners_of(const Scene& scene, const Points<double>& places,
                               const Vector<double>& angles) {
  std::vector<double> result;
  for (Eigen::Index k = 0; k < angles.size(); ++k) {
    const Block& block = scene.blocks[static_cast<std::size_t>(k)];
    for (const Corner& corner : corners) {
      const Point<double> place = places.col(k) + turned(corner.x * block.half_width - block.offset_x,
                                                         corner.y * block.half_height - block.offset_y,
                                                         std::cos(angles[k]), std::sin(angles[k]));
      result.insert(result.end(), {place.x(), place.y()});
    }
  }
  return result;
}

/// Tendons of a scene, followed from sample to sample.
class Tendons {
 public:
  explicit Tendons(const Scene& scene) : laws_(restraint_laws<double>(scene)) {
    std::erase_if(laws_, [](const RestraintLaw<double>& law) { return law.stiffness == 0; });
  }

  int size() const { return static_cast<int>(laws_.size()); }

  /// What each holds with blocks at these places, J: F²/2k, with F its force. One that yields is drawn by
  /// then as far as samples tell.
  std::vector<double> energies(const Points<double>& places, std::span<const double> angles) {
    const auto place = [&](int body, const Point<double>& arm) -> Point<double> {
      if (body < 0) return arm;
      const double angle = angles[static_cast<std::size_t>(body)];
      return places.col(body) + turned(arm.x(), arm.y(), std::cos(angle), std::sin(angle));
    };
    std::vector<double> list;
    for (RestraintLaw<double>& law : laws_) {
      const double length = (place(law.to, law.to_arm) - place(law.from, law.from_arm)).norm();
      law.follow(length);
      const double force = law.force(length, 0);
      list.push_back(force * force / (2 * law.stiffness));
    }
    return list;
  }

 private:
  std::vector<RestraintLaw<double>> laws_;
};

}  // namespace

std::string reactions_csv(const Scene& scene, const History& history) {
  const std::vector<Reaction> rows = reactions_of(scene, history);
  CsvWriter csv;
  csv.line("time", numbered("normal_", history.blocks), numbered("tangential_", history.blocks),
           numbered("centre_", history.blocks));
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto row = history.row(rows, i);
    csv.add(history.times[i]);
    for (const Reaction& reaction : row) csv.add(shortened(reaction.normal));
    for (const Reaction& reaction : row) csv.add(shortened(reaction.tangential));
    for (const Reaction& reaction : row) csv.add(shortened(reaction.centre));
    csv.end_line();
  }
  return csv.text();
}

std::vector<std::string> kinds_of_histories() {
  return mapped(history_tables, [](const HistoryTable& table) { return std::string(table.name); });
}

std::map<std::string, std::string> histories_csv(const Scene& scene, const History& history,
                                                 const std::vector<std::string>& asked) {
  std::map<std::string, std::string> files;
  for (const std::string& name : asked) {
    const auto found = std::ranges::find(history_tables, name, &HistoryTable::name);
    if (found == history_tables.end())
      throw InputError(
          fmt::format("--histories {}: must be {}", name, fmt::join(kinds_of_histories(), " or ")));
    files[found->file] = found->csv(scene, history);
  }
  return files;
}

std::string energies_csv(const Scene& scene, const History& history) {
  const Stack<double> stack = make_stack<double>(scene);
  const Gravity gravity = gravity_of(scene);
  CsvWriter csv;
  const bool springs = !history.spring_energies.empty();
  csv.add("time", numbered("kinetic_", history.blocks), numbered("potential_", history.blocks));
  if (springs)
    csv.add(numbered("elastic_", history.blocks), numbered("damped_", history.blocks),
            numbered("rubbed_", history.blocks));
  Tendons tendons(scene);
  csv.add(numbered("tendon_", tendons.size()));
  csv.end_line();
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Vector<double> velocities = vector_of(history.velocities_at(i));
    const auto [places, speeds] = centres_at(stack, history, i);
    const Points<double> moved = centre_displacements(stack, history, i);
    csv.add(history.times[i]);
    for (int k = 0; k < stack.size(); ++k)
      csv.add(0.5 * stack.mass[k] * speeds.col(k).squaredNorm() +
              0.5 * stack.inertia[k] * velocities[k] * velocities[k]);
    for (int k = 0; k < stack.size(); ++k)
      csv.add(stack.mass[k] * (gravity.across * moved(1, k) - gravity.along * moved(0, k)));
    for (const auto part : {&SpringEnergy::elastic, &SpringEnergy::damped, &SpringEnergy::rubbed})
      if (springs)
        for (const SpringEnergy& energy : history.row(history.spring_energies, i)) csv.add(energy.*part);
    csv.add(tendons.energies(places, history.angles_at(i)));
    csv.end_line();
  }
  return csv.text();
}

std::string corners_csv(const Scene& scene, const History& history) {
  const Stack<double> stack = make_stack<double>(scene);
  const Vector<double> upright = Vector<double>::Zero(stack.size());
  const std::vector<double> rest =
      corners_of(scene, centres(make_chain(stack, closed_pattern(history.blocks), upright)), upright);
  CsvWriter csv;
  csv.add("time");
  for (int k = 1; k <= history.blocks; ++k)
    for (const Corner& corner : corners)
      csv.add(fmt::format("{}_x_{}", corner.name, k), fmt::format("{}_y_{}", corner.name, k));
  csv.end_line();
  for (std::size_t i = 0; i < history.size(); ++i) {
    std::vector<double> moved =
        corners_of(scene, centres_at(stack, history, i).at, vector_of(history.angles_at(i)));
    std::transform(moved.begin(), moved.end(), rest.begin(), moved.begin(), std::minus<>());
    csv.line(history.times[i], moved);
  }
  return csv.text();
}

}  // namespace rockstack
