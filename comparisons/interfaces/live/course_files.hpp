#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace rockstack::live {

/// What `rockstack teach` has written into a folder.
struct CourseFiles {
  std::string first;                           ///< the path of the page to begin with; empty: no course
  std::map<std::string, std::string> lessons;  ///< the path of each lesson's page, by its name
  std::map<std::string, std::filesystem::path> files;  ///< every file of the folder, by its path within it
};

/// Whether it is a folder of `rockstack teach`: of one lesson, or of all.
bool has_course_files(const std::filesystem::path& folder);

/// The files that are there now; what a link leads to is none of them.
/// @throws InputError for a folder without pages, or of which not all can be read.
CourseFiles course_files(const std::filesystem::path& folder);

}  // namespace rockstack::live
