#pragma once

#include <pybind11/numpy.h>

#include <cstring>
#include <tuple>

#include "analytic/scene/lists.hpp"
#include "comparisons/interfaces/python/module.hpp"

namespace rockstack::python {

// Numbers as numpy has them.

using Shape = std::vector<py::ssize_t>;

/// A read-only array of numbers that `owner` keeps, and which keeps `owner`; a single row unless `shape` says
/// otherwise.
template <class Number>
py::array view(const std::vector<Number>& numbers, const py::object& owner, const Shape& shape = {}) {
  py::array_t<Number> array(shape.empty() ? Shape{static_cast<py::ssize_t>(numbers.size())} : shape,
                            numbers.data(), owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// An array of its own.
template <class Number>
py::array_t<Number> copied(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

// Values as the readers of files take them.

/// A value read into `target`: mappings are tables, sequences and arrays are arrays, and keys whose value is
/// None are left out. `depth`: in how many levels it lies. @throws InputError for what no file can hold.
void read_value(const py::handle& value, Node& target, int depth = 0);

/// The top of a document from a mapping; `place` is what messages say in place of file and line.
Node read_document(const py::handle& mapping, const std::string& place);

/// Node as Python has it: dict, list, float, str.
py::object to_python(const Node& node);

// Values as bytes and back, for processes that hand each other what they have computed; of one build, as
// numbers are written as they lie in memory.

template <class Value, class Kind>
concept A = std::is_same_v<std::remove_const_t<Value>, Kind>;

auto fields_of(A<Event> auto& event) {
  return std::tie(event.time, event.kind, event.interface, event.from, event.to, event.angles, event.before,
                  event.after, event.consistency, event.count, event.approach, event.centres);
}

auto fields_of(A<History> auto& history) {
  return std::tie(history.blocks, history.times, history.angles, history.velocities, history.patterns,
                  history.events, history.grazes, history.choices, history.slips, history.gaps,
                  history.centres, history.centre_velocities, history.reactions, history.spring_energies,
                  history.peaks, history.uplifts, history.slips_left, history.largest_slips, history.lifts,
                  history.forces, history.impulses);
}

/// Without its scene.
auto fields_of(A<HeldMotion> auto& motion) {
  return std::tie(motion.history, motion.support.sinking, motion.support.fallen);
}

auto fields_of(A<GroundMotion> auto& motion) {
  return std::tie(motion.interval, motion.samples, motion.source, motion.made_up, motion.pulse, motion.steps);
}

template <class List>
constexpr bool is_list = requires(List list) {
  list.resize(1);
};

template <class Value>
constexpr bool is_optional = requires(Value value) {
  value.has_value();
};

// Whether a value is one that its type has.
bool is_known(const bool& value);
bool is_known(EventKind kind);
bool is_known(Consistency consistency);
bool is_known(const Pattern& pattern);
bool is_known(const BasicGraze<double>& graze);
bool is_known(const Pulse& pulse);

/// @throws InputError where bytes are not those of packed().
void require_packed(bool whole);

template <class Value>
void pack(const Value& value, std::string& bytes) {
  if constexpr (is_optional<Value>) {
    pack(value.has_value(), bytes);
    if (value) pack(*value, bytes);
  } else if constexpr (std::is_trivially_copyable_v<Value>) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  } else if constexpr (is_list<Value>) {
    pack(value.size(), bytes);
    for (const auto& element : value) pack(element, bytes);
  } else {
    std::apply([&](const auto&... fields) { (pack(fields, bytes), ...); }, fields_of(value));
  }
}

/// Takes a value off the front of some bytes. @throws InputError where they end in it, or are none.
template <class Value>
void unpack(Value& value, std::string_view& bytes) {
  if constexpr (is_optional<Value>) {
    bool there = false;
    unpack(there, bytes);
    if (there) unpack(value.emplace(), bytes);
  } else if constexpr (std::is_trivially_copyable_v<Value>) {
    require_packed(bytes.size() >= sizeof value);
    std::memcpy(static_cast<void*>(&value), bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    if constexpr (requires { is_known(value); }) require_packed(is_known(value));
  } else if constexpr (is_list<Value>) {
    std::size_t size = 0;
    unpack(size, bytes);
    while (value.size() < size) {  // which may be anything: bytes end first
      value.resize(value.size() + 1);
      unpack(value.back(), bytes);
    }
  } else {
    std::apply([&](auto&... fields) { (unpack(fields, bytes), ...); }, fields_of(value));
  }
}

/// A number that other bytes hardly share, and none that differ by one (FNV-1a).
std::uint64_t checksum(std::string_view bytes);

template <class Value>
py::bytes packed(const Value& value) {
  std::string bytes;
  pack(value, bytes);
  pack(checksum(bytes), bytes);
  return bytes;
}

/// @throws InputError for other bytes than packed() gives.
template <class Value>
Value unpacked(const py::bytes& packed) {
  auto bytes = packed.cast<std::string_view>();
  std::uint64_t sum = 0;
  require_packed(bytes.size() >= sizeof sum);
  std::string_view last = bytes.substr(bytes.size() - sizeof sum);
  unpack(sum, last);
  bytes.remove_suffix(sizeof sum);
  require_packed(sum == checksum(bytes));
  Value value;
  unpack(value, bytes);
  require_packed(bytes.empty());
  return value;
}

}  // namespace rockstack::python
