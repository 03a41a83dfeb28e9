// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace echomap::tests {

/// Whether a test runs every seed, as in `./run test --full`, or the first ones.
inline bool runs_every_seed() { return std::getenv("ECHOMAP_SOAK") != nullptr; }

}  // namespace echomap::tests
