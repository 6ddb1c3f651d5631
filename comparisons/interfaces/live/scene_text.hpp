#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analytic/scene/input/document.hpp"

namespace rockstack::live {

// A scene on a page is JSON with the keys and values of a scene file; the text "inf" stands for that number,
// which JSON does not have.

/// A scene file's document as a page has it.
nlohmann::ordered_json page_scene(const Node& document);

/// And back; every value's place is "the page". @throws InputError for what is nested too deeply.
Node scene_document(const nlohmann::ordered_json& scene);

/// The same as the text of a scene file. Precondition: keys and values that a scene may have.
std::string scene_file_text(const nlohmann::ordered_json& scene);

/// A value as TOML: a text, a number or an array of them.
std::string toml_value(const nlohmann::ordered_json& value);

}  // namespace rockstack::live
