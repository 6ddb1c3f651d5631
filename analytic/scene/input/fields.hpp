#pragma once

#include <array>
#include <functional>
#include <initializer_list>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/lists.hpp"

namespace rockstack {

/// The numbers of a key that a slider has; others may be typed.
struct UsualNumbers {
  double least = 0, most = 0;  ///< equal: no slider
  bool by_factors = false;     ///< equal ways are equal factors
};

/// A text that a key may be, and what it stands for.
struct NamedChoice {
  const char* name;
  const char* words = "";
};

/// A key of an input file and what it means; `rockstack keys` prints it. SI units.
struct InputKey {
  const char* name;
  const char* example = "";  ///< a value that is accepted, as TOML; empty: a table, with keys of its own
  const char* unit = "";     ///< empty: none
  std::string range = "";    ///< which values are accepted
  std::string default_value = "";  ///< what holds where it is left out: a value as TOML, or words; see below
  const char* meaning = "";
  UsualNumbers usual = {};
  std::vector<NamedChoice> choices = {};
};

/// "\"a\", \"b\" or \"c\"".
std::string choices_text(const std::vector<NamedChoice>& choices);

// Words that `default_value` has where no value stands for a key that is left out. "instead of KEY": one of
// the two must be there, or may be there where KEY may be left out.
inline constexpr const char* required_key = "required";
inline constexpr const char* no_default = "none";

/// A table of an input file: the only keys that its reader accepts.
struct KeyTable {
  const char* header;   ///< as a file has it, e.g. "[[blocks]]"; empty: the top of the file
  const char* meaning;  ///< of the table
  std::vector<InputKey> keys;
};

// Typed access to values of a scene file. All throw InputError with place, key, value and what is allowed.

/// Refuses what is no table, and keys that are not among those allowed.
void require_table(const Node& node, const KeyTable& allowed);

/// The child of that name; refuses a table without it.
const Node& required(const Node& table, std::string_view name, const std::string& allowed);

double number(const Node& node);
double number_above_zero(const Node& node);
/// The largest seed of random numbers: up to here a double holds every whole number.
inline constexpr double largest_seed = 0x1p53;

/// A whole number from `least` to `most`. Precondition: both are whole and at most 2⁵³.
double whole_number(const Node& node, double least, double most = 1e9);

/// Numbers that are checked as they are read: which, in the words of a key, and what makes one of a value.
struct CheckedNumber {
  std::string words;
  std::string needed = "a number";  ///< said where there is none
  std::function<double(const Node&)> read;
};
inline CheckedNumber numbers_above_zero() {
  return {"> 0", "a number", number_above_zero};
}
CheckedNumber numbers_between(double least, double most);
/// The bounds of whole_number(); without `most` words have the first alone.
CheckedNumber whole_numbers(double least, double most = 1e9);

double required_number(const Node& table, std::string_view name);
double number_or(const Node& table, std::string_view name, double otherwise);

/// The entries of an array that has some; `allowed` says what it must be.
const std::vector<Node>& entries(const Node& array, const std::string& allowed);

/// All entries of an array of numbers, each finite.
std::vector<double> numbers(const Node& node);
/// An array with a number for each block; whether there are as many, validate() says.
std::vector<double> one_each(const Node& array);

const std::string& text(const Node& node);

/// The place of a text among the names that it may be, from 0.
std::ptrdiff_t place_among(const Node& node, const std::vector<const char*>& names);

/// The meaning of a text that is one of a few names, which may be that of its place among them.
template <class Choice>
Choice choice(const Node& node, std::initializer_list<const char*> names) {
  return static_cast<Choice>(place_among(node, names));
}
template <class Choice, std::size_t count>
Choice choice(const Node& node, const std::array<const char*, count>& names) {
  return static_cast<Choice>(place_among(node, {names.begin(), names.end()}));
}
template <class Choice>
Choice choice(const Node& node, std::initializer_list<std::pair<const char*, Choice>> choices) {
  const auto names = mapped(choices, [](const auto& each) { return each.first; });
  return choices.begin()[place_among(node, names)].second;
}

}  // namespace rockstack
