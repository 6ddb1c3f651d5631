#pragma once

#include <filesystem>

namespace rockstack::plots {

/// Where a problem sheet and its key are.
struct SheetPages {
  std::filesystem::path sheet, key;
};

/// Writes the problem sheet LESSON-sheet-SEED.html and LESSON-key-SEED.html beside their answers, the file
/// LESSON-key-SEED.json. @throws InputError naming the file that is missing or malformed.
SheetPages write_sheet(const std::filesystem::path& answers);

}  // namespace rockstack::plots
