#include "comparisons/interfaces/python/convert.hpp"

#include <cstring>

#include "analytic/scene/input/whole_number.hpp"

namespace rockstack::python {
namespace {

/// What str() makes of a value; lone surrogates, which UTF-8 has none of, as escapes.
std::string text_of(const py::handle& value) {
  return py::bytes(py::str(value).attr("encode")("utf-8", "backslashreplace"));
}

std::string shown(const py::handle& value) {
  return one_line(text_of(value));
}

void read_table(const py::object& items, Node& target, int depth) {
  target.kind = Node::Kind::table;
  for (const py::handle item : items) {
    const auto pair = item.cast<std::pair<py::object, py::object>>();
    if (!py::isinstance<py::str>(pair.first))
      throw InputError(target.place + ": " + shown(pair.first) + ": a key must be a text");
    if (pair.second.is_none()) continue;
    Node child = make_child(target, text_of(pair.first), target.place);
    read_value(pair.second, child, depth + 1);
    target.children.push_back(std::move(child));
  }
}

/// A further entry of an array.
Node& add_entry(Node& array) {
  Node child = make_child(array, std::to_string(array.children.size() + 1), array.place);
  return array.children.emplace_back(std::move(child));
}

void read_sequence(const py::handle& values, Node& target, int depth) {
  target.kind = Node::Kind::array;
  for (const py::handle value : values) read_value(value, add_entry(target), depth + 1);
}

void read_numbers(const py::array_t<double>& numbers, Node& target) {
  target.kind = Node::Kind::array;
  target.children.reserve(static_cast<std::size_t>(numbers.size()));
  const auto values = numbers.unchecked<1>();
  for (py::ssize_t i = 0; i < numbers.size(); ++i) {
    Node& entry = add_entry(target);
    entry.kind = Node::Kind::number;
    entry.number = values(i);
  }
}

void read_number(const py::handle& value, Node& target) {
  target.kind = Node::Kind::number;
  int beyond = PyLong_Check(value.ptr()) ? 0 : 1;
  const long long whole = beyond == 0 ? PyLong_AsLongLongAndOverflow(value.ptr(), &beyond) : 0;
  target.number = beyond == 0 ? double_of_whole(whole) : PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() == nullptr) return;
  if (!PyErr_ExceptionMatches(PyExc_OverflowError)) throw py::error_already_set();
  PyErr_Clear();  // a whole number beyond all doubles
  target.number = std::numeric_limits<double>::infinity();
}

void read_other(const py::handle& value, Node& target) {
  target.kind = Node::Kind::other;
  target.text = shown(value);
}

/// Reads numpy's arrays and numbers, and what is like them.
void read_array(const py::handle& value, Node& target, int depth) {
  if (py::hasattr(value, "mask") && py::module_::import("numpy.ma").attr("is_masked")(value).cast<bool>())
    throw InputError(target.place + ": " + one_line(target.key) +
                     ": has masked entries: must be filled first");
  const py::array array(py::reinterpret_borrow<py::object>(value));
  const char kind = array.dtype().kind();
  if (kind == 'm' || kind == 'M') return read_other(value, target);  // dates, which may be counts to Python
  if (array.ndim() == 0) return read_value(array.attr("item")(), target, depth + 1);
  if (array.ndim() == 1 && kind == 'f')
    return read_numbers(py::array_t<double, py::array::forcecast>(array), target);
  read_sequence(array, target, depth);
}

/// Not an array of one, nor another sequence that may be one.
bool is_number(const py::handle& value, const py::handle& type) {
  return PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr()) ||
         (py::hasattr(type, "__float__") && !py::hasattr(type, "__array__") && !py::hasattr(type, "__len__"));
}

}  // namespace

void read_value(const py::handle& value, Node& target, int depth) {
  if (depth > most_levels)
    throw InputError(target.place + ": " + one_line(target.key) + ": must be nested at most " +
                     std::to_string(most_levels) + " deep");
  const py::handle type = py::type::handle_of(value);
  // Truth values are numbers to Python, and none to a scene.
  if (PyBool_Check(value.ptr()) || std::string_view(Py_TYPE(value.ptr())->tp_name) == "numpy.bool_") {
    target.kind = Node::Kind::other;
    target.text = value.cast<bool>() ? "true" : "false";
  } else if (is_number(value, type)) {
    read_number(value, target);
  } else if (py::isinstance<py::str>(value) || py::hasattr(type, "__fspath__")) {
    target.kind = Node::Kind::text;
    target.text = text_of(py::module_::import("os").attr("fspath")(value));
  } else if (py::hasattr(type, "__array__")) {
    read_array(value, target, depth);
  } else if (py::hasattr(type, "items")) {
    read_table(value.attr("items")(), target, depth);
  } else if (py::hasattr(type, "__len__") && py::hasattr(type, "__iter__") && !PyBytes_Check(value.ptr())) {
    read_sequence(value, target, depth);
  } else {
    read_other(value, target);
  }
}

bool is_known(const bool& value) {
  unsigned char byte = 0;
  std::memcpy(&byte, &value, sizeof(value));  // to read it as a truth value would be undefined
  return byte <= 1;
}

bool is_known(EventKind kind) {
  return kind >= EventKind::opening && kind <= EventKind::unload;
}

bool is_known(Consistency consistency) {
  return consistency >= Consistency::consistent && consistency <= Consistency::gains;
}

bool is_known(const Pattern& pattern) {
  const auto is_contact = [](Contact contact) {
    return contact >= Contact::left && contact <= Contact::apart;
  };
  const auto is_sign = [](int slide) { return std::abs(slide) <= 1; };
  return pattern.size >= 0 && pattern.size <= max_blocks &&
         std::ranges::all_of(pattern.contacts, is_contact) && std::ranges::all_of(pattern.slides, is_sign);
}

bool is_known(const BasicGraze<double>& graze) {
  return is_known(graze.kind);
}

bool is_known(const Pulse& pulse) {
  return pulse.shape >= PulseShape::sine && pulse.shape <= PulseShape::mavroeidis_papageorgiou;
}

void require_packed(bool whole) {
  if (!whole) throw InputError("packed numbers: must be whole, of this build and of their scene");
}

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return sum;
}

Node read_document(const py::handle& mapping, const std::string& place) {
  Node root;
  root.place = place;
  read_value(mapping, root);
  return root;
}

py::object to_python(const Node& node) {
  if (node.kind == Node::Kind::number) return py::float_(node.number);
  if (node.kind == Node::Kind::other && (node.text == "true" || node.text == "false"))
    return py::bool_(node.text == "true");
  if (node.kind == Node::Kind::text || node.kind == Node::Kind::other) return py::str(node.text);
  py::list list;
  py::dict dict;
  for (const Node& child : node.children) {
    const py::object value = to_python(child);
    if (node.kind == Node::Kind::array)
      list.append(value);
    else
      dict[py::str(child.name)] = value;
  }
  return node.kind == Node::Kind::array ? py::object(list) : py::object(dict);
}

}  // namespace rockstack::python
