#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace rockstack {

/// A list of so few entries that most need no heap memory: those beyond `few` do. Entries that are numbers
/// have no value until they are given one.
template <class T, std::size_t few = 4>
class ShortVector {
 public:
  ShortVector() {}
  explicit ShortVector(std::size_t size) { resize(size); }
  ShortVector(std::size_t size, const T& value) {
    resize(size);
    std::fill(begin(), end(), value);
  }
  ShortVector(std::initializer_list<T> values) { assign(values.begin(), values.size()); }
  ShortVector(const ShortVector& other) { assign(other.begin(), other.size_); }
  ShortVector(ShortVector&& other) noexcept { take(other); }
  ShortVector& operator=(const ShortVector& other) {
    if (this != &other) assign(other.begin(), other.size_);
    return *this;
  }
  ShortVector& operator=(ShortVector&& other) noexcept {
    if (this != &other) {
      release();
      take(other);
    }
    return *this;
  }
  ~ShortVector() { release(); }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  T& back() { return data_[size_ - 1]; }
  const T& front() const { return data_[0]; }

  void push_back(T value) {
    if (size_ == room_) reserve(2 * room_);
    data_[size_++] = std::move(value);
  }
  /// New entries are those of the type without a value.
  void resize(std::size_t size) {
    if (size > room_) reserve(std::max(size, 2 * room_));
    size_ = size;
  }

 private:
  void reserve(std::size_t room) {
    T* larger = new T[room];
    std::move(begin(), end(), larger);
    release();
    data_ = larger;
    room_ = room;
  }
  void assign(const T* values, std::size_t size) {
    resize(size);
    std::copy_n(values, size, data_);
  }
  /// Leaves the other one empty. Precondition: this one has no heap memory.
  void take(ShortVector& other) {
    size_ = std::exchange(other.size_, 0);
    if (other.data_ == other.own_.data()) {
      std::move(other.own_.begin(), other.own_.begin() + size_, own_.begin());
      return;
    }
    data_ = std::exchange(other.data_, other.own_.data());
    room_ = std::exchange(other.room_, few);
  }
  void release() {
    if (data_ != own_.data()) delete[] data_;
    data_ = own_.data();
    room_ = few;
  }

  std::array<T, few> own_;
  T* data_ = own_.data();
  std::size_t size_ = 0, room_ = few;
};

}  // namespace rockstack
