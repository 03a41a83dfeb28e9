// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace echomap::transport {

/// What runs at the other end of a lockstep channel.
struct DeviceInfo {
  std::string firmware;  ///< For example "echomap-uno 0.1.0".
  std::string emulator;  ///< For example "simavr 1.6".
};

/// Where a simulated robot truly is, seen from where it started.
struct TruePose {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;  ///< -pi to pi.
};

/// The answer to a grant.
struct Reached {
  std::int64_t until_us = 0;       ///< Simulated time, microseconds since power-on.
  std::uint64_t device_bytes = 0;  ///< All that the device has written to the byte stream so far.
  std::optional<TruePose> true_pose{};  ///< Only of a device that was asked to tell.
};

/// The device's first line, `{"lockstep":1, ..}`; empty where it is not one.
std::optional<DeviceInfo> parse_lockstep_hello(std::string_view line);

/// The line `reached UNTIL_US DEVICE_BYTES` or `reached UNTIL_US DEVICE_BYTES X_UM Y_UM
/// HEADING_UDEG`; empty where it is neither.
std::optional<Reached> parse_reached(std::string_view line);

}  // namespace echomap::transport
