// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "host/fleet/publications.hpp"
#include "host/fleet_messages/refused_reason.hpp"

namespace echomap::fleet {

/// Counts of the messages that a member has received so far.
struct ReceptionStatistics {
  std::size_t messages = 0;
  std::size_t bytes = 0;           ///< Topics and payloads.
  std::size_t duplicates = 0;      ///< Repetitions of the latest message of a topic.
  std::size_t outdated = 0;        ///< Older ones that the broker had retained or a robot relayed.
  std::size_t ignored_relays = 0;  ///< Of a robot that is alive and has not announced them.
  std::array<std::size_t, fleet_messages::kRefusedReasons> refused{};  ///< By RefusedReason.
};

/// What a member of a fleet has sent and received.
struct ExchangeStatistics {
  PublicationStatistics sent;
  ReceptionStatistics received;
  std::size_t waiting = 0;   ///< Messages that the byte budget holds back now.
  std::size_t requests = 0;  ///< Requests for what others have and this robot misses.
  std::size_t relays = 0;    ///< Messages of robots that are gone, published in their place.
  std::size_t unsaved = 0;   ///< Objects and graphs that could not be written to the folder.
};

}  // namespace echomap::fleet
