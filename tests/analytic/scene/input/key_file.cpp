#include "tests/analytic/scene/input/key_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

namespace rockstack {
namespace {

bool is_table(const InputKey& key) {
  return std::string_view(key.example).empty();
}

}  // namespace

KeyFile::KeyFile(std::vector<const KeyTable*> tables) : tables_(std::move(tables)) {
  for (const KeyTable* table : tables_) {
    for (const InputKey& key : table->keys) {
      if (std::string_view(key.default_value) == required_key && !is_table(key))
        values_[table][key.name] = key.example;
    }
  }
}

KeyFile& KeyFile::set(const KeyTable& table, const std::string& name, const std::string& value) {
  for (const InputKey& key : table.keys) {
    const std::string_view default_value = key.default_value;
    if (key.name != name || !default_value.starts_with("instead of ")) continue;
    for (const InputKey& other : table.keys) {
      if (default_value.find(other.name) != std::string_view::npos) leave_out(table, other.name);
    }
  }
  values_[&table][name] = value;
  return *this;
}

KeyFile& KeyFile::leave_out(const KeyTable& table, const std::string& name) {
  values_[&table].erase(name);
  return *this;
}

std::string KeyFile::text() const {
  std::string text;
  for (const KeyTable* table : tables_) {
    text += std::string(table->header) + "\n";
    const auto written = values_.find(table);
    if (written == values_.end()) continue;
    for (const auto& [name, value] : written->second) text.append(name).append(" = ").append(value) += '\n';
  }
  return text;
}

void expect_keys_are_those_read(const KeyFile& file, const KeyTable& table, const ReadText& read) {
  EXPECT_EQ(read(file.text()), "") << file.text();
  for (const InputKey& key : table.keys) {
    if (is_table(key)) continue;
    EXPECT_EQ(read(KeyFile(file).set(table, key.name, key.example).text()), "") << key.name;
    const std::string refused = std::string(key.name) + " = true: must be ";
    EXPECT_NE(read(KeyFile(file).set(table, key.name, "true").text()).find(refused), std::string::npos)
        << key.name << " is not read";
  }
  EXPECT_NE(read(KeyFile(file).set(table, "no_key", "1").text()).find("no_key: unknown key"),
            std::string::npos)
      << table.header;
}

void expect_keys_have_effects(
    std::initializer_list<const KeyTable*> tables, const std::vector<KeyCase>& cases,
    const std::function<std::string(const std::vector<KeyCase::Setting>&)>& outcome) {
  for (const KeyTable* table : tables) {
    for (const InputKey& key : table->keys) {
      if (is_table(key)) continue;
      const std::string name = std::string(table->meaning) + ": " + key.name;
      const auto found = std::find_if(cases.begin(), cases.end(), [&](const KeyCase& one) {
        return one.table == table && one.key == key.name;
      });
      ASSERT_NE(found, cases.end()) << "say where another value matters of " << name;
      if (found->other.empty()) continue;
      const auto with = [&](const std::string& value) {
        std::vector<KeyCase::Setting> settings = found->beside;
        settings.push_back({table, key.name, value});
        return outcome(settings);
      };
      try {
        EXPECT_FALSE(with(key.example) == with(found->other)) << name << " changes nothing";
      } catch (const std::exception& error) {
        ADD_FAILURE() << name << ": " << error.what();
      }
    }
  }
}

void expect_tables_are_complete(std::initializer_list<const KeyTable*> tables) {
  for (const KeyTable* table : tables) {
    for (const InputKey& key : table->keys) {
      if (!is_table(key)) continue;
      EXPECT_TRUE(std::any_of(tables.begin(), tables.end(), [&](const KeyTable* other) {
        return (std::string(other->header) + other->meaning).find(key.name) != std::string::npos;
      })) << key.name;
    }
  }
}

}  // namespace rockstack
