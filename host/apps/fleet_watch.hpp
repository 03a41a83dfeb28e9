// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/apps/fleet_connection.hpp"
#include "host/fleet/fleet_knowledge.hpp"
#include "host/fleet_member/team_picture.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::apps {

/// Looks on at a fleet: hears all that its robots say, and says nothing.
class FleetWatch {
 public:
  /// Connects with these credentials. Throws as connect_to_fleet.
  explicit FleetWatch(const std::filesystem::path& credentials);

  /// Takes in what has come, and answers it.
  std::vector<mqtt::Message> listen();
  /// Listens for so long, or until Ctrl-C.
  void listen_for(double seconds);
  /// Throws CommandError where somebody else has connected with the same credentials meanwhile:
  /// each of the two throws the other one out.
  void require_own_account() const;
  /// Seconds since it was connected.
  double now_s() const;

  fleet::FleetState state() const { return knowledge_.state(now_s()); }
  /// How many objects the fleet has that have not been heard.
  std::size_t missing_objects() const { return knowledge_.missing_objects(); }
  std::uint64_t revision() const { return knowledge_.revision(); }
  const fleet::ReceptionStatistics& statistics() const { return knowledge_.statistics(); }
  const std::string& fleet() const { return connection_.credentials.fleet; }

 private:
  FleetConnection connection_;
  fleet::FleetKnowledge knowledge_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The map of all that are joined to that map of a robot, in its frame, as a snapshot whose path
/// has one pose for each of its stops; empty where nothing is known of it.
std::optional<pipeline::Snapshot> team_snapshot(fleet_member::TeamPicture& picture,
                                                const std::string& map_name);

/// The name of the last map of a robot that has a stop; of its first one where none has.
std::string latest_map(const fleet::FleetState& state, const std::string& robot);

/// The name of the map with the most others joined to it, the first of several; empty where there
/// is none.
std::string largest_map(const fleet_member::TeamPicture& picture);

}  // namespace echomap::apps
