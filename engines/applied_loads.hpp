#pragma once

#include <memory>
#include <vector>

#include "engines/body_state.hpp"
#include "engines/setup.hpp"

namespace rockstack {

/// Pushes and restraints of a setup, step by step: forces at points of blocks, as one load on each block.
class AppliedLoads {
 public:
  explicit AppliedLoads(const Setup& setup);
  ~AppliedLoads();
  AppliedLoads(const AppliedLoads&) = delete;
  AppliedLoads& operator=(const AppliedLoads&) = delete;

  /// Whether there are any.
  bool any() const;

  /// Over a step, from 0, that begins with these blocks, bottom to top, on this ground. Tendons remember how
  /// far they have yielded: to be called for one step after the other. Beyond the setup's steps nothing
  /// pushes.
  std::vector<BodyLoad> over_step(std::size_t step, const std::vector<BodyState>& blocks,
                                  const GroundStep& ground);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rockstack
