#include "analytic/scene/ground/motion_library.hpp"

#include <utility>

#include "analytic/scene/ground/records/record_file.hpp"
#include "analytic/scene/messages/number_text.hpp"

namespace rockstack {

template <class Make>
std::shared_ptr<const GroundMotion> MotionLibrary::kept(const std::string& name, const Make& make) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = motions_.find(name);
    if (found != motions_.end()) return found->second;
  }
  // Made without the lock: two threads may make the same one, which costs time alone.
  auto motion = std::make_shared<const GroundMotion>(make());
  const std::lock_guard lock(mutex_);
  const auto [place, added] = motions_.emplace(name, motion);
  if (!added) return place->second;
  order_.push_back(name);
  size_ += motion->samples.size() * sizeof(double);
  while (size_ > capacity_ && order_.size() > 1) {
    const auto oldest = motions_.find(order_.front());
    size_ -= oldest->second->samples.size() * sizeof(double);
    motions_.erase(oldest);
    order_.pop_front();
  }
  return motion;
}

std::shared_ptr<const GroundMotion> MotionLibrary::record(const std::filesystem::path& name) {
  return kept("record " + name.string(), [&] {
    Record record = read_record(name, RecordLimits::none);
    return GroundMotion{record.interval, std::move(record.samples), description(record)};
  });
}

std::shared_ptr<const GroundMotion> MotionLibrary::synthetic(const SyntheticMotion& motion) {
  std::string name = "synthetic " + std::to_string(motion.seed);
  for (const double number : {motion.duration, motion.interval, motion.frequency, motion.damping})
    name += " " + number_text(number);
  return kept(name, [&] {
    SyntheticMotion unit = motion;
    unit.peak = 1;
    return make_synthetic(unit);
  });
}

}  // namespace rockstack
