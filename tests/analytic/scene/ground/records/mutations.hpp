#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rockstack {

/// A made-up text of every layout.
std::vector<std::string> one_of_each_layout();

/// A text with one to four random wounds: bytes changed, pieces cut, doubled, moved, numbers blown up.
std::string mutated(std::string text, std::mt19937_64& random);

/// What a text is good for. Anything but these two outcomes escapes as another exception or as a crash.
enum class Outcome { record, refused };

/// Reads a text. @throws std::logic_error where a series is empty, has a sample that is not finite or a time
/// step that is not positive, or where an error is not one line that starts with the file's name.
Outcome outcome_of(const std::string& text);

}  // namespace rockstack
