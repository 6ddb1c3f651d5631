#pragma once

#include "analytic/scene/in_double.hpp"

namespace rockstack {

inline History to_double(History history) {
  return history;
}

/// A history in double precision. What is ordered or equal stays so.
template <class Real>
History to_double(const BasicHistory<Real>& history) {
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  History result;
  result.blocks = history.blocks;
  result.times = in_double(history.times);
  result.angles = in_double(history.angles);
  result.velocities = in_double(history.velocities);
  result.patterns = history.patterns;
  result.events.reserve(history.events.size());
  for (const BasicEvent<Real>& event : history.events)
    result.events.push_back({number(event.time), event.kind, event.interface, event.from, event.to,
                             in_double(event.angles), in_double(event.before), in_double(event.after),
                             event.consistency, event.count});
  for (const BasicGraze<Real>& graze : history.grazes)
    result.grazes.push_back({number(graze.time), graze.kind, graze.interface});
  for (const BasicGraze<Real>& choice : history.choices)
    result.choices.push_back({number(choice.time), choice.kind, choice.interface});
  result.slips = in_double(history.slips);
  result.gaps = in_double(history.gaps);
  result.places = in_double(history.places);
  result.place_rates = in_double(history.place_rates);
  result.reactions = in_double(history.reactions);
  result.spring_energies = in_double(history.spring_energies);
  result.peaks = in_double(history.peaks);
  result.slips_left = in_double(history.slips_left);
  result.lifts = in_double(history.lifts);
  result.forces = in_double(history.forces);
  result.impulses = in_double(history.impulses);
  return result;
}

}  // namespace rockstack
