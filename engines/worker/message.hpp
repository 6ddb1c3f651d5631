#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rockstack {

/// How a message is written: the same object in either form. MessagePack has long lists of numbers as bytes,
/// each number in eight, the lowest first (IEEE 754 binary64, little endian).
enum class Form { json, messagepack };

struct Message {
  nlohmann::json fields;
  Form form = Form::json;
};

/// The object with the version of the form as its field `rockstack`.
std::string to_bytes(Message message);

/// @throws std::runtime_error for bytes that are no message, whatever they are, or one of another version.
Message read_message(std::string_view bytes);

// Numbers as fields have them. What JSON cannot write is "inf", "-inf" or "nan" in both forms.
nlohmann::json to_field(double value);
nlohmann::json to_field(const std::vector<double>& values, Form form);

/// A field that is not there, or is something else than it must be.
class WrongField : public std::runtime_error {
 public:
  /// `each`: what is wrong is in the list that the field is.
  WrongField(const std::string& path, const std::string& allowed, bool each = false)
      : std::runtime_error((each ? "each of `" : "`") + path + "` must be " + allowed),
        path_(path),
        allowed_(allowed),
        each_(each) {}
  /// The same field as it is named from outside of the object that has it.
  WrongField in(const std::string& outer) const { return {outer + "." + path_, allowed_, each_}; }

 private:
  std::string path_, allowed_;
  bool each_;
};

/// What `read` gives. A field that it finds wrong is named as one of `outer`.
template <class Read>
auto within(const std::string& outer, const Read& read) {
  try {
    return read();
  } catch (const WrongField& wrong) {
    throw wrong.in(outer);
  }
}

// The field `name` of an object. @throws WrongField.
const nlohmann::json& field(const nlohmann::json& object, const char* name);
double number_field(const nlohmann::json& object, const char* name);
std::vector<double> numbers_field(const nlohmann::json& object, const char* name);
std::string text_field(const nlohmann::json& object, const char* name);
bool flag_field(const nlohmann::json& object, const char* name);
std::size_t count_field(const nlohmann::json& object, const char* name);
const nlohmann::json& list_field(const nlohmann::json& object, const char* name);

/// True where the object has the field and it is not null.
bool has_field(const nlohmann::json& object, const char* name);

}  // namespace rockstack
