// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::sensors {

/// Distance that each wheel has rolled since the session began, forward positive.
struct WheelTravel {
  double left_m = 0.0;
  double right_m = 0.0;
};

}  // namespace echomap::sensors
