#include "tests/analytic/reference/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace rockstack::testing {
namespace {

template <class Real>
bool same(const BasicEvent<Real>& a, const BasicEvent<Quad>& b) {
  return a.kind == b.kind && a.interface == b.interface && a.from == b.from && a.to == b.to &&
         a.consistency == b.consistency;
}

/// The size that each of a list of values has had so far.
class Sizes {
 public:
  void note(const std::vector<Quad>& values) {
    for (const Quad& value : values) largest_ = std::max<Quad>(largest_, abs(value));
  }

  template <class Real>
  double share(const std::vector<Real>& values, const std::vector<Quad>& others) const {
    Quad worst = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
      worst = std::max<Quad>(worst, abs(Quad(values[k]) - others[k]));
    return largest_ > 0 ? static_cast<double>(worst / largest_) : 0.0;
  }

 private:
  Quad largest_ = 0;
};

/// Scenes that differ from one by that many units in the last place of gravity or of a height.
std::vector<Scene> roundings(const Scene& scene, int units) {
  std::vector<Scene> scenes;
  const auto shifted = [](double value, int shift) {
    return value * (1 + shift * std::numeric_limits<double>::epsilon());
  };
  for (const int shift : {-units, units}) {
    scenes.push_back(scene);
    scenes.back().gravity = shifted(scene.gravity, shift);
    for (std::size_t k = 0; k < scene.blocks.size(); ++k) {
      scenes.push_back(scene);
      scenes.back().blocks[k].half_height = shifted(scene.blocks[k].half_height, shift);
    }
  }
  return scenes;
}

void take_larger(Deviation& deviation, const Deviation& other) {
  deviation.time = std::max(deviation.time, std::abs(other.time));
  deviation.state = std::max(deviation.state, other.state);
}

}  // namespace

template <class Real>
Agreement compare(const BasicHistory<Real>& history, const QuadHistory& other) {
  Agreement agreement;
  Sizes angles;
  Sizes velocities;
  const std::size_t count = std::max(history.events.size(), other.events.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= history.events.size() || i >= other.events.size() || !same(history.events[i], other.events[i])) {
      agreement.parts = i;
      break;
    }
    const auto& event = history.events[i];
    const auto& expected = other.events[i];
    angles.note(expected.angles);
    velocities.note(expected.before);
    agreement.events.push_back({static_cast<double>(Quad(event.time) - expected.time),
                                std::max({angles.share(event.angles, expected.angles),
                                          velocities.share(event.before, expected.before),
                                          velocities.share(event.after, expected.after)})});
  }
  return agreement;
}

template Agreement compare(const BasicHistory<double>&, const QuadHistory&);
template Agreement compare(const BasicHistory<Quad>&, const QuadHistory&);

Agreement response_to_rounding(const Scene& scene, const QuadHistory& history, int units) {
  Agreement response;
  response.events.resize(history.events.size());
  for (const Scene& rounded : roundings(scene, units)) {
    const Agreement agreement = compare(reference(rounded), history);
    if (agreement.parts)
      response.parts = std::min(*agreement.parts, response.parts.value_or(*agreement.parts));
    for (std::size_t i = 0; i < agreement.events.size(); ++i)
      take_larger(response.events[i], agreement.events[i]);
  }
  response.events.resize(response.parts.value_or(response.events.size()));
  for (std::size_t i = 1; i < response.events.size(); ++i)
    take_larger(response.events[i], response.events[i - 1]);
  return response;
}

}  // namespace rockstack::testing
