#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rockstack {

/// What `make` gives of each part of a list, a function or a member.
template <class List, class Make>
auto mapped(const List& list, Make make) {
  std::vector<std::decay_t<decltype(std::invoke(make, *list.begin()))>> made;
  made.reserve(list.size());
  std::transform(list.begin(), list.end(), std::back_inserter(made),
                 [&](const auto& part) { return std::invoke(make, part); });
  return made;
}

/// The texts of the parts of a list, one after the other.
template <class List, class Text>
std::string joined_texts(const List& list, Text text, const std::string& between = "") {
  std::string all;
  for (const auto& part : list) all += (all.empty() ? "" : between) + text(part);
  return all;
}

/// The part of that name. Precondition: it is there.
template <class List>
const auto& part_named(const List& list, const std::string& name) {
  return *std::find_if(list.begin(), list.end(), [&](const auto& part) { return part.name == name; });
}

/// The first part that is so, or where there is none, a new one at the end.
template <class Part, class Is>
Part& found_or_added(std::vector<Part>& list, const Is& is, Part added) {
  const auto found = std::find_if(list.begin(), list.end(), is);
  return found == list.end() ? list.emplace_back(std::move(added)) : *found;
}

/// The largest absolute value; 0 where there is none.
inline double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace rockstack
