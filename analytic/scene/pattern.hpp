#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace rockstack {

/// The most blocks a stack may have. States and patterns live on the stack memory up to this size.
inline constexpr int max_blocks = 32;

/// How an interface touches: closed (along its whole width), or open with the pivot at its left or right end;
/// or, under laws that leave pivots (leaves_pivots()), not at all.
enum class Contact : std::int8_t { left = -1, closed = 0, right = 1, apart = 2 };

inline int sign(Contact contact) {
  return static_cast<int>(contact);
}
inline Contact opposite(Contact contact) {
  return static_cast<Contact>(-sign(contact));
}
inline Contact contact_of(int sign) {
  return static_cast<Contact>((sign > 0) - (sign < 0));
}

/// The contact state of every interface, from the ground up: the paper's "pattern", for any number of blocks.
/// Index 0 is interface 1, between the ground and the lowest block.
struct Pattern {
  int size = 0;  ///< number of blocks, 0 … max_blocks
  std::array<Contact, max_blocks> contacts{};
  std::array<std::int8_t, max_blocks> slides{};  ///< the way each slides, 1 to the right; 0: it does not

  Contact& operator[](int interface) { return contacts[interface]; }
  Contact operator[](int interface) const { return contacts[interface]; }
  bool operator==(const Pattern& other) const {
    bool same = size == other.size;
    for (std::size_t k = 0; same && k < static_cast<std::size_t>(size); ++k)
      same = contacts[k] == other.contacts[k] && slides[k] == other.slides[k];
    return same;
  }
};

/// A pattern of `size` closed interfaces: the stack at rest.
inline Pattern closed_pattern(int size) {
  return {.size = size};
}

/// True where every interface is closed.
inline bool is_closed(const Pattern& pattern) {
  for (int k = 0; k < pattern.size; ++k)
    if (pattern[k] != Contact::closed) return false;
  return true;
}

/// The name of a pattern: for two blocks that of Spanos et al. 2001, Fig. 2 ("1a" … "4b", "rest"); otherwise
/// a letter an interface from the ground up, L, C or R, and "-" where it is apart; "<" or ">" after it shows
/// the way that it slides.
std::string name(const Pattern& pattern);

/// Pattern as people read it: an arrow the way an interface slides, a dash where it is apart.
std::string shown_pattern(const Pattern& pattern);

/// Pattern in words: "block 1 flat, block 2 leaning right and sliding left", or "in flight".
std::string pattern_words(const Pattern& pattern);

/// The pattern of `size` blocks with that name. @throws std::invalid_argument where there is none.
Pattern named_pattern(std::string_view name, int size);

}  // namespace rockstack
