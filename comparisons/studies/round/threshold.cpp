#include "analytic/scene/input/toml_reader.hpp"
#include "comparisons/studies/round/study.hpp"

namespace rockstack {
namespace {

constexpr double round_resolution = 1e-12;  ///< of a threshold, relative

/// Whether the column topples with a value of a key, in a room.
class RoundTrial {
 public:
  RoundTrial(const SceneDocument& document, std::string key, MotionLibrary& library)
      : document_(document), key_(std::move(key)), library_(library) {}

  bool operator()(double value, RoundRoom room) {
    set_value(document_.root, key_,
              {.kind = Node::Kind::number, .place = "--threshold " + key_, .number = value});
    RoundScene scene = make_round(document_, library_);
    scene.room = room;
    return topples(scene, solve_round(scene, {scene.duration}));
  }

 private:
  SceneDocument document_;
  std::string key_;
  MotionLibrary& library_;
};

/// Between a value that stands and one that topples.
double closed_in(RoundTrial& trial, RoundRoom room, double stands, double falls) {
  while (std::abs(falls - stands) > round_resolution * std::max(std::abs(falls), std::abs(stands))) {
    const double middle = std::lerp(stands, falls, 0.5);
    if (middle == stands || middle == falls) break;
    (trial(middle, room) ? falls : stands) = middle;
  }
  return falls;
}

}  // namespace

RoundThreshold round_threshold(const SceneDocument& document, const VariedKey& vary, std::size_t values,
                               MotionLibrary& library) {
  RoundTrial trial(document, vary.key, library);
  RoundThreshold found;
  const auto first = [&](RoundRoom room, bool RoundOutcome::*topples) -> std::optional<double> {
    for (std::size_t i = 1; i < found.tried.size(); ++i)
      if (found.tried[i].*topples && !(found.tried[i - 1].*topples))
        return closed_in(trial, room, found.tried[i - 1].value, found.tried[i].value);
    return std::nullopt;
  };
  for (std::size_t i = 0; i < values; ++i) {
    const double value =
        std::lerp(vary.low, vary.high, static_cast<double>(i) / static_cast<double>(values - 1));
    found.tried.push_back({value, trial(value, RoundRoom::space), trial(value, RoundRoom::plane)});
  }
  found.space = first(RoundRoom::space, &RoundOutcome::space);
  found.plane = first(RoundRoom::plane, &RoundOutcome::plane);
  return found;
}

}  // namespace rockstack
