#include <gtest/gtest.h>

#include "analytic/scene/input/overrides.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "tests/analytic/scene/input/scene_text.hpp"

namespace rockstack {
namespace {

Node number_node(double value) {
  Node node;
  node.kind = Node::Kind::number;
  node.number = value;
  node.place = "here";
  return node;
}

SceneDocument document_of(const std::string& ground) {
  const TemporaryFolder folder;
  return read_document(folder.write("scene.toml", two_blocks() + ground));
}

TEST(OneLine, HasNothingThatControlsATerminalOrBreaksALine) {
  EXPECT_EQ(one_line("θ = 0.1 rad, 日本, \U0001f9f1"), "θ = 0.1 rad, 日本, \U0001f9f1");
  EXPECT_EQ(one_line(std::string("a\x1b[2J\n\0\x7f", 8)), "a\\x1b[2J\\x0a\\x00\\x7f");
  EXPECT_EQ(one_line("\u009b2J \u2028 \u202e"), "\\xc2\\x9b2J \\xe2\\x80\\xa8 \\xe2\\x80\\xae");
  // No UTF-8: a byte that none begins with, a letter cut short, one that is longer than it need be, a
  // surrogate.
  for (const char* text : {"\xff", "\xe2\x80", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\x80"})
    EXPECT_TRUE(one_line(text).starts_with("\\x")) << one_line(text);
}

TEST(OneLine, KeepsAsManyLettersAsThereMayBe) {
  EXPECT_EQ(one_line("θθθ", 3), "θθθ");
  EXPECT_EQ(one_line("θθθθ", 3), "θθ…");
  EXPECT_EQ(one_line("a\n\n", 5), "a…");
  EXPECT_EQ(one_line("", 3), "");
}

TEST(Document, AValueThatIsSetReadsAsIfTheFileHadIt) {
  SceneDocument document = document_of("");
  MotionLibrary library;
  for (const double height : {3.0, 0.7}) {
    set_value(document.root, "blocks.2.height", number_node(height));
    set_value(document.root, "engine.friction", number_node(height));
    const Scene scene = make_scene(document, library);
    EXPECT_EQ(scene.blocks[1].half_height, height / 2);
    EXPECT_EQ(scene.blocks[1].mass, 2500 * height);
    EXPECT_EQ(scene.engine.friction, height);
  }
}

TEST(Document, AValueOutOfRangeIsNamedByThePlaceThatSetIt) {
  SceneDocument document = document_of("");
  MotionLibrary library;
  set_value(document.root, "blocks.2.height", number_node(-1));
  try {
    make_scene(document, library);
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "here: blocks.2.height = -1: must be a number from 1e-20 to 1e+20");
  }
  EXPECT_THROW(set_value(document.root, "blocks.3.height", number_node(1)), InputError);
  EXPECT_THROW(set_value(document.root, "blocks..height", number_node(1)), InputError);
}

TEST(MotionLibrary, SharedSyntheticMotionsAreThoseOfTheirOwnScenes) {
  const std::string ground = "[ground.horizontal]\nsynthetic = 3\npeak = 2.5\nduration = 4\n";
  MotionLibrary library;
  const SceneDocument document = document_of(ground);
  const GroundMotion first = make_scene(document, library).horizontal;
  const GroundMotion again = make_scene(document, library).horizontal;
  EXPECT_EQ(first.samples, again.samples);
  EXPECT_EQ(first.samples, make_synthetic({.seed = 3, .peak = 2.5, .duration = 4}).samples);
}

TEST(MotionLibrary, MotionsAreKeptUntilThereIsNoRoom) {
  const SyntheticMotion one{.seed = 1, .peak = 1, .duration = 1};
  const SyntheticMotion other{.seed = 2, .peak = 1, .duration = 1};
  MotionLibrary library(100 * sizeof(double));  // less than one of 101 samples: the latest alone stays
  const auto first = library.synthetic(one);
  EXPECT_EQ(library.synthetic(one), first);
  library.synthetic(other);
  const auto made_again = library.synthetic(one);
  EXPECT_NE(made_again, first);
  EXPECT_EQ(made_again->samples, first->samples);
}

}  // namespace
}  // namespace rockstack
