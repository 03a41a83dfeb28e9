// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/live_page/foxglove_topics.hpp"
#include "host/live_page/socket_protocol.hpp"

namespace echomap::live_page {

/// So many bytes may wait for a client before messages that may be left out are.
inline constexpr std::size_t kMaxWaitingFoxgloveBytes = std::size_t{1} << 20;

/// The Foxglove protocol under each of its names, the preferred one first. `topics` outlive the
/// clients; what is new goes to them in the thread that adds it to the topics.
std::vector<NamedProtocol> foxglove_protocols(FoxgloveTopics& topics);

}  // namespace echomap::live_page
