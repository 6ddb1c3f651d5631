#pragma once

#include "analytic/unilateral/contact_modes.hpp"

namespace rockstack {

/// Chatter ends as in analytic/events/chatter.hpp: where what an impact parts would part no further than the
/// resolution ρ before it comes back, u²/(2a) ≤ ρ, or at 500 ε √(g/H), it stays together. Gaps count as what
/// they would turn a block by across its width.
class ContactChatter {
 public:
  ContactChatter(const FrictionStack& stack, double gravity, double resolution);

  double settling_speed() const { return settling_speed_; }

  /// Open by what rounding makes of angles and speeds.
  bool negligibly_open(const Joint& joint, double angle, double angle_rate) const;

  /// A mode that follows an impact of `touching`, with the joints held that part too slowly to be followed.
  /// `free` is the acceleration without contact.
  std::vector<Joint> without_slow(const std::vector<Joint>& touching, const std::vector<Joint>& mode,
                                  const Bodies& after, const FreeVector& free) const;

 private:
  bool parts_slowly(int interface, const Joint& touching, const Joint& mode, const Bodies& after,
                    const FreeVector& acceleration) const;

  const FrictionStack& stack_;
  double resolution_;      ///< rad
  double rate_;            ///< g/H, 1/s²
  double settling_speed_;  ///< rad/s
};

}  // namespace rockstack
