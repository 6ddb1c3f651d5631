#include "comparisons/measures/metrics/sizes.hpp"

#include <fmt/format.h>

namespace rockstack {

std::vector<std::string> size_warnings(const Scene& scene) {
  constexpr double large = 100;  // m
  std::vector<std::string> lines;
  for (std::size_t k = 1; const Block& block : scene.blocks) {
    for (const auto& [name, size] :
         {std::pair("width", 2 * block.half_width), {"height", 2 * block.half_height}})
      if (size > large)
        lines.push_back(fmt::format("blocks.{}.{} is {:.6g} m: lengths are in m; {:.6g} mm are {:.6g}", k,
                                    name, size, size, size / 1000));
    ++k;
  }
  return lines;
}

}  // namespace rockstack
