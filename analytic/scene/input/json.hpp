#pragma once

#include <nlohmann/json_fwd.hpp>

namespace rockstack {

/// JSON as it is written here, whose objects keep their order.
using Json = nlohmann::ordered_json;

}  // namespace rockstack
