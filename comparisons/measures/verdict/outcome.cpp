#include "comparisons/measures/verdict/verdict.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "comparisons/measures/metrics/bodies.hpp"
#include "comparisons/measures/results/sentences.hpp"
#include "comparisons/measures/statistics/samples.hpp"

// What becomes of a run: what happens in engines and not in the exact motion, and whether they agree.

namespace rockstack {
namespace {

using Happening = RowEvent::Kind;

/// An event's verb, how it is told of several sets, and the unit of its size.
struct KindWords {
  const char *verb, *several, *unit;
};

/// In the order of RowEvent::Kind.
constexpr std::array<KindWords, 13> kind_words{
    {{"fails", "some replicates fail", ""},
     {"", "blocks fall or topple that do not in the exact motion", ""},
     {"stands, though in the exact motion a block falls", "blocks stand that fall in the exact motion", ""},
     {"", "blocks topple that lean past balance in the exact motion, and would fall later", ""},
     {"is thrown up by {}", "blocks are thrown up, by {} at most", "m"},
     {"leaves the plane by {}", "blocks leave the plane, by {} at most", "m"},
     {"is {} off at the end", "blocks come to rest elsewhere, {} off at most", "m"},
     {"sinks in by {}", "blocks sink in, by {} at most", "m"},
     {"hovers {} high", "blocks hover, {} high at most", "m"},
     {"creeps at {} to the end", "blocks creep to the end, at {} at most", "m/s"},
     {"turns at {} to the end", "blocks turn to the end, at {} at most", "rad/s"},
     {"sinks in by {} for a moment", "blocks sink in for a moment, by {} at most", "m"},
     {"moves by {} for a while", "blocks that rest are moved for a while, by {} at most", "m"}}};

const KindWords& words_of(Happening kind) {
  return kind_words.at(static_cast<std::size_t>(kind));
}

std::string fall_of(const RunMetrics& run) {
  return run.fallen.empty() ? with_verb(run.toppled, "topples") : with_verb(run.fallen, "has fallen off");
}

/// Whether a block falls before the scene ends.
bool ends_early(const RunMetrics& run) {
  return !run.toppled.empty() || !run.fallen.empty();
}

/// Share of the least height by which a block that falls or topples has been thrown up as well.
constexpr double thrown_share = 0.1;

bool at_rest(const RunMetrics& run) {
  return run.motion && *run.motion <= rest_extent;
}

/// How far a block leaves the plane, by its centre or by its tilt at an end of the least height, m.
double way_out_of_plane(const RunMetrics& run, const JudgedScene& scene) {
  return std::max(run.out_of_plane.value_or(0), scene.least_height * run.out_of_plane_tilt.value_or(0));
}

/// All that happens in one run, with its size.
std::map<Happening, double> events_in(const RunMetrics& run, const JudgedScene& scene) {
  if (run.status != RunStatus::done) return {{Happening::fails, 0}};
  std::map<Happening, double> events;
  const auto add = [&](Happening kind, double size, double least) {
    if (size > least) events[kind] = size;
  };
  const double tolerance = scene.tolerance * scene.least_height;
  if (differ(run.toppling_verdict))
    events[run.toppling_verdict == TopplingVerdict::exact_alone ? Happening::stands : Happening::falls] = 0;
  if (run.toppling_verdict == TopplingVerdict::both || !events.empty()) {
    // Blocks that fall rise a little at their corners.
    add(Happening::thrown, run.rise.value_or(0), thrown_share * scene.least_height);
    add(Happening::leaves, way_out_of_plane(run, scene), tolerance);
    return events;
  }
  if (run.toppling_verdict == TopplingVerdict::unknown && ends_early(run)) events[Happening::ends] = 0;
  const double told = told_sinking * scene.least_height, off = run.largest_position_difference.value_or(0),
               hover = run.hover.value_or(0), creep = run.creep.value_or(0);
  // What is nowhere else than in the exact motion has not sunk in, as far as that can be said.
  const bool whole = run.horizon.value_or(scene.duration) >= scene.duration;
  const auto sunk = [&](const std::optional<double>& depth) {
    return whole ? std::min(depth.value_or(0), off) : depth.value_or(0);
  };
  const double sinking = sunk(run.sinking);
  // What hovers has risen to there.
  add(Happening::thrown, run.rise.value_or(0), std::max(tolerance, 1.1 * hover));
  const bool thrown = events.contains(Happening::thrown);
  add(Happening::leaves, way_out_of_plane(run, scene), tolerance);
  // What sinks in, hovers and creeps is off by that.
  add(Happening::shifts, run.offset.value_or(0), tolerance + 2 * (sinking + hover) + creep * scene.duration);
  add(Happening::sinks, sinking, told);
  add(Happening::hovers, hover, told);
  if (!thrown && !events.contains(Happening::ends)) {  // what is thrown or topples goes on as it falls
    add(Happening::creeps, creep, told / scene.duration);
    add(Happening::turns, run.turn.value_or(0), scene.tolerance / scene.duration);
  }
  if (!thrown) add(Happening::dips, sunk(run.penetration), std::max(tolerance, 2 * sinking));
  if (events.empty() && at_rest(run) && !agrees(run, scene)) events[Happening::moves] = off;
  return events;
}

/// "250 mm to 1 m", or one number where both are written alike.
std::string range_text(double low, double high, const char* unit) {
  const std::string from = quantity_text(low, unit, 2), to = quantity_text(high, unit, 2);
  return from == to ? to : from + " to " + to;
}

/// The row of each set in which the gravest happens that does not in the exact motion, of several that with
/// the largest error.
std::vector<const ReplicatedRow*> rows_with_events(const std::vector<ReplicatedRow>& rows) {
  std::vector<const ReplicatedRow*> list;
  for (const ReplicatedRow& row : rows) {
    if (!is_engine(row) || !row.error || row.events.empty()) continue;
    const auto same = [&](const ReplicatedRow* other) {
      return other->scene == row.scene && set_name(*other) == set_name(row);
    };
    const ReplicatedRow*& worst = found_or_added(list, same, &row);
    const auto rank = [](const ReplicatedRow& one) {
      return std::pair(one.events.front().kind, -*one.error);
    };
    if (rank(row) < rank(*worst)) worst = &row;
  }
  return list;
}

/// Which sets have events of each kind as their gravest, and how large these are at most in any of their
/// rows.
std::string counted_events(const std::vector<const ReplicatedRow*>& rows,
                           const std::vector<ReplicatedRow>& all) {
  constexpr std::size_t most_sets = 1;  // that a sentence names of more than two
  std::map<Happening, std::set<std::string>> sets;
  std::map<Happening, double> most;
  for (const ReplicatedRow* row : rows) {
    const RowEvent& gravest = row->events.front();
    sets[gravest.kind].insert(set_name(*row));
  }
  for (const ReplicatedRow& row : all)
    for (const RowEvent& event : row.events)
      if (const auto own = sets.find(event.kind); own != sets.end() && own->second.contains(set_name(row)))
        most[event.kind] = std::max(most[event.kind], event.most);
  const auto told = [&](const auto& one) {
    const auto& [kind, names] = one;
    const KindWords& words = words_of(kind);
    return fmt::format("with {}, {}", joined_up_to(most_sets, {names.begin(), names.end()}),
                       fmt::format(fmt::runtime(words.several), quantity_text(most[kind], words.unit, 2)));
  };
  return capitalised(joined_texts(sets, told, "; ")) + ".";
}

/// Until when how many of a row's runs agree.
std::string agreement_of(const std::vector<RunMetrics>& runs, const JudgedScene& scene) {
  std::vector<double> ends;
  std::size_t whole = 0;
  for (const RunMetrics& run : runs) {
    if (run.status != RunStatus::done) continue;
    whole += agrees(run, scene) ? 1 : 0;
    ends.push_back(agreement_end(run, scene));
  }
  const std::string all =
      runs.front().horizon.value_or(scene.duration) < scene.duration ? "to the horizon" : "to the end";
  const std::string share =
      whole == runs.size() ? "" : fmt::format(" in {} of {} replicates", whole, runs.size());
  if (2 * whole > runs.size()) return "agrees " + all + share;
  const std::string until = "agrees until " + quantity_text(median(ends), "s");
  return whole == 0 ? until : until + ", " + all + share;
}

}  // namespace

std::vector<RowEvent> events_of(const std::vector<RunMetrics>& runs, const JudgedScene& scene) {
  std::map<Happening, std::vector<double>> sizes;
  std::map<Happening, std::string> falls;
  for (const RunMetrics& run : runs)
    for (const auto& [kind, size] : events_in(run, scene)) {
      sizes[kind].push_back(size);
      if (kind == Happening::falls || kind == Happening::ends) falls.try_emplace(kind, fall_of(run));
    }
  return mapped(sizes, [&](const auto& one) {
    const auto& [kind, list] = one;
    const auto [low, high] = std::ranges::minmax(list);
    const KindWords& words = words_of(kind);
    std::string text = falls.contains(kind)
                           ? falls.at(kind)
                           : fmt::format(fmt::runtime(words.verb), range_text(low, high, words.unit));
    if (list.size() < runs.size()) text += fmt::format(" in {} of {} replicates", list.size(), runs.size());
    return RowEvent{kind, std::move(text), high};
  });
}

std::string event_sentence(const std::vector<ReplicatedRow>& rows, std::size_t most) {
  const std::vector<const ReplicatedRow*> list = rows_with_events(rows);
  if (list.empty()) return "";
  if (list.size() > most) return counted_events(list, rows);
  const auto told = [&](const ReplicatedRow* row) {
    const RowEvent& gravest = row->events.front();
    const char* subject = gravest.kind == Happening::falls || gravest.kind == Happening::ends ? ""
                          : gravest.kind == Happening::fails || gravest.kind == Happening::stands
                              ? "it "
                              : "a block ";
    return fmt::format("with {} in {} at {} {}{}", set_name(*row), row->scene, quantity_text(*row->dt, "s"),
                       subject, gravest.text);
  };
  return capitalised(joined_texts(list, told, "; ")) + ".";
}

std::string with_verb(const std::string& block_and_time, const std::string& verb) {
  return block_and_time.substr(0, block_and_time.find(" at ")) + " " + verb + " at " +
         quantity_text(end_time(block_and_time), "s");
}

double end_time(const std::string& block_and_time) {
  return std::stod(block_and_time.substr(block_and_time.find(" at ") + 4));
}

bool is_engine(const RunMetrics& row) {
  return row.dt && !row.settings.empty() && row.settings != "baseline";
}

std::string set_name(const std::string& engine, const std::string& solver, const std::string& settings) {
  return fmt::format("{}:{} ({})", engine, solver, settings);
}

bool agrees(const RunMetrics& row, const JudgedScene& scene) {
  return row.largest_angle_difference.value_or(0) <= scene.tolerance &&
         row.relative_position_difference.value_or(0) <= scene.tolerance;
}

double agreement_end(const RunMetrics& row, const JudgedScene& scene) {
  const double horizon = row.horizon.value_or(scene.duration);
  if (agrees(row, scene)) return horizon;
  return std::min(
      {horizon, row.agreement_time.value_or(horizon), row.position_agreement_time.value_or(horizon)});
}

/// Share of the least height from which on it is told how far off blocks are that move in the exact motion,
/// too.
constexpr double far_share = 0.5;

std::string outcome(const std::vector<RunMetrics>& runs, const JudgedScene& scene) {
  const RunMetrics& nominal = runs.front();
  if (nominal.status != RunStatus::done) return name(nominal.status) + ": " + nominal.reason;
  if (!nominal.error) return "";
  const std::vector<RowEvent> events = events_of(runs, scene);
  const std::string told = joined_texts(
      events, [](const RowEvent& event) { return event.text; }, "; ");
  if (!at_rest(nominal)) {
    const double off = nominal.largest_position_difference.value_or(0);
    const bool elsewhere = told.empty() && off > far_share * scene.least_height;
    return agreement_of(runs, scene) + (told.empty() ? "" : "; " + told) +
           (elsewhere ? ", then up to " + quantity_text(off, "m", 2) + " off" : "");
  }
  const auto stays = [](const RowEvent& event) {
    return event.kind == Happening::sinks || event.kind == Happening::hovers ||
           event.kind == Happening::shifts;
  };
  return told.empty() ? "rests" : std::ranges::all_of(events, stays) ? "rests, but " + told : told;
}

}  // namespace rockstack
