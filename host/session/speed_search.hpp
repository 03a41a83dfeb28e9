// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "host/transport/byte_stream.hpp"

namespace echomap::session {

/// The speeds that there are images for on every board, bits per second, the usual one first.
inline constexpr std::array<int, 3> kRobotBauds{250000, 115200, 500000};

/// The speed of the robot at the end of an open line: says Hello of `session` at each of
/// kRobotBauds in turn until a frame comes, for `patience` at most; a board that opening the port
/// has reset takes 2.5 s to speak. The line is left at the speed found, and at the usual one where
/// none answers. Empty then, and at once where the line has no speed.
std::optional<int> find_speed(transport::ByteStream& stream,
                              std::uint16_t session,
                              std::chrono::milliseconds patience = std::chrono::milliseconds(3000));

}  // namespace echomap::session
