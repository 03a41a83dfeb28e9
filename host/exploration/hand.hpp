// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "host/exploration/explorer.hpp"

namespace echomap::exploration {

/// Which hand is held to the wall.
enum class Hand : std::uint8_t { kRight, kLeft };

/// The same in a mirror that lies along the x axis: what is done there with the right hand is done
/// here with the left.
geometry::Pose2 mirrored(const geometry::Pose2& T_map_robot);
Roll mirrored(const Roll& roll);

}  // namespace echomap::exploration
