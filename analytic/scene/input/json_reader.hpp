#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analytic/scene/input/json.hpp"
#include "analytic/scene/messages/input_error.hpp"
#include "analytic/scene/messages/one_line.hpp"

namespace rockstack {

// The one place where JSON and MessagePack come in, from files, workers, pages and other ranks. As of TOML,
// more than most_levels are refused: what reads, copies or writes them next goes down level by level.

/// What the library says is wrong, without its own name for that.
inline std::string plain_words(const nlohmann::json::exception& error) {
  const std::string what = error.what();  // "[json.exception.type_error.302] type must be …"
  return what.substr(what.find("] ") + 2);
}

/// Reads bytes of one of the two forms. @throws InputError that begins with `subject`, "x.json: " or "the
/// message " as it may be, and says what is wrong.
template <class Json>
Json parse_bytes(std::string_view bytes, nlohmann::json::input_format_t form, const std::string& subject);

/// Parses JSON, whose objects keep their order.
Json parse_json(std::string_view text, const std::string& subject);

/// Parses a whole file. @throws InputError also where it cannot be read.
Json read_json(const std::filesystem::path& file);

/// What `read` makes of a file. @throws InputError as read_json(), and where something in the file is
/// missing, of another kind or found wrong by `read`, naming the file.
template <class Read>
auto read_json(const std::filesystem::path& file, const Read& read) {
  try {
    return read(read_json(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(one_line(file.string() + ": " + plain_words(error)));
  } catch (const InputError&) {  // which names its place itself
    throw;
  } catch (const std::invalid_argument& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

}  // namespace rockstack
