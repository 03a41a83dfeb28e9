// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/models/range_likelihood.hpp"

namespace echomap::models {

/// An infra-red sensor of a few centimetres, as the e-puck's eight; ours, for the simulated one
/// unless a source is named.
struct InfraredRangeParams {
  double max_range_m = 0.06;  ///< Mahmood and Ridao 2017, section 4.
  /// Noise of a range next to nothing, of cells and particles, and what the light adds at the end
  /// of the range.
  double near_stddev_m = 0.003;
  double far_stddev_m = 0.004;
  /// Chances that a wall is not seen: straight ahead, and aslant.
  double silent_chance = 0.1;
  double oblique_silent_chance = 0.7;
  /// That light from elsewhere makes any range.
  double random_chance = 0.05;
};

/// A sensor of reflected light. What comes back falls with the square of the range (Benet et al.
/// 2002, equation 4), so that one step of the converter is a length that grows with the third power
/// of the range: sigma(r) = near + far (r / max)^3. A wall that is "almost perpendicular" answers
/// (Mahmood and Ridao 2017, section 4); one aslant is silent, or answers weakly and so seems to be
/// anywhere from its noise before it up to the end of the range.
class InfraredRange {
 public:
  /// Throws std::invalid_argument for chances that leave nothing for a hit, and for a noise or
  /// range that is not above 0.
  explicit InfraredRange(const InfraredRangeParams& params = {});

  double likelihood(std::optional<double> range_m, const ExpectedRange& expected) const;

 private:
  InfraredRangeParams params_;
};

}  // namespace echomap::models
