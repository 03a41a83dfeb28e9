// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "host/fleet_messages/payload.hpp"

namespace echomap::fleet {

/// What a message is by its boot id and counter.
enum class Freshness : std::uint8_t {
  kNew,
  kDuplicate,  ///< The latest of its topic once more, as deliveries at least once may be.
  kOutdated,   ///< The broker or a relay had it from before.
  kReplayed,   ///< A later one of its topic has come before.
  kOldBoot,    ///< Its author has started again since.
};

/// Remembers of each topic the latest boot id and counter, of which others must be larger.
class ReplayGuard {
 public:
  /// `is_of_the_past`: the message was kept by somebody, so that an older one is no offence.
  Freshness take(const std::string& topic,
                 const fleet_messages::Sender& sender,
                 bool is_of_the_past);
  /// Whether nothing of the topic is known, or only what is older.
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
