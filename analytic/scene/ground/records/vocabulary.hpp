#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rockstack::records {

/// What words of titles and headers speak of, in the languages that records are written in.
enum class Topic {
  acceleration,
  acceleration_letter,  ///< "a", "ax": by which nothing else is an acceleration
  velocity,
  displacement,
  time,
  time_letter,  ///< "t", which may be a period, a temperature
  second,       ///< in brackets after a time
  angle,
  rotation,  ///< makes an angular acceleration of an acceleration
  other,     ///< a force, a voltage, a temperature: what no record holds
  measure,   ///< what an acceleration, velocity or displacement is of, or made of, that is no motion of a
             ///< ground
  channel,   ///< a direction, a sensor: of whatever the header says
  counting,  ///< of samples and dates
  spectrum,
  spectral_ordinate,
  history,  ///< beside a spectrum: what only matches one
  factor,
  normalised,
  peak
};

/// Letters in lower case, without accents, in Latin, Greek and Cyrillic: "Accélération" is "acceleration".
std::string folded(std::string_view text);

/// Words of a folded text, without digits and signs.
std::vector<std::string_view> words_in(std::string_view plain);

/// Whether a folded word, or one of several, is of a topic.
bool is_of(std::string_view word, Topic topic);
bool any_of_topic(const std::vector<std::string_view>& name, Topic topic);

/// Whether a text has a word of a topic.
bool speaks_of(std::string_view text, Topic topic);

}  // namespace rockstack::records
