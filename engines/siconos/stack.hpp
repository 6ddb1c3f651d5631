#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engines/contact_point.hpp"
#include "engines/parameters.hpp"
#include "engines/setup.hpp"
#include "engines/shaking.hpp"

namespace rockstack {

/// A scene inside Siconos. This header is read by sources of C++17 as well: Siconos's headers are no C++20.
class SiconosStack {
 public:
  /// Precondition: `parameters` are checked.
  SiconosStack(const Setup& setup, const Parameters& parameters);
  ~SiconosStack();
  SiconosStack(const SiconosStack&) = delete;
  SiconosStack& operator=(const SiconosStack&) = delete;

  void step(const ShakingStep& shaking);

  /// Where a block is and how it moves; angles do not wrap.
  const std::vector<Placement>& blocks() const { return blocks_; }

  void watch() { watched_ = true; }
  const std::vector<ContactPoint>& contacts() const { return contacts_; }

  /// Steps in which the solver did not reach its tolerance.
  std::size_t failures() const { return failures_; }

 private:
  struct Parts;  ///< what Siconos holds

  void add_bodies(const Setup& setup);
  void add_corners(const Setup& setup, double restitution);
  void add_scheme(const Parameters& parameters);
  void read_contacts(const std::vector<double>& gaps_before);

  std::vector<Placement> blocks_;
  std::vector<ContactPoint> contacts_;
  double mass_factor_, dt_;
  bool watched_ = false;
  std::size_t failures_ = 0;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rockstack
