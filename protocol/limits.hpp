// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// What a robot takes: it refuses larger numbers, and the host refuses a profile that holds them.

/// Fastest wheel, in ConfigureDrive, MoveTicks and DriveSetpoint.
constexpr uint16_t kMaxTicksPerS = 32000;
/// Largest feed-forward, proportional and integral gain of ConfigureDrive.
constexpr uint16_t kMaxGain = 32767;
/// Longest way of one wheel in MoveTicks.
constexpr int32_t kMaxMoveTicks = 500000;
/// Time to live where a message says 0, and the longest one.
constexpr uint16_t kDefaultTimeToLiveMs = 200;
constexpr uint16_t kMaxTimeToLiveMs = 500;
/// Farthest pan of a stepper, and its most half steps a turn.
constexpr int32_t kMaxPanCdeg = 72000;
constexpr uint16_t kMaxStepsPerTurn = 8192;
/// Shortest and longest pulse of the pan servo, for every pan of ConfigurePan.
constexpr uint16_t kMinServoPulseUs = 400;
constexpr uint16_t kMaxServoPulseUs = 2600;
/// Largest stall_ms and runaway_ticks of ConfigureSafety.
constexpr uint16_t kMaxStallMs = 1000;
constexpr uint16_t kMaxRunawayTicks = 32000;
/// Shortest gyro_period_ms of ConfigureSensors but 0: a transfer takes 0.12 ms, and a tick may be
/// late by one.
constexpr uint8_t kMinGyroPeriodMs = 2;
/// Longest period_ms of ConfigureScalar.
constexpr uint16_t kMaxScalarPeriodMs = 2000;
/// Longest wait at each reading of StartSweep.
constexpr uint16_t kMaxSettleMs = 10000;
/// A sweep ends when the robot has heard nothing for this long; a host pings once a second. The
/// coils of a stepper get hot, and nobody would switch them off.
constexpr uint16_t kMaxSweepSilenceMs = 30000;

}  // namespace protocol
}  // namespace echomap
