#pragma once

namespace rockstack::testing {

/// A test takes one in so many of long rows of random cases: all of them, or each fifth under sanitizers.
/// There each takes some ten times as long, and what sanitizers look for lies on a path, which few cases walk
/// as well as many. No divisor of 4, as each fourth scene of many rows has a ground at rest.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int stride = 5;
#else
inline constexpr int stride = 1;
#endif

}  // namespace rockstack::testing
