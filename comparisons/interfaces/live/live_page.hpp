#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "analytic/scene/ground/records/record.hpp"
#include "analytic/scene/input/json.hpp"

namespace rockstack::live {

/// What a page begins with, and what it may choose from.
struct PageStart {
  std::filesystem::path scene;                           ///< its file
  std::vector<std::string> overrides;                    ///< of that scene, key=value
  std::string engine;                                    ///< as find_engine(); empty: none
  std::string lesson;                                    ///< by which it is known, empty: none
  std::map<std::string, std::filesystem::path> lessons;  ///< the scene's file of each, by name
  std::filesystem::path course;                          ///< a folder with pages of lessons; empty: none
  std::vector<std::filesystem::path> records;  ///< that scenes may name, besides those that the scene has
  RecordLimits limits = RecordLimits::usual;   ///< of those
};

/// What `rockstack teach` has written into a folder.
struct CourseFiles {
  std::string first;                           ///< the path of the page to begin with; empty: no course
  std::map<std::string, std::string> lessons;  ///< the path of each lesson's page, by its name
  std::map<std::string, std::filesystem::path> files;  ///< every file of the folder, by its path within it
};

/// The whole page, the records that its scenes may name, and the lessons beside it.
struct LivePage {
  std::string text;
  std::set<std::string> records;
  CourseFiles course;
};

/// The page: one file that needs no network but this server. @throws InputError for a scene that is none, or
/// beyond what a live page takes, and as read_record().
LivePage make_live_page(const PageStart& start);

}  // namespace rockstack::live
