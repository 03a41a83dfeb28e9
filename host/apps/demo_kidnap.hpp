// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/apps/live_run.hpp"
#include "host/exploration/explorer.hpp"
#include "host/localization/monte_carlo_localizer.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/robot_context.hpp"

namespace echomap::apps {

/// What a localizer told at the end of a stop.
struct KidnapStop {
  localization::LocalizationStatus status = localization::LocalizationStatus::kLost;
  /// Probability that the robot is not at the first hypothesis.
  double lost_probability = 1.0;
  /// The first hypothesis, in the frame of the robot's own map; empty where there is none.
  std::optional<pipeline::StampedPose> told;
  /// Where it may be: tracking::places_that_fit.
  std::size_t places = 0;
};

/// What became of a robot that was carried off at the end of its exploration.
struct DemoKidnap {
  bool is_noticed = false;
  /// The exploration's trajectory, where SLAM has it at its end.
  std::vector<pipeline::StampedPose> explored;
  /// Since it was put down; none where the session ended before.
  std::vector<KidnapStop> stops;
  /// Why it drove no further before its place was sure; empty at the limit of stops.
  std::optional<exploration::FinishReason> gave_up;
};

/// Lets the localizer follow a simulated robot in the map that it has made, has the robot carried
/// off by its world and drives on until the localizer is sure again, for a few stops at most,
/// placed by the SLAM method of that name. Ends early where the session does.
DemoKidnap show_kidnap(session::RobotContext& robot, LiveRun& live, const std::string& slam);

}  // namespace echomap::apps
