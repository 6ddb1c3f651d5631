#pragma once

#include "analytic/round/round.hpp"
#include "analytic/scene/input/json.hpp"
#include "analytic/scene/input/key.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "comparisons/suites/varied_key.hpp"

namespace rockstack {

/// Keys of the file of a round column, and of its tables; [ground.x], [ground.y] and [ground.z] have those of
/// a scene's [ground.horizontal].
extern const KeysOf<RoundScene> round_keys, round_initial_keys, round_ground_keys;
inline constexpr std::initializer_list<const KeyTable*> round_tables{&round_keys, &round_initial_keys,
                                                                     &round_ground_keys};

/// The column that a document describes. @throws InputError with place, key, value and what is allowed.
RoundScene make_round(const SceneDocument& document, MotionLibrary& library);

/// A value of a key, and whether the column topples in space and held in the plane of x and z.
struct RoundOutcome {
  double value = 0;
  bool space = false, plane = false;
};

/// What was tried, and the least values found that topple it; none where none does, or already the lowest.
struct RoundThreshold {
  std::vector<RoundOutcome> tried;
  std::optional<double> space, plane;
};

/// Tries values at equal distances, and closes in on the first change from standing to toppling to twelve
/// digits. @throws InputError as make_round().
RoundThreshold round_threshold(const SceneDocument& document, const VariedKey& vary, std::size_t values,
                               MotionLibrary& library);

/// Writes history.csv and events.csv to the folder, and round.json with what they come to in sentences.
/// @returns that.
Json write_round(const RoundScene& scene, const RoundMotion& motion, const std::filesystem::path& folder,
                 const std::string& command);

/// Writes threshold.csv to the folder, and round.json with what it comes to in a sentence. @returns that.
Json write_round_threshold(const std::string& title, const VariedKey& vary, const RoundThreshold& found,
                           const std::filesystem::path& folder, const std::string& command);

}  // namespace rockstack
