#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rockstack {

/// "1 run", "2 runs".
std::string counted(std::size_t count, const std::string& one);

/// "a, b and c".
std::string joined(const std::vector<std::string>& words);

/// Joins at most `most`: "a, b and 5 others".
std::string joined_up_to(std::size_t most, const std::vector<std::string>& words);

/// With a capital where it begins with a letter.
std::string capitalised(std::string text);

/// The title of an axis along which a scene's key varies, with its unit where the key has one.
std::string axis_title(const std::string& key);

/// A value with the words of its axis: "a peak ground acceleration of 4.8 m/s²".
std::string value_on(const std::string& axis, double value);
std::string value_on(const std::string& axis, const std::string& value);

/// A paragraph of a text that the program holds: "NAME" or "NAME: KIND" in its first line, and the others as
/// one.
struct Paragraph {
  std::string name, kind, words;
};

/// All of them; lines that begin with # are left out.
std::vector<Paragraph> paragraphs(std::string_view text);

/// Puts each value in the place of its {{name}}. @throws std::logic_error for a place without a value.
std::string filled_in(std::string_view text, const std::map<std::string, std::string>& values);

}  // namespace rockstack
