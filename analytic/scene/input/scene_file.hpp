#pragma once

#include "analytic/scene/ground/motion_library.hpp"
#include "analytic/scene/input/document.hpp"
#include "analytic/scene/scene.hpp"

namespace rockstack {

/// Reads a scene file (TOML, SI units). `overrides` are `key=value` texts applied in order before anything is
/// checked, e.g. "blocks.1.height=3" (blocks count from 1) or "law=consistent"; a path of a record is
/// relative to the scene file. A title left out is the file's name; initial angles and velocities left out
/// are zero. An override adds to the file and takes nothing away: setting mass where the file has density is
/// an error, as it is inside the file; likewise peak beside scale, and samples beside record.
/// @throws InputError, one line with file:line (or the override), key, value and what is allowed: unknown
/// keys, numbers out of range or not finite, wrong lengths, missing files, TOML syntax.
Scene read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// A scene file that is read but not yet understood: what many scenes that differ in a few values start from.
struct SceneDocument {
  Node root;
  std::filesystem::path folder;  ///< paths of records are relative to it
  std::string title;             ///< of scenes that say none
  std::optional<Node> measured =
      {};  ///< the table [measured]: what a test says of the scene, which is no part of it
};

/// Reads a scene file and applies overrides. @throws InputError where either is not of its form.
SceneDocument read_document(const std::filesystem::path& file,
                            const std::vector<std::string>& overrides = {});

/// The scene that a document describes; records and synthetic motions come from `library`.
/// @throws InputError as read_scene().
Scene make_scene(const SceneDocument& document, MotionLibrary& library);

/// The motion that a table [ground.horizontal] or [ground.vertical] describes: a record or samples, then
/// scaled by a factor or to a peak, or a pulse, or a synthetic motion. Paths of records are relative to
/// `folder`; records and synthetic motions come from `library`.
/// @throws InputError with place, key, value and what is allowed; FieldError for a number out of range.
GroundMotion read_ground_motion(const Node& table, const std::filesystem::path& folder,
                                MotionLibrary& library);

}  // namespace rockstack
