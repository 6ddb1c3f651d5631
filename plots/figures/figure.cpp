#include "plots/figures/figure.hpp"

namespace rockstack::plots {

Sheet SceneSubject::sheet(const Legend& legend, const std::string& answer) const {
  return {heading(scene), legend, figure.question + " " + answer};
}

Drawing SceneSubject::nothing(const std::string& reason) const {
  return empty_sheet(heading(scene), reason);
}

Sheet ComparisonSubject::sheet(const Legend& legend, const std::string& answer) const {
  return {comparison.title, legend, figure.question + " " + answer};
}

Sheet FolderSubject::sheet(const std::string& title, const Legend& legend, const std::string& answer) const {
  return {title, legend, figure.question + " " + answer};
}

}  // namespace rockstack::plots
