#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <variant>

#include "plots/data/results.hpp"
#include "plots/drawing/layout.hpp"

namespace rockstack::plots {

struct Figure;

/// What a figure of one scene is drawn of.
struct SceneSubject {
  const Figure& figure;
  const Comparison& comparison;
  const ComparedScene& scene;

  /// A sheet with the scene's title, the figure's question and the answer.
  Sheet sheet(const Legend& legend, const std::string& answer) const;
  /// The scene's title over the reason why there is nothing to show.
  Drawing nothing(const std::string& reason) const;
};

/// What a figure of all scenes of a comparison is drawn of.
struct ComparisonSubject {
  const Figure& figure;
  const Comparison& comparison;

  /// A sheet with the comparison's title.
  Sheet sheet(const Legend& legend, const std::string& answer) const;
};

/// What a figure of a folder that is no comparison is drawn of.
struct FolderSubject {
  const Figure& figure;
  const std::filesystem::path& folder;

  Sheet sheet(const std::string& title, const Legend& legend, const std::string& answer) const;
};

/// By what stands behind the figure's name in that of its file; a single drawing has nothing there.
using Drawings = std::map<std::string, Drawing>;

struct OfScene {
  bool (*needs)(const ComparedScene&);  ///< whether a scene's results have what it shows
  Drawing (*draw)(const SceneSubject&);
};

struct OfComparison {
  Drawings (*draw)(const ComparisonSubject&);
};

struct OfFolder {
  const char* needs;  ///< a file of results
  Drawings (*draw)(const FolderSubject&);
};

/// One kind of figure.
struct Figure {
  std::string name;         ///< part of the file's name
  std::string title;        ///< heading on a page
  std::string question;     ///< that it answers
  std::string explanation;  ///< how to read it
  std::variant<OfScene, OfComparison, OfFolder> of;
};

}  // namespace rockstack::plots
