// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/datasets/log_record.hpp"

namespace echomap::datasets {

/// Makes increments of the readings of two encoders that count on; the first pair is where they
/// start.
class WheelCounters {
 public:
  /// `reading_m` is what a wheel rolls while its encoder counts one.
  WheelCounters(double reading_m, double track_m) : reading_m_(reading_m), track_m_(track_m) {}

  WheelIncrement increment(std::optional<double> stamp_s, double left, double right) {
    const Readings last = last_.value_or(Readings{left, right});
    last_ = Readings{left, right};
    return {stamp_s, (left - last.left) * reading_m_, (right - last.right) * reading_m_, track_m_};
  }

 private:
  struct Readings {
    double left = 0.0;
    double right = 0.0;
  };

  double reading_m_;
  double track_m_;
  std::optional<Readings> last_;
};

}  // namespace echomap::datasets
