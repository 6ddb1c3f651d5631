#pragma once

#include <functional>

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

/// A member, or the member of a member, and so on.
template <class Outer, class Value>
auto part(Value Outer::*member) {
  return [=](Outer& object) -> Value& { return object.*member; };
}
template <class Outer, class Inner, class... Members>
auto part(Inner Outer::*member, Members... members) {
  return [=](Outer & object) -> auto& {
    return part(members...)(object.*member);
  };
}

/// A key of a table whose values are a T: which member it is, and what that may be. A default is T's own.
/// Numbers of a KeyRange are checked by require_ranges(), as they need not come from a file; others are as
/// they are read.
template <class T>
struct Key {
  InputKey said;
  KeyRange range = any_number;
  double T::*number = nullptr;
  std::vector<double> T::*numbers = nullptr;  ///< one for each block, or none
  std::function<void(const Node& node, T&)> read_other = nullptr;
  std::string needed = "";  ///< what it must be where it is required and missing; empty: T's reader knows

  /// A key that its table's reader takes by itself.
  Key(const char* name, const char* example, const char* unit, const char* allowed, const char* otherwise,
      const char* meaning)
      : said{name, example, unit, allowed, otherwise, meaning} {}
  /// A number: required, or with what a new T has.
  Key(const char* name, const char* example, const char* unit, const KeyRange& allowed, const char* meaning,
      double T::*member, const UsualNumbers& usual = {})
      : said{name, example, unit, allowed.words, number_text(T().*member), meaning, usual},
        range(allowed),
        number(member) {}
  Key(const char* name, const char* example, const char* unit, const KeyRange& allowed, const char* needed,
      const char* meaning, double T::*member, const UsualNumbers& usual = {})
      : said{name, example, unit, allowed.words, needed, meaning, usual},
        range(allowed),
        number(member),
        needed("a number") {}
  Key(const char* name, const char* example, const char* unit, const KeyRange& allowed, const char* otherwise,
      const char* meaning, std::vector<double> T::*member, const UsualNumbers& usual = {})
      : said{name, example, unit, allowed.words, otherwise, meaning, usual},
        range(allowed),
        numbers(member) {}
  /// A number that is checked as it is read, or a text, of the member at `place`.
  template <class Place>
  Key(const char* name, const char* example, const char* unit, const CheckedNumber& allowed,
      const std::string& otherwise, const char* meaning, const Place& place, const UsualNumbers& usual = {})
      : said{name, example, unit, allowed.words, otherwise, meaning, usual},
        read_other([=](const Node& node, T& object) {
          auto& value = std::invoke(place, object);
          value = static_cast<std::remove_reference_t<decltype(value)>>(allowed.read(node));
        }),
        needed(allowed.needed) {}
  template <class Place>
  Key(const char* name, const char* example, const char* unit, const CheckedNumber& allowed,
      const char* meaning, const Place& place)
      : Key(name, example, unit, allowed, default_at(place), meaning, place) {}
  template <class Place>
  Key(const char* name, const char* example, const char* unit, const char* allowed, const char* otherwise,
      const char* meaning, const Place& place)
      : said{name, example, unit, allowed, otherwise, meaning},
        read_other([=](const Node& node, T& object) { std::invoke(place, object) = text(node); }),
        needed("a text") {}
  /// One of a few names, in the order of an enumeration; `beside` says what else the range has.
  template <class Choice>
  Key(const char* name, const char* example, const std::vector<NamedChoice>& choices, const char* meaning,
      Choice T::*member, const char* beside = "")
      : Key(name, example, choices, meaning) {
    said.range += beside;
    said.default_value = quoted(choices[static_cast<std::size_t>(T().*member)].name);
    read_other = [=](const Node& node, T& object) {
      object.*member = static_cast<Choice>(place_among(node, mapped(choices, &NamedChoice::name)));
    };
  }
  /// One that is required, and that its table's reader takes by itself.
  Key(const char* name, const char* example, const std::vector<NamedChoice>& choices, const char* meaning)
      : said{name, example, "", choices_text(choices), required_key, meaning, {}, choices} {}
  Key(InputKey words, std::function<void(const Node& node, T&)> read)
      : said(std::move(words)), read_other(std::move(read)) {}

  void read(const Node& node, T& object) const {
    if (number != nullptr) object.*number = rockstack::number(node);
    // Checks say what length a list that is always there must have.
    if (numbers != nullptr)
      object.*numbers = (object.*numbers).empty() ? one_each(node) : rockstack::numbers(node);
    if (read_other) read_other(node, object);
  }

  template <class Place>
  static std::string default_at(const Place& place) {
    T standard;
    return number_text(static_cast<double>(std::invoke(place, standard)));
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
    else if (!key.needed.empty() && key.said.default_value == required_key)
      throw missing_key(table, key.said.name, key.needed);
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
