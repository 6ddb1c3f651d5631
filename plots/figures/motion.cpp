#include "plots/figures/motion.hpp"

#include "plots/data/motion.hpp"
#include "plots/figures/comparison/drawings.hpp"
#include "plots/figures/contact/slip.hpp"

namespace rockstack::plots {

void draw_motion(const std::filesystem::path& results) {
  const Comparison comparison = read_motion(results).comparison;
  const ComparedScene& scene = comparison.scenes.front();
  draw(histories(comparison, scene), results / "figures" / "histories");
  if (scene.slips) draw(slip(comparison, scene), results / "figures" / "slip");
  if (!scene.ground_motion.empty())
    draw(ground_motion(comparison, scene), results / "figures" / "ground-motion");
}

}  // namespace rockstack::plots
