// What the library of em++ 3.1 lacks of C++20, put before each file; a later one has its own.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <functional>

namespace std {

#ifndef __cpp_lib_to_chars
inline to_chars_result written(char* first, const string& text) {
  return {copy(text.begin(), text.end(), first), errc()};
}
inline to_chars_result to_chars(char* first, char*, double value) {
  return written(first, fmt::format("{}", value));
}
inline to_chars_result to_chars(char* first, char*, double value, chars_format form, int precision) {
  return written(first, form == chars_format::fixed ? fmt::format("{:.{}f}", value, precision)
                                                    : fmt::format("{:.{}g}", value, precision));
}
#endif

#ifndef __cpp_lib_bit_cast
template <class To, class From>
To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  memcpy(&to, &from, sizeof to);
  return to;
}
#endif

#ifndef __cpp_lib_ranges
namespace ranges {
template <class Range, class Value, class Member = identity>
auto find(Range&& range, const Value& value, Member member = {}) {
  return std::find_if(range.begin(), range.end(),
                      [&](const auto& one) { return invoke(member, one) == value; });
}
template <class Range, class Holds>
auto find_if(Range&& range, Holds holds) {
  return std::find_if(range.begin(), range.end(), holds);
}
template <class Range, class Holds>
bool all_of(Range&& range, Holds holds) {
  return std::all_of(range.begin(), range.end(), holds);
}
template <class Range, class Holds>
bool any_of(Range&& range, Holds holds) {
  return std::any_of(range.begin(), range.end(), holds);
}
template <class Less, class Member>
auto by(Less less, Member member) {
  return [=](const auto& a, const auto& b) { return less(invoke(member, a), invoke(member, b)); };
}
template <class Range, class Less = std::less<>, class Member = identity>
void stable_sort(Range& range, Less less = {}, Member member = {}) {
  std::stable_sort(range.begin(), range.end(), by(less, member));
}
template <class Range, class Less = std::less<>, class Member = identity>
auto min_element(Range&& range, Less less = {}, Member member = {}) {
  return std::min_element(range.begin(), range.end(), by(less, member));
}
template <class Range, class Less = std::less<>, class Member = identity>
auto max_element(Range&& range, Less less = {}, Member member = {}) {
  return std::max_element(range.begin(), range.end(), by(less, member));
}
}  // namespace ranges
#endif

}  // namespace std
