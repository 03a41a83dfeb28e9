// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/models/range_likelihood.hpp"

namespace echomap::models {

/// The sonar of Singh and Bedi 2013.
struct GaussianRangeParams {
  double sense_stddev_m = 0.03;  ///< Their sense noise (section 4.5).
  double max_range_m = 2.55;     ///< Of the NXT's sonar, whose 255 stands for no echo.
};

/// One factor of equation (1) of Singh and Bedi 2013: a normal density of the range around that
/// which the map lets expect. A reading without echo says nothing; where the map lets nothing
/// expect, an echo counts as one that was expected from the greatest range.
class GaussianRange {
 public:
  /// Throws std::invalid_argument for a parameter that is not above 0 and finite.
  explicit GaussianRange(const GaussianRangeParams& params = {});

  double likelihood(std::optional<double> range_m, const ExpectedRange& expected) const;

 private:
  GaussianRangeParams params_;
};

}  // namespace echomap::models
