#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rockstack::records {

/// What words of titles and headers speak of, as words.txt has them.
enum class Topic {
#include "analytic/scene/ground/records/topics.inc"
};

/// Letters in lower case, without accents, in Latin, Greek and Cyrillic: "Accélération" is "acceleration".
std::string folded(std::string_view text);

/// Words of a folded text, without digits and signs.
std::vector<std::string_view> words_in(std::string_view plain);

/// The words of a topic, without those that are parts of others.
const std::vector<std::string_view>& words_of(Topic topic);

/// Whether a folded word, or one of several, is of a topic.
bool is_of(std::string_view word, Topic topic);
bool any_of_topic(const std::vector<std::string_view>& name, Topic topic);

/// Whether a text has a word of a topic.
bool speaks_of(std::string_view text, Topic topic);

}  // namespace rockstack::records
