#include "analytic/scene/input/json_reader.hpp"

#include "analytic/scene/files/file_text.hpp"
#include "analytic/scene/input/document.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

/// Builds whatever has few levels.
template <class Json>
struct Levels : nlohmann::detail::json_sax_dom_parser<Json> {
  using Builder = nlohmann::detail::json_sax_dom_parser<Json>;
  using Builder::Builder;

  bool start_object(std::size_t size) { return ++levels <= most_levels && Builder::start_object(size); }
  bool end_object() { return --levels >= 0 && Builder::end_object(); }
  bool start_array(std::size_t size) { return ++levels <= most_levels && Builder::start_array(size); }
  bool end_array() { return --levels >= 0 && Builder::end_array(); }
  bool parse_error(std::size_t place, const std::string&, const nlohmann::detail::exception&) {
    position = place;
    return false;
  }

  int levels = 0;
  std::size_t position =
      0;  ///< of the byte that cannot be read, from 1; beyond the last where one is missing
};

/// Why bytes cannot be read whose reader has stopped within so many levels at the byte that it `found`.
std::string why_unreadable(std::string_view bytes, bool text, int levels, std::size_t found) {
  if (levels > most_levels) return "has more than " + std::to_string(most_levels) + " levels";
  if (found > bytes.size()) return "is cut short, after " + std::to_string(bytes.size()) + " bytes";
  const std::string position = std::to_string(found);
  const std::string_view rest = bytes.substr(found > 0 ? found - 1 : 0);
  for (const char* bare : {"NaN", "Infinity"})
    if (text && rest.starts_with(bare))
      return std::string("has a bare ") + bare + " at byte " + position +
             "; must be a text there, \"nan\", \"inf\" or \"-inf\"";
  if (text) return "is no JSON from byte " + position + " on";
  return "is no JSON, which begins with '{', and no MessagePack";
}

}  // namespace

template <class Json>
Json parse_bytes(std::string_view bytes, json::input_format_t form, const std::string& subject) {
  const bool text = form == json::input_format_t::json;
  Json result;
  Levels<Json> reader(result);
  if (!Json::sax_parse(bytes, &reader, form))
    throw InputError(subject + why_unreadable(bytes, text, reader.levels, reader.position));
  return result;
}

template json parse_bytes(std::string_view bytes, json::input_format_t form, const std::string& subject);

Json parse_json(std::string_view text, const std::string& subject) {
  return parse_bytes<Json>(text, json::input_format_t::json, subject);
}

Json read_json(const std::filesystem::path& file) {
  return parse_json(file_text(file, largest_results), one_line(file.string()) + ": ");
}

}  // namespace rockstack
