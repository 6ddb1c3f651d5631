#pragma once

#include <nlohmann/json.hpp>

#include "analytic/scene/input/document.hpp"
#include "analytic/scene/input/json.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

// A scene on a page is JSON with the keys and values of a scene file; the number inf is the text "inf".

/// A scene file's document, or a part of it, as a page has it.
Json page_scene(const Node& document);

/// A text, a number or an array of them as TOML.
std::string toml_value(const Json& value);

/// The scene file that a scene on a page stands for.
std::string scene_text(const Json& scene);

/// And back; every value has that place. @throws InputError for what is nested too deeply.
Node scene_document(const Json& scene, const std::string& place = "the page");

/// The text of a scene made of a document, for a page that can read no file: sampled ground motions are there
/// as samples, as they act. Empty for a document that is.
std::string page_text(const Node& document, const Scene& scene);

}  // namespace rockstack
