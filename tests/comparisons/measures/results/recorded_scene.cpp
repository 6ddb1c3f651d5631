#include <gtest/gtest.h>

#include "analytic/scene/input/page_scene.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "comparisons/measures/results/provenance.hpp"
#include "comparisons/suites/shipped.hpp"
#include "comparisons/suites/suite.hpp"

namespace rockstack {
namespace {

/// All of a scene but what its record's file said of itself, which is in no page.
Json fields_without_sources(Scene scene) {
  for (GroundMotion* motion : {&scene.horizontal, &scene.vertical}) {
    motion->source.clear();
    motion->made_up = {};
  }
  return scene_fields(scene);
}

TEST(RecordedScenes, AreTheScenesToTheBit) {
  const auto names = shipped_names("scenes");
  ASSERT_FALSE(names.empty());
  for (const std::string& name : names) {
    const NamedScene made = read_named_scene(find_file(name, "scenes"), {"title=Of a \"page\""});
    const Json held{{"page", page_text(made.document, made.scene)}};
    EXPECT_EQ(fields_without_sources(recorded_scene(held, "", "results")), fields_without_sources(made.scene))
        << name;
  }
}

TEST(RecordedScenes, OfNoPageAreReadOfTheirFileWithoutTheGround) {
  const NamedScene made = read_named_scene(find_file("spanos-el-centro", "scenes"), {});
  const Scene scene = recorded_scene(Json::object(), made.text, "results");
  EXPECT_TRUE(scene.horizontal.empty());
  EXPECT_EQ(scene.blocks.size(), made.scene.blocks.size());
  EXPECT_EQ(scene.title, made.scene.title);
}

TEST(RecordedScenes, AreRefusedByThePlaceThatHoldsThem) {
  for (const char* page : {"{", "[]", R"({"duration": 1, "blocks": [{"width": -1}]})"}) try {
      recorded_scene({{"page", page}}, "", "out/comparison.json");
      ADD_FAILURE() << page;
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with("out/comparison.json: ")) << error.what();
    }
}

}  // namespace
}  // namespace rockstack
