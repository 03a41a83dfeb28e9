// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::exploration {

/// The turn from one heading to another, both in (-pi, pi]: the shorter way, but a turn of more
/// than a right angle goes round by the heading of the start, 0. An error of the wheel track adds
/// up with every turn in the same sense; so it comes back to nothing.
double unwinding_turn_rad(double heading_rad, double target_rad);

}  // namespace echomap::exploration
