#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analytic/scene/input/fields.hpp"

namespace rockstack {

/// An input file that is written from its tables of keys alone.
class KeyFile {
 public:
  /// The examples of all required keys of some tables, in their order.
  explicit KeyFile(std::vector<const KeyTable*> tables);

  /// Writes a key with a value, in the place of those that it stands instead of.
  KeyFile& set(const KeyTable& table, const std::string& name, const std::string& value);
  KeyFile& leave_out(const KeyTable& table, const std::string& name);

  std::string text() const;

 private:
  std::vector<const KeyTable*> tables_;
  std::map<const KeyTable*, std::map<std::string, std::string>> values_;
};

/// Reads a text as an input file; the error's text, empty where there is none.
using ReadText = std::function<std::string(const std::string&)>;

/// The laws of one table among those of a file that `read` accepts: each key's example is accepted, each key
/// is read (a truth value is refused by its name), and no other key is.
void expect_keys_are_those_read(const KeyFile& file, const KeyTable& table, const ReadText& read);

/// A key, another value for it than its example, and what else a file has to say for it to matter.
struct KeyCase {
  const KeyTable* table;
  std::string key;
  std::string other;  ///< empty: the key has one value alone, or another test
  struct Setting {
    const KeyTable* table;
    std::string key, value;
  };
  std::vector<Setting> beside = {};
};

/// Every key of some tables does something: `outcome` of what its case sets beside, and of the key's value,
/// is one thing with the example and another with the case's other value.
void expect_keys_have_effects(
    std::initializer_list<const KeyTable*> tables, const std::vector<KeyCase>& cases,
    const std::function<std::string(const std::vector<KeyCase::Setting>&)>& outcome);

/// Each key that is a table has a table of keys, whose header or meaning names it.
void expect_tables_are_complete(std::initializer_list<const KeyTable*> tables);

}  // namespace rockstack
