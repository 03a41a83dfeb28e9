// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>
#include <stddef.h>
#include <stdint.h>

#include "firmware/boards/ev3/options.hpp"

namespace echomap {
namespace boards {

/// Finds the motors at outA, outB and outC; absent ones, and those that this user may not drive,
/// are told of and do nothing.
void open_motors(const char* sysfs);
/// Takes back whatever the motors were set to. One that turns the sonar keeps its place where the
/// program starts `again`: it stands anywhere then, and its cable knows where.
void reset_motors(bool again);
/// Writes again each stop that the kernel has refused; once a control cycle.
void repeat_refused_stops();
/// No current, no brake, tried twice where the kernel refuses it; may be called by a signal's
/// handler, and by the guard.
void stop_all_motors();

/// Finds the sensors at in1 .. in4; absent ones are told of.
void open_sensors(const char* sysfs);

/// Opens the line to the host, or begins to wait for it.
void start_line(const Line& line);
/// Hands what the program wants to send to the kernel, as far as that takes it.
void send_to_line();
/// Tells the program a few bytes that have come; false when there were none.
bool receive_from_line();
/// Fills in what to wait for, and answers how many they are.
constexpr nfds_t kMaxWaits = 2;
nfds_t waits_of_line(pollfd (&waits)[kMaxWaits]);

}  // namespace boards
}  // namespace echomap
