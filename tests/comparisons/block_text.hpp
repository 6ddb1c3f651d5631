#pragma once

namespace rockstack {

/// A scene file of one block that is let go, for what asks nothing of a scene but that it moves.
inline constexpr const char* block_text = R"(duration = 0.2
[[blocks]]
width = 0.5
height = 2
density = 2500
[initial]
angles = [0.05]
)";

}  // namespace rockstack
