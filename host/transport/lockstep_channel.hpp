// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "host/transport/byte_stream.hpp"
#include "host/transport/lockstep_lines.hpp"

namespace echomap::transport {

/// The host's end of the channel that grants simulated time; docs/guides/lockstep.md is its
/// protocol. After a grant, read the byte stream until `device_bytes` have come and handle them all
/// before the next one. A step of at most 100 ms keeps them within what a pty holds (4 KiB).
class LockstepChannel {
 public:
  /// Connects to the socket and reads the device's hello; throws TransportError. `patience` is real
  /// time, for every answer: a device that is silent for longer counts as gone.
  explicit LockstepChannel(const std::string& socket_path,
                           std::chrono::milliseconds patience = std::chrono::seconds(60));

  const DeviceInfo& device() const { return device_; }

  /// Lets the device run up to `until_us`, `host_bytes` having been written to the byte stream in
  /// all. Empty when the device is gone or answers nonsense: see `close_reason()`.
  std::optional<Reached> grant(std::int64_t until_us, std::uint64_t host_bytes);

  /// Somebody takes the robot up now, holds it for so long and puts it down somewhere else.
  void carry_off(std::chrono::microseconds held);

  /// Somebody puts a square box down now, with its middle there in the frame of the robot's start
  /// pose, parallel to its axes; nobody does where the robot is in the way.
  void put_box(double x_m, double y_m, double side_m);

  /// No byte of the byte stream reaches the other end for so long of simulated time, from now on.
  void cut_cable(std::chrono::microseconds away);

  /// From the next grant on the device tells where the robot truly is: for show, not for a host
  /// that estimates it.
  void tell_truth();
  /// Where it was at the end of the last grant; empty where the device was not asked.
  const std::optional<TruePose>& true_pose() const { return true_pose_; }

  /// Ends the device; true when it confirms that its truth files are on disk.
  bool quit();

  /// Empty as long as the device answers.
  const std::string& close_reason() const { return close_reason_; }

 private:
  void send_line(const std::string& line);
  std::optional<std::string> read_line();
  DeviceInfo read_hello(const std::string& socket_path);

  std::unique_ptr<ByteStream> stream_;
  std::chrono::milliseconds patience_;
  std::string received_;
  std::string close_reason_;
  DeviceInfo device_;
  std::optional<TruePose> true_pose_;
};

}  // namespace echomap::transport
