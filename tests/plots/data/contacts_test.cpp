#include "plots/data/contacts.hpp"

#include <gtest/gtest.h>

#include "plots/data/selection.hpp"
#include "tests/plots/sample.hpp"

namespace rockstack::plots {
namespace {

using Contacts = std::vector<std::pair<int, int>>;

Contacts contacts_of(const std::string& pattern, int blocks) {
  Contacts list;
  for (const NamedContact& contact : contacts_in(pattern, blocks))
    list.emplace_back(contact.side, contact.slide);
  return list;
}

TEST(Contacts, AreReadFromBothKindsOfNames) {
  EXPECT_EQ(contacts_of("2b", 2), (Contacts{{-1, 0}, {1, 0}}));
  EXPECT_EQ(contacts_of("rest", 2), (Contacts{{0, 0}, {0, 0}}));
  EXPECT_EQ(contacts_of("C<L", 2), (Contacts{{0, -1}, {-1, 0}}));
  EXPECT_EQ(contacts_of("-R>C", 3), (Contacts{{2, 0}, {1, 1}, {0, 0}}));
  EXPECT_EQ(contacts_of("", 1), (Contacts{{0, 0}}));
}

TEST(Contacts, AreShownByArrowsAndDashes) {
  EXPECT_EQ(shown_pattern("C<-R>"), "C←–R→");
  EXPECT_EQ(shown_pattern("2b"), "2b");
}

TEST(Contacts, TellOfASceneWhetherItsFiguresHaveSlips) {
  const std::filesystem::path folder = testing::fresh_folder();
  for (const bool slides : {false, true}) {
    testing::write_sample(folder, {.slides = slides});
    const Comparison comparison = read_comparison(folder);
    EXPECT_EQ(comparison.scenes.front().slips, slides);
    EXPECT_EQ(has_column(comparison.runs.front(), "slip_2"), slides);
    EXPECT_FALSE(has_column(comparison.runs.front(), "slip_"));
    EXPECT_EQ(read_contact_summary(comparison.runs.front()).interfaces.size(), slides ? 1U : 0U);
  }
}

TEST(Contacts, VariantsAreNamedByWhatTheyChange) {
  plots::Run run;
  run.engine = "friction=0.3";
  EXPECT_TRUE(is_variant(run) && has_own_friction(run));
  EXPECT_EQ(line_label(run), "exact, friction 0.3");
  run.engine = "unilateral";
  EXPECT_TRUE(is_variant(run) && !has_own_friction(run));
  EXPECT_EQ(line_label(run), "exact, law unilateral");
}

}  // namespace
}  // namespace rockstack::plots
