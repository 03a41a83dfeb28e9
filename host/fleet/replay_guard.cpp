// SPDX-License-Identifier: MIT
#include "host/fleet/replay_guard.hpp"

#include <algorithm>

namespace echomap::fleet {

Freshness ReplayGuard::take(const std::string& topic,
                            const fleet_messages::Sender& sender,
                            bool is_of_the_past) {
  const Stamp stamp{sender.boot_id, sender.counter};
  std::uint32_t& boot_id = boot_ids_[sender.robot];
  const auto latest = latest_.find(topic);
  if (latest != latest_.end() && latest->second == stamp) {
    return Freshness::kDuplicate;
  }
  const bool is_older = latest != latest_.end() && stamp < latest->second;
  if (is_of_the_past && is_older) {
    return Freshness::kOutdated;
  }
  if (!is_of_the_past && sender.boot_id < boot_id) {
    return Freshness::kOldBoot;
  }
  if (is_older) {
    return Freshness::kReplayed;
  }
  latest_[topic] = stamp;
  boot_id = std::max(boot_id, sender.boot_id);
  return Freshness::kNew;
}

bool ReplayGuard::is_news(const std::string& topic, const fleet_messages::Sender& sender) const {
  const auto latest = latest_.find(topic);
  return latest == latest_.end() || latest->second < Stamp{sender.boot_id, sender.counter};
}

std::uint32_t ReplayGuard::boot_id(const std::string& robot) const {
  const auto found = boot_ids_.find(robot);
  return found == boot_ids_.end() ? 0 : found->second;
}

}  // namespace echomap::fleet
