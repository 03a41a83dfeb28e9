// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "host/fleet/fleet_state.hpp"
#include "host/session/child_process.hpp"

namespace echomap::apps {

/// The members of a simulated fleet, each a process of its own: one that dies takes no other with
/// it.
class MemberProcesses {
 public:
  /// Its output goes to `log`.
  void start(const std::string& name,
             const std::vector<std::string>& command,
             const std::filesystem::path& log);

  /// Whether any of them goes on.
  bool go_on();
  /// Tells all to end.
  void interrupt();
  /// For the last files of a member behind its end, half a minute at most.
  void wait_for_all();

  const std::vector<std::string>& names() const { return names_; }
  /// Exit statuses by name; null of one that was not heard to end.
  nlohmann::ordered_json exits() const;
  /// Whether one ended otherwise than by saying what became of its run.
  bool has_lost_one() const;
  /// Whether one has ended of which the fleet has never heard: the others would wait for its first
  /// round.
  bool has_lost_one_unheard(const fleet::FleetState& state) const;
  /// Those that did not get what they were asked for, "robot1 (exit 8)"; last those that were told
  /// to end.
  std::vector<std::string> unfinished() const;

 private:
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<session::ChildProcess>> processes_;
  std::vector<std::optional<int>> statuses_;
};

}  // namespace echomap::apps
