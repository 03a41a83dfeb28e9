// SPDX-License-Identifier: MIT
#pragma once

#include "protocol/configuration.hpp"

namespace echomap {
namespace app {

/// What holds until the host sends its own: a small two-wheel robot with 1496 counts per turn and
/// 0.065 m wheels that does 3300 counts/s at full duty after 80 ms.
constexpr protocol::ConfigureDrive kDefaultDrive{
    0,     // command_id
    0,     // inversions
    3000,  // max_ticks_per_s
    6000,  // max_ticks_per_s2
    20,    // feed_forward: 255 * 256 / 3300
    30,    // proportional and
    300,   // integral: both closed-loop poles at 15 /s
    20,    // odometry_period_ms
};

/// A small hobby servo.
constexpr protocol::ConfigurePan kDefaultPan{
    0,      // command_id
    0,      // kind: PanKind::kServo
    1500,   // centre_us
    900,    // us_per_90deg
    0,      // steps_per_turn
    -9000,  // min_cdeg
    9000,   // max_cdeg
    300,    // deg_per_s
};

/// An HC-SR04 for 4 m.
constexpr protocol::ConfigureSonar kDefaultSonar{
    0,      // command_id
    24000,  // max_echo_us
    40,     // ping_gap_ms
};

/// Cliffs, wheel-drop and virtual walls stop the wheels; a wall is for the host to follow.
constexpr protocol::ConfigureSafety kDefaultSafety{
    0,     // command_id
    0x3F,  // hazard_stops
    300,   // stall_ms
    200,   // runaway_ticks: 2.7 cm
    4500,  // over_speed_ticks_per_s: half as much again as the fastest command
};

/// The whole; no spare pin is used.
constexpr protocol::Configuration kDefaultConfiguration{
    kDefaultDrive,
    kDefaultSonar,
    kDefaultPan,
    protocol::ConfigurePins{},
    protocol::ConfigureSensors{},
    kDefaultSafety,
    protocol::ConfigureWiring{},
    protocol::ConfigureScalar{},
};

}  // namespace app
}  // namespace echomap
