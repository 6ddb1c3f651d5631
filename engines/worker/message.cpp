#include "engines/worker/message.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace rockstack {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "lists of numbers are copied as they are");

constexpr const char* version_field = "rockstack";
constexpr int version = 1;

/// Accepts every message of few levels, so that none can exhaust the stack of what reads it next.
class Depth : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return leave(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
    position_ = position;
    return false;
  }

  static constexpr int most = 8;
  bool is_too_deep() const { return levels_ > most; }
  /// Of the byte that cannot be read, from 1; beyond the last where one is missing.
  std::size_t position() const { return position_; }

 private:
  bool enter() { return ++levels_ <= most; }
  bool leave() {
    --levels_;
    return true;
  }
  int levels_ = 0;
  std::size_t position_ = 0;
};

/// Why bytes are no message; `found` has stopped in them.
std::string why_unreadable(std::string_view bytes, bool text, const Depth& found) {
  if (found.is_too_deep()) return fmt::format("the message has more than {} levels", Depth::most);
  if (found.position() > bytes.size())
    return fmt::format("the message is cut short, after {} bytes", bytes.size());
  const std::string_view rest = bytes.substr(found.position() > 0 ? found.position() - 1 : 0);
  for (const char* bare : {"NaN", "Infinity"}) {
    if (text && rest.starts_with(bare))
      return fmt::format(
          "the message has a bare {} at byte {}; must be a text there, \"nan\", \"inf\" or \"-inf\"", bare,
          found.position());
  }
  if (text) return fmt::format("the message is no JSON from byte {} on", found.position());
  return "the message is no JSON, which begins with '{', and no MessagePack";
}

[[noreturn]] void refuse(const char* name, const char* what) {
  throw WrongField(name, what);
}

constexpr const char* any_number = "a number, \"inf\", \"-inf\" or \"nan\"";

/// @return nothing where the field is neither a number nor a text that stands for one.
std::optional<double> number_of(const json& value) {
  if (value.is_number()) return value.get<double>();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  if (value == "nan" || value.is_null()) return std::nan("");
  return {};
}

json parsed(std::string_view bytes, json::input_format_t format) {
  try {
    return format == json::input_format_t::json ? json::parse(bytes) : json::from_msgpack(bytes);
  } catch (const json::exception& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace

std::string to_bytes(Message message) {
  message.fields[version_field] = version;
  if (message.form == Form::json) return message.fields.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string bytes;
  json::to_msgpack(message.fields, bytes);
  return bytes;
}

Message read_message(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool text = first != std::string_view::npos && bytes[first] == '{';
  const auto format = text ? json::input_format_t::json : json::input_format_t::msgpack;
  Depth depth;
  if (!json::sax_parse(bytes, &depth, format)) throw std::runtime_error(why_unreadable(bytes, text, depth));
  Message message{parsed(bytes, format), text ? Form::json : Form::messagepack};
  if (!message.fields.is_object() || !has_field(message.fields, version_field))
    throw std::runtime_error("the message is no object with a field `rockstack`");
  if (message.fields[version_field] != version)
    throw std::runtime_error(fmt::format("the message is of version {}; must be {}",
                                         message.fields[version_field].dump(), version));
  return message;
}

json to_field(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

json to_field(const std::vector<double>& values, Form form) {
  if (form == Form::messagepack) {
    json::binary_t bytes;
    bytes.resize(values.size() * sizeof(double));
    if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
  }
  json list = json::array();
  for (const double value : values) list.push_back(to_field(value));
  return list;
}

bool has_field(const json& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && !found->is_null();
}

const json& field(const json& object, const char* name) {
  if (!object.is_object() || !object.contains(name)) refuse(name, "there");
  return object[name];
}

double number_field(const json& object, const char* name) {
  const std::optional<double> number = number_of(field(object, name));
  if (!number) refuse(name, any_number);
  return *number;
}

std::vector<double> numbers_field(const json& object, const char* name) {
  const json& value = field(object, name);
  std::vector<double> values;
  if (value.is_binary()) {
    const json::binary_t& bytes = value.get_binary();
    if (bytes.size() % sizeof(double) != 0) refuse(name, "bytes of whole numbers, eight each");
    values.resize(bytes.size() / sizeof(double));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  if (!value.is_array()) refuse(name, "a list of numbers");
  values.reserve(value.size());
  for (const json& item : value) {
    const std::optional<double> number = number_of(item);
    if (!number) throw WrongField(name, any_number, true);
    values.push_back(*number);
  }
  return values;
}

std::string text_field(const json& object, const char* name) {
  const json& value = field(object, name);
  if (!value.is_string()) refuse(name, "a text");
  return value.get<std::string>();
}

bool flag_field(const json& object, const char* name) {
  const json& value = field(object, name);
  if (!value.is_boolean()) refuse(name, "true or false");
  return value.get<bool>();
}

std::size_t count_field(const json& object, const char* name) {
  const json& value = field(object, name);
  if (!value.is_number_unsigned()) refuse(name, "a whole number ≥ 0");
  return value.get<std::size_t>();
}

const json& list_field(const json& object, const char* name) {
  const json& list = field(object, name);
  if (!list.is_array()) refuse(name, "a list");
  return list;
}

}  // namespace rockstack
