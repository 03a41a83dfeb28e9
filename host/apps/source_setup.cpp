// SPDX-License-Identifier: MIT
#include "host/apps/source_setup.hpp"

#include <optional>

#include "host/apps/commands.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {

using session::RobotProfile;

void validate_searcher(const RobotProfile& profile) {
  const auto& scalar = profile.sensors.scalar;
  if (scalar && scalar->kind == sensors::ScalarKind::kPulses) {
    return;
  }
  throw CommandError(
      ExitCode::kConfigInvalid,
      (scalar ? "a source is searched by pulses, and the [scalar] sensor of profile '" +
                    profile.name + "' reads a level"
              : "profile '" + profile.name + "' has no [scalar] sensor to search a source by") +
          "\n  next: add a table [scalar] of pulses (docs/guides/robot_profile.md), or: "
          "echomap search --robot uno_geiger");
}

source_search::SourceReadingsParams source_readings_params(const RobotProfile& profile) {
  source_search::SourceReadingsParams params;
  params.dead_time_s = profile.sensors.scalar ? profile.sensors.scalar->dead_time_s : 0.0;
  return params;
}

source_search::SourceSearchParams source_search_params(const RobotProfile& profile) {
  source_search::SourceSearchParams params;
  params.frontier = strategies::frontier_params(profile, std::nullopt);
  params.choice.speed_m_per_s = profile.speed_m_per_s;
  return params;
}

}  // namespace echomap::apps
