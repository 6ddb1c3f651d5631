#pragma once

#include <initializer_list>

namespace rockstack {

/// A key of an input file and what it means; `rockstack keys` prints it. SI units.
struct InputKey {
  const char* name;
  const char* example;   ///< a value that is accepted, as TOML; empty: a table, with keys of its own
  const char* unit;      ///< empty: none
  const char* range;     ///< which values are accepted
  const char* standard;  ///< what holds where it is left out: a value as TOML, or words; see below
  const char* meaning;
};

// Words that `standard` has where no value stands for a key that is left out. "instead of KEY": one of the
// two must be there, or may be there where KEY may be left out.
inline constexpr const char* required_key = "required";
inline constexpr const char* no_default = "none";

/// A table of an input file: the only keys that its reader accepts.
struct KeyTable {
  const char* header;   ///< as a file has it, e.g. "[[blocks]]"; empty: the top of the file
  const char* meaning;  ///< of the table
  std::initializer_list<InputKey> keys;
};

}  // namespace rockstack
