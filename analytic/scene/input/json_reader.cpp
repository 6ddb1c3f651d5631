#include "analytic/scene/input/json_reader.hpp"

#include <fstream>
#include <iterator>

#include "analytic/scene/input/document.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

/// Accepts whatever has few levels.
struct Levels : nlohmann::detail::json_sax_acceptor<json> {
  bool start_object(std::size_t) { return ++levels <= most_levels; }
  bool end_object() { return --levels >= 0; }
  bool start_array(std::size_t) { return ++levels <= most_levels; }
  bool end_array() { return --levels >= 0; }
  bool parse_error(std::size_t place, const std::string&, const nlohmann::detail::exception&) {
    position = place;
    return false;
  }

  int levels = 0;
  std::size_t position =
      0;  ///< of the byte that cannot be read, from 1; beyond the last where one is missing
};

/// Why bytes cannot be read; `found` has stopped in them.
std::string why_unreadable(std::string_view bytes, bool text, const Levels& found) {
  if (found.levels > most_levels) return "has more than " + std::to_string(most_levels) + " levels";
  if (found.position > bytes.size()) return "is cut short, after " + std::to_string(bytes.size()) + " bytes";
  const std::string position = std::to_string(found.position);
  const std::string_view rest = bytes.substr(found.position > 0 ? found.position - 1 : 0);
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
  Levels levels;
  if (!json::sax_parse(bytes, &levels, form)) throw InputError(subject + why_unreadable(bytes, text, levels));
  return text ? Json::parse(bytes) : Json::from_msgpack(bytes);
}

template json parse_bytes(std::string_view bytes, json::input_format_t form, const std::string& subject);

Json parse_json(std::string_view text, const std::string& subject) {
  return parse_bytes<Json>(text, json::input_format_t::json, subject);
}

Json read_json(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(one_line(file.string()) + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return parse_json(text, one_line(file.string()) + ": ");
}

}  // namespace rockstack
