#pragma once

#include <xsimd/xsimd.hpp>

#include "analytic/steps/chain_series.hpp"

namespace rockstack {

/// Numbers that are computed side by side, each as it would be by itself, to the bit. Only for source files
/// that are compiled for one instruction set: every function of a pack bears the set in its name, so that the
/// linker cannot put one in the place of another.
template <class Set>
struct Pack {
  using Lanes = xsimd::batch<double, Set>;
  using Mask = typename Lanes::batch_bool_type;
  static constexpr std::size_t size = Lanes::size;

  Lanes lanes;

  Pack() {}
  Pack(double value) : lanes(value) {}
  Pack(const Lanes& values) : lanes(values) {}

  /// Memory of `size` numbers, aligned to their size.
  static Pack load(const double* from) { return Lanes::load_aligned(from); }
  void store(double* to) const { lanes.store_aligned(to); }

  friend Pack operator+(const Pack& a, const Pack& b) { return a.lanes + b.lanes; }
  friend Pack operator-(const Pack& a, const Pack& b) { return a.lanes - b.lanes; }
  friend Pack operator*(const Pack& a, const Pack& b) { return a.lanes * b.lanes; }
  friend Pack operator/(const Pack& a, const Pack& b) { return a.lanes / b.lanes; }
  // AVX-512: the library subtracts numbers from zero, and the opposite of zero would have no sign.
  friend Pack operator-(const Pack& a) { return a.lanes ^ Lanes(-0.0); }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }

  friend Mask operator<(const Pack& a, const Pack& b) { return a.lanes < b.lanes; }
  friend Mask operator<=(const Pack& a, const Pack& b) { return a.lanes <= b.lanes; }
  friend Mask operator>(const Pack& a, const Pack& b) { return a.lanes > b.lanes; }
  friend Mask operator>=(const Pack& a, const Pack& b) { return a.lanes >= b.lanes; }
  friend Mask operator==(const Pack& a, const Pack& b) { return a.lanes == b.lanes; }
  friend Mask operator!=(const Pack& a, const Pack& b) { return a.lanes != b.lanes; }

  // As std::max and std::min do: the first where neither is more, or one is no number.
  friend Pack max(const Pack& a, const Pack& b) { return xsimd::max(b.lanes, a.lanes); }
  friend Pack min(const Pack& a, const Pack& b) { return xsimd::min(b.lanes, a.lanes); }
  friend Pack abs(const Pack& a) { return xsimd::abs(a.lanes); }
  friend Pack sqrt(const Pack& a) { return xsimd::sqrt(a.lanes); }
};

/// The one where a mask is true, the other where it is not.
template <class Set>
Pack<Set> select(const typename Pack<Set>::Mask& mask, const Pack<Set>& one, const Pack<Set>& other) {
  return xsimd::select(mask, one.lanes, other.lanes);
}

/// Whether a truth of any number is so.
template <class Set>
bool any(const xsimd::batch_bool<double, Set>& truths) {
  return xsimd::any(truths);
}

template <class Set>
inline constexpr std::size_t max_terms<Pack<Set>> = max_terms<double>;

template <class Set>
struct NumberIn<Pack<Set>> {
  using type = double;
};

}  // namespace rockstack

/// Vectors of packs go number by number.
template <class Set>
struct Eigen::NumTraits<rockstack::Pack<Set>> : Eigen::GenericNumTraits<rockstack::Pack<Set>> {
  using Literal = double;
};
