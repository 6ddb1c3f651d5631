#include <gtest/gtest.h>
#include <sys/stat.h>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/input/scene_file.hpp"
#include "analytic/scene/input/toml_reader.hpp"
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
    EXPECT_EQ(friction_of(scene).back(), height);
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

TEST(Document, TextsReadAsTheyWereWritten) {
  std::string all = "ä\u0007";
  for (char letter = 1; letter != '\x7f'; ++letter) all += letter;
  for (const std::string& text :
       {all + '\x7f', std::string("a\0b", 3), std::string("'\"\"\"\\"), std::string()}) {
    const auto node = parse_toml_value(toml_text(text), Node());
    ASSERT_TRUE(node) << toml_text(text);
    EXPECT_EQ(node->text, text);
    EXPECT_EQ(toml_text(text).find_first_of("\n\r\x7f"), std::string::npos);
  }
}

/// What is said of an input that has more levels than any may have.
template <class Read>
std::string complaint(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// Whatever reads, copies or frees a value goes down level by level: each of these ended the program.
TEST(Levels, AreLimitedInEveryFormOfInput) {
  const TemporaryFolder folder;
  using nlohmann::ordered_json;
  for (const std::size_t levels : {33, 1000, 150'000}) {
    const std::string open(levels, '['), close(levels, ']'), one(levels, '\x91');
    const auto binary = nlohmann::json::input_format_t::msgpack;
    EXPECT_EQ(complaint([&] { parse_json(open + close, "the page: "); }),
              "the page: has more than 32 levels");
    EXPECT_EQ(complaint([&] { parse_bytes<nlohmann::json>(one + '\1', binary, "the message "); }),
              "the message has more than 32 levels");
    const auto file = folder.write("deep.json", R"({"a": )" + open + close + "}");
    EXPECT_EQ(complaint([&] { read_json(file); }), file.string() + ": has more than 32 levels");
    const auto scene = folder.write("deep.toml", "duration = 1\na = " + open + close + "\n");
    EXPECT_TRUE(complaint([&] { read_toml(scene); }).starts_with(scene.string() + ":2: must be TOML"));
    Node root;
    EXPECT_NE(complaint([&] { apply_override(root, "a=" + open + close); }), "") << "a text, or an error";
  }
  const std::string most = std::string(32, '[') + std::string(32, ']');
  EXPECT_EQ(parse_json(most, "").dump(), most);
}

TEST(Json, WhatIsWrongInAFileIsOneLineThatNamesIt) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& text) {
    const auto file = folder.write("a.json", text);
    const std::string line = complaint(
        [&] { read_json(file, [](const auto& json) { return json.at("key").template get<double>(); }); });
    EXPECT_TRUE(line.starts_with(file.string() + ": ")) << line;
    return line.substr(file.string().size() + 2);
  };
  EXPECT_EQ(said(""), "is cut short, after 0 bytes");
  EXPECT_EQ(said(R"({"key": 1)"), "is cut short, after 9 bytes");
  EXPECT_EQ(said("{'key': 1}"), "is no JSON from byte 2 on");
  EXPECT_EQ(said("{}"), "key 'key' not found");
  EXPECT_EQ(said(R"({"key": "1"})"), "type must be number, but is string");
  EXPECT_EQ(complaint([&] { read_json(folder.path() / "none"); }),
            (folder.path() / "none").string() + ": must be a file, nothing is there");
}

TEST(Json, FilesWithoutAnEndAreRefused) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/zero", folder.path() / "device");
  std::filesystem::create_directory(folder.path() / "folder");
  ASSERT_EQ(mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  for (const char* name : {"device", "folder", "pipe"})
    EXPECT_EQ(complaint([&] { read_json(folder.path() / name); }),
              (folder.path() / name).string() + ": must be a file, this is a folder, a pipe or a device");
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
