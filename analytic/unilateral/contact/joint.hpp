#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rockstack {

/// Where the block above an interface touches what is below: nowhere, at the left or right end of their
/// overlap, or along all of it.
enum class Touch : std::int8_t { left = -1, flat = 0, right = 1, apart = 2 };

/// The contact of one interface under Coulomb friction.
///
/// The offset s is how far the middle of the block above has slipped to the right along the face below. After
/// it the faces overlap on [max(−b, −b' − s), min(b, b' − s)] from the middle of the block above, b and b'
/// the half-widths above and below. A pivot is an end of that overlap: a corner of the block above on the
/// face below, or a corner of the block below under the face above; the face gives the normal.
template <class Real>
struct BasicJoint {
  Touch touch = Touch::flat;
  int slip = 0;               ///< the way the upper block slides: −1 left, 1 right; 0: it sticks
  bool corner_below = false;  ///< the pivot is a corner of the block below
  Real offset = 0;            ///< s, m, while it touches

  bool touches() const { return touch != Touch::apart; }
  bool sticks() const { return touches() && slip == 0; }
  bool pivots() const { return touch == Touch::left || touch == Touch::right; }
  /// The end that the pivot is at, −1 or 1; 0 where there is no pivot.
  int side() const { return pivots() ? static_cast<int>(touch) : 0; }
  /// The same contact, wherever it has slipped to.
  bool same_mode(const BasicJoint& other) const {
    return touch == other.touch && slip == other.slip && (corner_below == other.corner_below || !pivots());
  }
};

using Joint = BasicJoint<double>;

/// The joints of all interfaces, from the ground up: a mode.
template <class Real>
using Joints = std::vector<BasicJoint<Real>>;

/// One letter an interface from the ground up, L, C or R, and "-" where it is apart; an arrow after it shows
/// the way that the block above slides.
template <class Real>
std::string name(const Joints<Real>& joints) {
  std::string text;
  for (const BasicJoint<Real>& joint : joints) {
    text += joint.touch == Touch::apart ? '-' : "LCR"[static_cast<int>(joint.touch) + 1];
    if (joint.touches() && joint.slip != 0) text += joint.slip > 0 ? '>' : '<';
  }
  return text;
}

}  // namespace rockstack
