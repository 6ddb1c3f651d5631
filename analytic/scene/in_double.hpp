#pragma once

#include "analytic/scene/history.hpp"

namespace rockstack {

template <class Real>
std::vector<double> in_double(const std::vector<Real>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const Real& value : values) result.push_back(static_cast<double>(value));
  return result;
}

template <class Real>
std::vector<Demand> in_double(const std::vector<BasicDemand<Real>>& demands) {
  const auto number = [](const Real& value) { return static_cast<double>(value); };
  std::vector<Demand> result;
  result.reserve(demands.size());
  for (const BasicDemand<Real>& demand : demands)
    result.push_back({number(demand.least_normal), number(demand.least_normal_time), number(demand.friction),
                      number(demand.friction_time), number(demand.first_pull_time),
                      number(demand.first_slip_time)});
  return result;
}

template <class Real>
std::vector<Reaction> in_double(const std::vector<BasicReaction<Real>>& reactions) {
  std::vector<Reaction> result;
  result.reserve(reactions.size());
  for (const BasicReaction<Real>& reaction : reactions)
    result.push_back({static_cast<double>(reaction.normal), static_cast<double>(reaction.tangential),
                      static_cast<double>(reaction.centre)});
  return result;
}

template <class Real>
std::vector<SpringEnergy> in_double(const std::vector<BasicSpringEnergy<Real>>& energies) {
  std::vector<SpringEnergy> result;
  result.reserve(energies.size());
  for (const BasicSpringEnergy<Real>& energy : energies)
    result.push_back({static_cast<double>(energy.elastic), static_cast<double>(energy.damped),
                      static_cast<double>(energy.rubbed)});
  return result;
}

}  // namespace rockstack
