#include <gtest/gtest.h>

#include "tests/analytic/proof/prover.hpp"
#include "tests/temporary_folder.hpp"

namespace rockstack::proof {
namespace {

/// A proof of a scene with one block, b/h = 1/4, unless more is said.
Proof proved_scene(const std::string& text, const ProofOptions& options = {.bits = 192}) {
  const TemporaryFolder folder;
  return prove(read_exact_scene(folder.write("scene.toml", text)), options);
}

const std::string block = "[[blocks]]\nwidth = 0.5\nheight = 2.0\ndensity = 2000\n";

std::string rectangle(const std::string& amplitude) {
  return "duration = 0.1\n" + block +
         "[ground.horizontal]\npulse = \"rectangle\"\nperiod = 0.4\namplitude = " + amplitude;
}

// g b/h = 2.4525 m/s² opens the interface.
TEST(EndOfProof, GroundThatHoldsABlockOnItsLimitDecidesNothing) {
  const Proof proof = proved_scene(rectangle("2.4525"));
  EXPECT_FALSE(proof.whole);
  EXPECT_TRUE(proof.events.empty());
  EXPECT_EQ(proof.end, "pattern L is on its limit");
}

TEST(EndOfProof, GroundBelowTheLimitMovesNothing) {
  const Proof proof = proved_scene(rectangle("2.4524999999999"));
  EXPECT_TRUE(proof.whole);
  EXPECT_TRUE(proof.events.empty());
}

TEST(EndOfProof, GroundAboveTheLimitOpensAtOnce) {
  const Proof proof = proved_scene(rectangle("2.4525000000001"));
  EXPECT_TRUE(proof.whole);
  ASSERT_FALSE(proof.events.empty());
  EXPECT_EQ(proof.events[0].kind, EventKind::opening);
  EXPECT_EQ(letters(proof.events[0].to), "L");
}

TEST(EndOfProof, BlockBeyondItsBalanceTopples) {
  const Proof proof = proved_scene("duration = 10.0\n" + block + "[initial]\nangles = [0.3]\n");
  EXPECT_TRUE(proof.whole);
  ASSERT_EQ(proof.events.size(), 1);
  EXPECT_EQ(proof.events[0].kind, EventKind::topple);
  const Precision bits(192);
  const Ball limit = (arctangent(Ball(1), Ball(4)) + half_turn() / 2) / 2;
  EXPECT_TRUE(arb_overlaps(proof.events[0].angles[0].data(), limit.data()));
}

TEST(EndOfProof, FewBitsAreUsedUp) {
  const Proof proof = proved_scene("duration = 10.0\n" + block + "[initial]\nangles = [0.1]\n", {.bits = 70});
  EXPECT_FALSE(proof.whole);
}

TEST(EndOfProof, ScenesOfOtherLawsAreRefused) {
  EXPECT_THROW(proved_scene("duration = 1.0\nlaw = \"unilateral\"\n" + block), std::runtime_error);
  EXPECT_THROW(proved_scene("duration = 1.0\nequations = \"linear\"\n" + block), std::runtime_error);
  EXPECT_THROW(proved_scene("duration = 1.0\nrestitution = [0.9]\n" + block), std::runtime_error);
}

}  // namespace
}  // namespace rockstack::proof
