#pragma once

#include <nlohmann/json.hpp>

namespace rockstack {

/// What the library says is wrong, without its own name for that.
inline std::string plain_words(const nlohmann::json::exception& error) {
  const std::string what = error.what();  // "[json.exception.type_error.302] type must be …"
  return what.substr(what.find("] ") + 2);
}

}  // namespace rockstack
