#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <type_traits>

namespace rockstack::plots {

/// What was read of files: each is read once and kept while there is room, since figures and pages of one
/// scene show the same histories.
class KeptFiles {
 public:
  /// What `read` makes of a file. A file is always read by the same function.
  template <class Read>
  auto get(const std::filesystem::path& file, const Read& read) {
    using Value = std::invoke_result_t<Read, const std::filesystem::path&>;
    if (const auto found = kept_.find(file); found != kept_.end())
      return std::static_pointer_cast<const Value>(found->second);
    std::shared_ptr<const Value> value = std::make_shared<const Value>(read(file));
    make_room_for(file);
    kept_[file] = value;
    return value;
  }

 private:
  void make_room_for(const std::filesystem::path& file);

  std::map<std::filesystem::path, std::shared_ptr<const void>> kept_;
  std::uintmax_t bytes_ = 0;  ///< of the files
};

}  // namespace rockstack::plots
