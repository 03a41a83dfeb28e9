// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::sensors {

/// The whole angle in which a sonar hears, from edge to edge, and the bounds between which it lies
/// with a confidence of 95 %.
struct BeamWidth {
  double beam_width_rad = 0.0;
  double low_rad = 0.0;
  double high_rad = 0.0;
};

}  // namespace echomap::sensors
