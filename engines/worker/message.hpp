#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace rockstack {

// The binary form in which program and worker talk, both on one machine: every number takes eight bytes as
// the processor holds them (whole numbers and choices as 64-bit integers, others as doubles, so that no bit
// is lost); a text, list or map is its length and then its items; an optional value is 0, or 1 and the value;
// a struct is its fields, in the order in which fields(struct) gives them.

template <class Value>
concept WholeNumber = std::integral<Value> || std::is_enum_v<Value>;

class MessageWriter {
 public:
  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  void write(double value) { append(&value, sizeof value); }
  void write(WholeNumber auto value) {
    const auto wide = static_cast<std::int64_t>(value);
    append(&wide, sizeof wide);
  }
  void write(const std::string& text) {
    write(text.size());
    bytes_ += text;
  }
  void write(const std::vector<double>& values) {
    write(values.size());
    append(values.data(), values.size() * sizeof(double));
  }
  template <class Value>
  void write(const std::vector<Value>& values) {
    write(values.size());
    for (const Value& value : values) write(value);
  }
  void write(const std::map<std::string, double>& values) {
    write(values.size());
    for (const auto& [key, value] : values) (*this)(key, value);
  }
  template <class Value>
  void write(const std::optional<Value>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <class Value>
  requires std::is_class_v<Value>
  void write(const Value& value) { std::apply(*this, fields(value)); }

  std::string bytes_;
};

/// Reads what MessageWriter wrote. @throws std::runtime_error where the message ends too early.
class MessageReader {
 public:
  explicit MessageReader(std::string_view bytes) : rest_(bytes) {}
  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }

 private:
  void take(void* data, std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("the message is cut short");
    std::memcpy(data, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  std::size_t length(std::size_t item) {
    std::uint64_t count = 0;
    take(&count, sizeof count);
    if (count > rest_.size() / item) throw std::runtime_error("the message is cut short");
    return count;
  }
  void read(double& value) { take(&value, sizeof value); }
  template <WholeNumber Value>
  void read(Value& value) {
    std::int64_t wide = 0;
    take(&wide, sizeof wide);
    value = static_cast<Value>(wide);
  }
  void read(std::string& text) {
    text.resize(length(1));
    take(text.data(), text.size());
  }
  void read(std::vector<double>& values) {
    values.resize(length(sizeof(double)));
    if (!values.empty()) take(values.data(), values.size() * sizeof(double));
  }
  template <class Value>
  void read(std::vector<Value>& values) {
    values.resize(length(1));
    for (Value& value : values) read(value);
  }
  void read(std::map<std::string, double>& values) {
    for (std::size_t left = length(1); left > 0; --left) {
      std::string key;
      read(key);
      read(values[key]);
    }
  }
  template <class Value>
  void read(std::optional<Value>& value) {
    bool there = false;
    read(there);
    if (there) read(value.emplace());
  }
  template <class Value>
  requires std::is_class_v<Value>
  void read(Value& value) { std::apply(*this, fields(value)); }

  std::string_view rest_;
};

}  // namespace rockstack
