#include "plots/figures/motion.hpp"

#include "plots/data/motion.hpp"
#include "plots/drawing/style.hpp"
#include "plots/figures/comparison/drawings.hpp"

namespace rockstack::plots {

void draw_motion(const std::filesystem::path& results) {
  const Comparison comparison = read_motion(results).comparison;
  const ComparedScene& scene = comparison.scenes.front();
  const Styles styles = assign_styles(comparison.runs);
  draw(histories(comparison, scene, styles), results / "figures" / "histories");
  if (!scene.ground_motion.empty())
    draw(ground_motion(comparison, scene, styles), results / "figures" / "ground-motion");
}

}  // namespace rockstack::plots
