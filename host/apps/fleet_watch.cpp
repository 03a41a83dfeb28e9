// SPDX-License-Identifier: MIT
#include "host/apps/fleet_watch.hpp"

#include <algorithm>
#include <memory>
#include <thread>

#include "host/apps/commands.hpp"
#include "host/apps/stop_trajectory.hpp"
#include "host/console/interrupt.hpp"
#include "host/fleet/exchange_params.hpp"
#include "host/fleet_messages/topic.hpp"

namespace echomap::apps {

FleetWatch::FleetWatch(const std::filesystem::path& credentials)
    : connection_(connect_to_fleet(credentials)),
      knowledge_(connection_.credentials.fleet, "", fleet::FleetExchangeParams().gone_after_s) {
  connection_.bus->subscribe(fleet_messages::fleet_filter(fleet()));
}

double FleetWatch::now_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

std::vector<mqtt::Message> FleetWatch::listen() {
  std::vector<mqtt::Message> messages = connection_.bus->take();
  for (const mqtt::Message& message : messages) {
    knowledge_.take(message, now_s());
  }
  return messages;
}

void FleetWatch::require_own_account() const {
  if (connection_.bus->was_taken_over()) {
    throw CommandError(ExitCode::kRuntimeError,
                       "somebody else has connected as " + connection_.credentials.user +
                           "\n  next: use the credentials of nobody else, as watch.toml of the "
                           "broker's members is to look on");
  }
}

void FleetWatch::listen_for(double seconds) {
  const double end_s = now_s() + seconds;
  while (now_s() < end_s && !console::interrupted()) {
    listen();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::optional<pipeline::Snapshot> team_snapshot(fleet_member::TeamPicture& picture,
                                                const std::string& map_name) {
  if (picture.team().component_of(map_name) == nullptr) {
    return std::nullopt;
  }
  const team_map::MergedMap& merged = picture.team().merged(map_name);
  pipeline::Snapshot snapshot;
  snapshot.trajectory = std::make_shared<const std::vector<pipeline::StampedPose>>(
      trajectory_of(picture.team().stop_ends(map_name)));
  snapshot.points = std::make_shared<const mapping::PointCloudMap>();
  snapshot.landmarks = std::make_shared<const std::vector<pipeline::SeenLandmark>>();
  snapshot.last_scan = std::make_shared<const mapping::Scan>();
  snapshot.grid = merged.grid;
  snapshot.scans = merged.scans;
  snapshot.features = merged.features;
  snapshot.stops = merged.scans->size();
  return snapshot;
}

std::string latest_map(const fleet::FleetState& state, const std::string& robot) {
  std::string latest = fleet_member::map_name(robot, 0);
  for (const fleet::FleetRobot& one : state.robots) {
    for (const fleet::FleetMap& map : one.maps) {
      if (one.name == robot && !map.record->submaps.empty()) {
        latest = fleet_member::map_name(robot, map.number);
      }
    }
  }
  return latest;
}

std::string largest_map(const fleet_member::TeamPicture& picture) {
  const auto& components = picture.team().components();
  const auto largest = std::max_element(
      components.begin(), components.end(), [](const auto& one, const auto& other) {
        return one.robots.size() < other.robots.size();
      });
  return largest == components.end() ? "" : largest->robots.front();
}

}  // namespace echomap::apps
