#include "plots/data/kept_files.hpp"

#include <system_error>

namespace rockstack::plots {

void KeptFiles::make_room_for(const std::filesystem::path& file) {
  constexpr std::uintmax_t room = 500'000'000;
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(file, none);
  if (none) return;
  if (bytes_ + size > room) {
    kept_.clear();
    bytes_ = 0;
  }
  bytes_ += size;
}

}  // namespace rockstack::plots
