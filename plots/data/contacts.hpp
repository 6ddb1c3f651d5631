#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "plots/data/results.hpp"

namespace rockstack::plots {

// What results say of contacts that slide and part.

/// How an interface touches, as a pattern's name has it.
struct NamedContact {
  int side = 0;   ///< −1 left, 0 closed, 1 right, 2 apart
  int slide = 0;  ///< the way the block above slides: −1 left, 1 right; 0: it does not
};

/// One an interface, from the ground up. What a name does not say is closed and does not slide.
std::vector<NamedContact> contacts_in(const std::string& pattern, int blocks);

/// A pattern's name for people: an arrow the way an interface slides, a dash where it is apart.
std::string shown_pattern(const std::string& name);

/// What one interface came to in a run of law `unilateral`. SI units.
struct InterfaceSlip {
  double final_slip = 0, largest_slip = 0, highest_lift = 0;
  std::size_t slips = 0, lift_offs = 0;
};

/// What a run's summary.json says of its contacts.
struct ContactSummary {
  std::vector<InterfaceSlip> interfaces;  ///< none under laws of pivots
  std::vector<std::string> warnings;      ///< of where theory has no single answer, and the like
};

/// @throws InputError naming the file that is malformed; nothing where it is missing.
ContactSummary read_contact_summary(const Run& run);

}  // namespace rockstack::plots
