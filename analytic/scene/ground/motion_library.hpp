#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

#include "analytic/scene/ground/synthetic.hpp"

namespace rockstack {

/// Records and synthetic motions that many scenes share: each is read or made once and kept, until those kept
/// hold more than `capacity` bytes and the oldest go. May be asked from several threads at once.
class MotionLibrary {
 public:
  explicit MotionLibrary(std::size_t capacity = std::size_t{256} << 20U) : capacity_(capacity) {}

  /// A record as its file has it; the name as for read_record(). @throws InputError likewise.
  std::shared_ptr<const GroundMotion> record(const std::filesystem::path& name);

  /// A synthetic motion with a peak of 1 m/s²; its own peak does not count.
  std::shared_ptr<const GroundMotion> synthetic(const SyntheticMotion& motion);

 private:
  template <class Make>
  std::shared_ptr<const GroundMotion> kept(const std::string& name, const Make& make);

  std::mutex mutex_;
  std::size_t capacity_;
  std::size_t size_ = 0;  ///< bytes
  std::map<std::string, std::shared_ptr<const GroundMotion>> motions_;
  std::deque<std::string> order_;  ///< of their arrival
};

}  // namespace rockstack
