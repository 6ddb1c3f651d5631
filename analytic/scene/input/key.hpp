#pragma once

#include "analytic/scene/input/fields.hpp"
#include "analytic/scene/messages/number_text.hpp"
#include "analytic/scene/spring_checks.hpp"

namespace rockstack {

/// What a list of one number a block must be; their number follows.
inline constexpr const char* as_long = "as long as there are blocks, ";

/// The numbers that a key takes, in words and as bounds, both included.
struct KeyRange {
  const char* words;
  double least = -largest_number, most = largest_number;
};
inline constexpr KeyRange any_number{"any number"};
inline constexpr KeyRange above_zero{"> 0", 1 / largest_number};
inline constexpr KeyRange from_zero{"≥ 0", 0};
/// Numbers whose bounds depend on others, or leave one out: a check of their own knows them.
constexpr KeyRange by_itself(const char* words) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  return {words, -endless, endless};
}

/// A key of a table whose values are a T: which member it is, and what that may be. A default is T's own.
template <class T>
struct Key {
  InputKey said;
  KeyRange range = any_number;
  double T::*number = nullptr;
  std::vector<double> T::*numbers = nullptr;           ///< one for each block, or none
  void (*read_other)(const Node& node, T&) = nullptr;  ///< of what is no number

  /// A key that its table's reader takes by itself.
  Key(const char* name, const char* example, const char* unit, const char* allowed, const char* otherwise,
      const char* meaning)
      : said{name, example, unit, allowed, otherwise, meaning} {}
  /// A number: required, or with what a new T has.
  Key(const char* name, const char* example, const char* unit, const KeyRange& allowed, const char* meaning,
      double T::*member)
      : said{name, example, unit, allowed.words, number_text(T().*member), meaning},
        range(allowed),
        number(member) {}
  Key(const char* name, const char* example, const char* unit, const KeyRange& allowed, const char* needed,
      const char* meaning, double T::*member)
      : said{name, example, unit, allowed.words, needed, meaning}, range(allowed), number(member) {}
  Key(const char* name, const char* example, const char* unit, const KeyRange& allowed, const char* otherwise,
      const char* meaning, std::vector<double> T::*member)
      : said{name, example, unit, allowed.words, otherwise, meaning}, range(allowed), numbers(member) {}
  Key(InputKey words, void (*read)(const Node& node, T&)) : said(std::move(words)), read_other(read) {}

  void read(const Node& node, T& object) const {
    if (number != nullptr) object.*number = rockstack::number(node);
    // Checks say what length a list that is always there must have.
    if (numbers != nullptr)
      object.*numbers = (object.*numbers).empty() ? one_each(node) : rockstack::numbers(node);
    if (read_other != nullptr) read_other(node, object);
  }
};

/// A table of which values are members of T.
template <class T>
struct KeysOf : KeyTable {
  std::vector<Key<T>> members;

  KeysOf(const char* file_header, const char* words, std::vector<Key<T>> rows)
      : KeyTable{file_header, words, mapped(rows, &Key<T>::said)}, members(std::move(rows)) {}
};

/// Reads what a table has into the members that its keys name. @throws InputError.
template <class T>
void read_members(const Node& table, const KeysOf<T>& keys, T& object) {
  require_table(table, keys);
  for (const Key<T>& key : keys.members) {
    const Node* node = find(table, key.said.name);
    if (node != nullptr)
      key.read(*node, object);
    else if (key.number != nullptr && key.said.default_value == required_key)
      throw missing_key(table, key.said.name, "a number");
  }
}

/// Refuses numbers out of their ranges; `prefix` is the table's own key, and a point. @throws FieldError.
template <class T>
void require_ranges(const std::string& prefix, const KeysOf<T>& keys, const T& object,
                    std::size_t blocks = 0) {
  for (const Key<T>& key : keys.members) {
    const KeyRange& range = key.range;
    const auto is_out = [&](double value) { return !(value >= range.least && value <= range.most); };
    if (key.number != nullptr && is_out(object.*key.number))
      require_between(prefix + key.said.name, object.*key.number, range.least, range.most);
    if (key.numbers == nullptr || (object.*key.numbers).empty()) continue;
    const std::vector<double>& list = object.*key.numbers;
    if (list.size() != blocks || std::ranges::any_of(list, is_out))
      require_one_each(prefix + key.said.name, list, blocks, range.least, range.most, as_long);
  }
}

}  // namespace rockstack
