#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engines/contact_point.hpp"
#include "engines/parameters.hpp"
#include "engines/setup.hpp"
#include "engines/shaking.hpp"

namespace rockstack {

/// Where a body is and how it moves. SI units, angles anticlockwise.
struct PlanarState {
  double x = 0, y = 0, angle = 0;
  double velocity_x = 0, velocity_y = 0, angular_velocity = 0;
};

/// A stack inside Simbody, whose headers are C++17: as C++20 their comparisons are ambiguous. So this header
/// is C++17 as well.
class SimbodyWorld {
 public:
  /// Precondition: `parameters` are checked.
  /// @throws std::exception with the library's own error, as all of these do.
  SimbodyWorld(const Setup& setup, const Parameters& parameters);
  SimbodyWorld(const SimbodyWorld&) = delete;
  SimbodyWorld& operator=(const SimbodyWorld&) = delete;
  ~SimbodyWorld();

  void step(const ShakingStep& shaking);
  PlanarState block(std::size_t k) const;
  std::vector<ContactPoint> contacts() const;

 private:
  struct Content;

  std::size_t steps_ = 0;
  std::unique_ptr<Content> content_;
};

}  // namespace rockstack
