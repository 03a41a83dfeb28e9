// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace echomap::bench {

/// Milliseconds that mapping::SonarMapper takes for one more stop, from its readings to the grid,
/// where it has that many, in a generated hall of 30 x 30 m with a post every 2.5 m. `stops` is at
/// most 1,023.
double stop_ms(std::size_t stops);

}  // namespace echomap::bench
