#pragma once

#include <nlohmann/json.hpp>

#include "analytic/scene/input/fields.hpp"
#include "analytic/scene/input/json.hpp"

namespace rockstack {

/// A table with its keys as `rockstack keys --json` prints it: {"table", "meaning", "keys": [{"key", "unit",
/// "range", "default", "meaning", "example"}]}. A key with a slider has "usual": [least, most] and
/// "by_factors" besides, one that is a name "choices": [{"name", "words"}].
inline Json key_json(const KeyTable& table) {
  Json list = Json::array();
  for (const InputKey& key : table.keys) {
    Json& one = list.emplace_back(Json{{"key", key.name},
                                       {"unit", key.unit},
                                       {"range", key.range},
                                       {"default", key.default_value},
                                       {"meaning", key.meaning},
                                       {"example", key.example}});
    if (key.usual.least < key.usual.most) {
      one["usual"] = {key.usual.least, key.usual.most};
      one["by_factors"] = key.usual.by_factors;
    }
    for (const NamedChoice& choice : key.choices)
      one["choices"].push_back({{"name", choice.name}, {"words", choice.words}});
  }
  return {{"table", table.header}, {"meaning", table.meaning}, {"keys", list}};
}

}  // namespace rockstack
