// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "host/fleet_messages/payload.hpp"

namespace echomap::fleet {

/// Freshness of a message by its boot id and counter.
enum class Freshness : std::uint8_t {
  kNew,
  kDuplicate,  ///< The latest of its topic again, as delivery at least once may send.
  kOutdated,   ///< An older one that the broker had retained or a robot relayed.
  kReplayed,   ///< A later one of its topic was received before.
  kOldBoot,    ///< Its author has started again since.
};

/// Stores the latest boot id and counter of each topic; those of new messages must be larger.
class ReplayGuard {
 public:
  /// Classifies a message, and stores its counter where it is new. With `is_of_the_past` the
  /// message was retained or relayed, so that an older one is not a replay.
  Freshness take(const std::string& topic,
                 const fleet_messages::Sender& sender,
                 bool is_of_the_past);
  /// Whether the message is newer than all that is known of its topic.
  bool is_news(const std::string& topic, const fleet_messages::Sender& sender) const;
  /// The robot's latest boot id; 0 where it is not known.
  std::uint32_t boot_id(const std::string& robot) const;

 private:
  /// Boot id and counter.
  using Stamp = std::pair<std::uint32_t, std::uint32_t>;

  std::map<std::string, Stamp> latest_;
  std::map<std::string, std::uint32_t> boot_ids_;
};

}  // namespace echomap::fleet
