// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/fleet/fleet_state.hpp"
#include "host/fleet_member/team_picture.hpp"

namespace echomap::apps {

/// How far a fleet has come.
struct FleetProgress {
  /// "robot0 12 stops, robot1 9, 2 of 2 on one map, in 4:31".
  std::string line;
  double elapsed_s = 0.0;  ///< Of the robots' time, at the end of the last stop that was told.
};

/// What has been told until now, of all maps of each robot; those are on one map that are joined
/// with `first_map`, the present one of the first robot.
FleetProgress progress_of(const fleet::FleetState& state,
                          const fleet_member::TeamPicture& picture,
                          const std::string& first_map);

/// Prints such a line for every half minute of the robots' time.
class FleetProgressPrinter {
 public:
  void print(const FleetProgress& progress);

 private:
  double next_line_s_ = 30.0;
};

}  // namespace echomap::apps
