// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "host/fleet/publications.hpp"
#include "host/fleet_messages/refused_reason.hpp"

namespace echomap::fleet {

/// What has come so far.
struct ReceptionStatistics {
  std::size_t messages = 0;
  std::size_t bytes = 0;           ///< Topics and payloads.
  std::size_t duplicates = 0;      ///< The latest of their topic once more.
  std::size_t outdated = 0;        ///< Kept by the broker or a relay from before.
  std::size_t ignored_relays = 0;  ///< Of a robot that is here and has not said that it made them.
  std::array<std::size_t, fleet_messages::kRefusedReasons> refused{};  ///< By RefusedReason.
};

/// What a member of a fleet has sent and heard.
struct ExchangeStatistics {
  PublicationStatistics sent;
  ReceptionStatistics received;
  std::size_t waiting = 0;  ///< Messages that the byte budget holds back now.
  std::size_t asks = 0;     ///< For what others have and this robot misses.
  std::size_t relays = 0;   ///< Messages of robots that are gone, published in their place.
  std::size_t unsaved = 0;  ///< Objects and graphs that could not be written to the folder.
};

}  // namespace echomap::fleet
