#pragma once

#include "analytic/scene/scene.hpp"

namespace rockstack::testing {

/// The two blocks of Spanos et al. 2001 released at 0.15 rad, as in their Fig. 18.
Scene two_blocks_free();

/// Two blocks at rest, under a made-up record of 0.71 g and 20 s.
Scene two_blocks_recorded();

/// A block of 0.5 m by 2.5 m released at 0.15 rad.
Scene one_block_free();

/// One block at rest, under a sine of 4 m/s² and half a second.
Scene one_block_pulse();

}  // namespace rockstack::testing
