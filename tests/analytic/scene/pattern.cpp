#include "analytic/scene/pattern.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/scene/history.hpp"

namespace rockstack {
namespace {

Pattern two(Contact lower, Contact upper) {
  Pattern pattern = closed_pattern(2);
  pattern[0] = lower;
  pattern[1] = upper;
  return pattern;
}

TEST(Pattern, TwoBlocksHaveTheNamesOfThePaper) {
  using enum Contact;
  // Spanos et al. 2001, Fig. 2.
  EXPECT_EQ(name(two(right, right)), "1a");
  EXPECT_EQ(name(two(left, left)), "1b");
  EXPECT_EQ(name(two(right, left)), "2a");
  EXPECT_EQ(name(two(left, right)), "2b");
  EXPECT_EQ(name(two(right, closed)), "3a");
  EXPECT_EQ(name(two(left, closed)), "3b");
  EXPECT_EQ(name(two(closed, right)), "4a");
  EXPECT_EQ(name(two(closed, left)), "4b");
  EXPECT_EQ(name(two(closed, closed)), "rest");
}

TEST(Pattern, OtherStacksAreSpelledFromTheGroundUp) {
  Pattern pattern = closed_pattern(3);
  EXPECT_EQ(name(pattern), "CCC");
  EXPECT_TRUE(is_closed(pattern));
  pattern[0] = Contact::left;
  pattern[2] = Contact::right;
  EXPECT_EQ(name(pattern), "LCR");
  EXPECT_FALSE(is_closed(pattern));
  EXPECT_EQ(name(closed_pattern(1)), "C");
}

/// All patterns of some blocks, whose interfaces slide one way, the other or not.
std::vector<Pattern> all_patterns(int size) {
  std::vector<Pattern> list{closed_pattern(size)};
  for (int k = 0; k < size; ++k) {
    std::vector<Pattern> longer;
    for (Pattern pattern : list)
      for (const int contact : {-1, 0, 1, 2})
        for (const int slide : {-1, 0, 1}) {
          pattern[k] = static_cast<Contact>(contact);
          pattern.slides[static_cast<std::size_t>(k)] = static_cast<std::int8_t>(slide);
          longer.push_back(pattern);
        }
    list = std::move(longer);
  }
  return list;
}

TEST(Pattern, IsWhatItsNameSays) {
  for (const int size : {1, 2, 3})
    for (const Pattern& pattern : all_patterns(size))
      EXPECT_EQ(name(named_pattern(name(pattern), size)), name(pattern));
  EXPECT_EQ(named_pattern("2b", 2), two(Contact::left, Contact::right));
  for (const char* text : {"", "L", "LCRL", "<LC", "1a", "rest", "LXR"})
    EXPECT_THROW(named_pattern(text, 3), std::invalid_argument) << text;
}

TEST(Events, AreWhatTheirNamesSay) {
  for (const EventKind kind : {EventKind::opening, EventKind::fall, EventKind::strike})
    EXPECT_EQ(named_event(name(kind)), kind);
  for (const Consistency one : {Consistency::consistent, Consistency::several, Consistency::gains})
    EXPECT_EQ(named_consistency(name(one)), one);
  EXPECT_THROW(named_event("consistent"), std::invalid_argument);
}

TEST(Pattern, OppositeSwapsTheEndsAndKeepsClosed) {
  EXPECT_EQ(opposite(Contact::left), Contact::right);
  EXPECT_EQ(opposite(Contact::right), Contact::left);
  EXPECT_EQ(opposite(Contact::closed), Contact::closed);
}

TEST(Pattern, InWordsItSaysWhatEachBlockDoes) {
  EXPECT_EQ(pattern_words(named_pattern("C<-R>", 3)),
            "block 1 flat and sliding left, block 2 in flight, block 3 leaning right and sliding right");
  EXPECT_EQ(pattern_words(named_pattern("1b", 2)), "block 1 leaning left, block 2 leaning left");
}

}  // namespace
}  // namespace rockstack
