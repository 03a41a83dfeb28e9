// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What became of a robot that was followed for hours.
struct SoakScore {
  double hours = 0.0;
  std::size_t updates = 0;  ///< By odometry, at 100 Hz.
  int stops = 0;
  int right = 0;         ///< Stops where it was believed within 15 cm and 10 degrees.
  int false_alarms = 0;  ///< Called lost while it was believed right at the stop before.
  std::size_t not_finite = 0;
  std::size_t min_particles = 0;
  double grown_mb = 0.0;  ///< Memory of this program since a tenth of the time.

  /// Nothing broke: all finite, never without particles, memory flat, mostly right, and at most one
  /// false alarm an hour.
  bool holds() const;
};

/// Follows a robot that drives about in a bundled room from where it is known to stand: at 0.2 m/s
/// and 1 rad/s, with 24 pings all round, for 2 s, after each way.
SoakScore soak_localizer(double hours, std::uint32_t seed);

/// The score as figures.
std::vector<Figure> soak_figures(const SoakScore& score);

}  // namespace echomap::bench
