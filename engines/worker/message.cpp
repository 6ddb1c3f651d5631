#include "engines/worker/message.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/solve_options.hpp"

namespace rockstack {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "lists of numbers are copied as they are");

constexpr const char* version_field = "rockstack";
constexpr int version = 1;

[[noreturn]] void refuse(const char* name, const char* what) {
  throw WrongField(name, what);
}

constexpr const char* any_number = "a number, \"inf\", \"-inf\" or \"nan\"";

/// A field that `is` as it must be, which `allowed` tells.
const json& field_that(bool (json::*is)() const noexcept, const char* allowed, const json& object,
                       const char* name) {
  const json& value = field(object, name);
  if (!(value.*is)()) refuse(name, allowed);
  return value;
}

/// @return nothing where the field is neither a number nor a text that stands for one.
std::optional<double> number_of(const json& value) {
  if (value.is_number()) return value.get<double>();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  if (value == "-inf") return -std::numeric_limits<double>::infinity();
  if (value == "nan" || value.is_null()) return std::nan("");
  return {};
}

/// Bytes as they are written, as long as they are wanted.
class Output : public nlohmann::detail::output_adapter_protocol<char> {
 public:
  explicit Output(const std::function<bool()>* cancelled) : cancelled_(cancelled) {}

  std::string bytes;

  void write_character(char letter) override { write_characters(&letter, 1); }
  void write_characters(const char* letters, std::size_t count) override {
    constexpr std::size_t between_looks = std::size_t{1} << 20U;
    const std::size_t before = bytes.size() / between_looks;
    bytes.append(letters, count);
    if (bytes.size() / between_looks != before) stop_if_cancelled(cancelled_);
  }

 private:
  const std::function<bool()>* cancelled_;
};

}  // namespace

std::string to_bytes(Message message, const std::function<bool()>* cancelled) {
  message.fields[version_field] = version;
  const auto output = std::make_shared<Output>(cancelled);
  if (message.form == Form::json)
    nlohmann::detail::serializer<json>(output, ' ', json::error_handler_t::replace)
        .dump(message.fields, false, false, 0);
  else
    nlohmann::detail::binary_writer<json, char>(output).write_msgpack(message.fields);
  return std::move(output->bytes);
}

Message read_message(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool text = first != std::string_view::npos && bytes[first] == '{';
  const auto format = text ? json::input_format_t::json : json::input_format_t::msgpack;
  Message message{{}, text ? Form::json : Form::messagepack};
  try {
    message.fields = parse_bytes<json>(bytes, format, "the message ");
  } catch (const InputError& error) {  // what a worker says is nobody's input
    throw std::runtime_error(error.what());
  }
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
  json::array_t list;
  list.reserve(values.size());
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
  return field_that(&json::is_string, "a text", object, name).get<std::string>();
}

bool flag_field(const json& object, const char* name) {
  return field_that(&json::is_boolean, "true or false", object, name).get<bool>();
}

std::size_t count_field(const json& object, const char* name) {
  return field_that(&json::is_number_unsigned, "a whole number ≥ 0", object, name).get<std::size_t>();
}

const json& list_field(const json& object, const char* name) {
  return field_that(&json::is_array, "a list", object, name);
}

}  // namespace rockstack
