// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/apps/commands.hpp"
#include "host/apps/run_ending.hpp"
#include "host/fleet_member/team_picture.hpp"
#include "host/live_page/page_server.hpp"
#include "host/live_page/run_publisher.hpp"
#include "host/mqtt/message_bus.hpp"

namespace echomap::apps {

/// The live page of a fleet: all robots with their trails and claims, on the map that they have in
/// common. Without `LiveOptions::serves` it does nothing.
class FleetPage {
 public:
  /// Says where the page is and opens it. Throws CommandError where it cannot listen.
  FleetPage(const LiveOptions& options,
            const session::RobotProfile& profile,
            const std::filesystem::path& out);

  /// Notes each pose that was told among these messages: trails have them all, however seldom the
  /// page is brought up to date.
  void hear(const std::vector<mqtt::Message>& messages);
  /// Shows the map of that name and who is on it.
  void show(double time_s,
            const fleet::FleetState& state,
            fleet_member::TeamPicture& picture,
            const std::string& map_name);
  /// Says how it has ended, and serves on as long as somebody watches.
  void end(double time_s, const RunEnding& ending);

 private:
  live_page::TeamRobot shown(const fleet::FleetRobot& robot,
                             const fleet_member::TeamPicture& picture,
                             const std::string& map_name) const;

  /// Where a fleet believes its source to be; empty where nobody searches.
  const std::optional<live_page::TeamSource>& source(double time_s,
                                                     const fleet::FleetState& state,
                                                     fleet_member::TeamPicture& picture,
                                                     const std::string& map_name);

  std::shared_ptr<live_page::RunPublisher> publisher_;
  std::unique_ptr<live_page::PageServer> server_;
  /// By the name of a robot's own map, some centimetres apart.
  std::map<std::string, std::vector<Eigen::Vector2d>> trails_m_;
  std::shared_ptr<const mapping::OccupancyGrid> grid_;  ///< That is shown.
  std::optional<live_page::TeamSource> source_;
  std::optional<std::uint64_t> source_revision_;  ///< Of the fleet's state.
  double sourced_s_ = 0.0;
};

}  // namespace echomap::apps
