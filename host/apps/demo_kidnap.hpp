// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "host/evaluation/trajectory_error.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// What became of a robot that was carried off at the end of its exploration.
struct DemoKidnap {
  bool is_noticed = false;
  std::size_t stops = 0;  ///< Since it was put down.
  /// Where it was believed to be at the start of its exploration, and where at its last stop; empty
  /// where it is not sure of that.
  pipeline::StampedPose start;
  std::optional<pipeline::StampedPose> found;
};

/// Lets the localizer follow a simulated robot in the map that it has made, has the robot carried
/// off by its world and drives on until the localizer is sure again, for a few stops at most,
/// placed by the SLAM method of that name. Ends early where the session does.
DemoKidnap show_kidnap(session::RobotContext& robot, const std::string& slam);

/// noticed, found (within 15 cm and 10 degrees of the truth), stops, error_m and heading_error_rad,
/// which are null where the localizer was not sure.
nlohmann::ordered_json kidnap_report(const DemoKidnap& kidnap,
                                     const std::vector<evaluation::TruePose>& truth);

/// The same for people, in a line.
std::string kidnap_line(const nlohmann::ordered_json& report);

}  // namespace echomap::apps
