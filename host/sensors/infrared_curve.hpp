// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace echomap::sensors {

/// One point of an infra-red sensor's curve: converter counts in front of a wall at a range.
struct InfraredPoint {
  double counts = 0.0;
  double range_m = 0.0;
};

/// Range of an infra-red sensor from its converter counts. Between two points a power law holds, as
/// reflected light follows (Benet et al. 2002, equation 4); two points are one power law.
class InfraredCurve {
 public:
  /// The nearest point first. Throws std::invalid_argument unless there are two, all positive, with
  /// falling counts and growing ranges.
  explicit InfraredCurve(std::vector<InfraredPoint> points);

  /// Empty for fewer counts than those of the farthest point: nothing is in reach. More counts than
  /// the nearest point's are taken for its range: what is nearer looks no nearer.
  std::optional<double> range_m(double counts) const;
  double max_m() const { return points_.back().range_m; }

 private:
  std::vector<InfraredPoint> points_;
};

}  // namespace echomap::sensors
