#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "analytic/scene/lists.hpp"

namespace rockstack {

/// How a message is written: the same object in either form. MessagePack has long lists of numbers as bytes,
/// each number in eight, the lowest first (IEEE 754 binary64, little endian).
enum class Form { json, messagepack };

struct Message {
  nlohmann::json fields;
  Form form = Form::json;
};

/// The object with the version of the form as its field `rockstack`, written a piece at a time: `cancelled`
/// is asked between them. @throws Stopped where it says so.
std::string to_bytes(Message message, const std::function<bool()>* cancelled = nullptr);

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
  /// Names the field as from outside of the object that has it.
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

/// Fields that are numbers, by name: one table for writing and reading.
template <class Object>
struct Named {
  const char* name;
  double Object::*member;
};

template <class Object, std::size_t Count>
nlohmann::json object_of(const Object& from, const std::array<Named<Object>, Count>& fields) {
  nlohmann::json object;
  for (const auto& [name, member] : fields) object[name] = to_field(from.*member);
  return object;
}

template <class Object, std::size_t Count>
Object read_object(const nlohmann::json& object, const std::array<Named<Object>, Count>& fields) {
  Object result;
  for (const auto& [name, member] : fields) result.*member = number_field(object, name);
  return result;
}

/// A list of objects as an object of lists.
template <class Object, std::size_t Count>
void write_columns(nlohmann::json& object, const std::vector<Object>& list,
                   const std::array<Named<Object>, Count>& fields, Form form) {
  for (const auto& [name, member] : fields) object[name] = to_field(mapped(list, member), form);
}

template <class Object, std::size_t Count>
void read_columns(const nlohmann::json& object, std::vector<Object>& list,
                  const std::array<Named<Object>, Count>& fields) {
  for (const auto& [name, member] : fields) {
    const std::vector<double> column = numbers_field(object, name);
    if (list.empty()) list.resize(column.size());
    if (column.size() != list.size()) throw WrongField(name, "as long as the lists beside it");
    for (std::size_t i = 0; i < list.size(); ++i) list[i].*member = column[i];
  }
}

/// What `read` makes of each item of a list.
template <class Read>
auto read_list(const nlohmann::json& object, const char* name, const Read& read) {
  std::vector<std::invoke_result_t<Read, const nlohmann::json&>> items;
  const nlohmann::json& list = list_field(object, name);
  items.reserve(list.size());
  for (const nlohmann::json& item : list)
    items.push_back(within(name + ("." + std::to_string(items.size() + 1)), [&] { return read(item); }));
  return items;
}

}  // namespace rockstack
