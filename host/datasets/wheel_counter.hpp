// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace echomap::datasets {

/// Makes increments of an encoder's readings; the first one is where it starts.
class WheelCounter {
 public:
  double increment(double reading) {
    const double step = last_ ? reading - *last_ : 0.0;
    last_ = reading;
    return step;
  }

 private:
  std::optional<double> last_;
};

}  // namespace echomap::datasets
