// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "hil_mock/runner/descriptor.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::runner {

/// The host allows simulated time up to `until_us` and has written `host_bytes` bytes in all.
struct Grant {
  std::int64_t until_us = 0;
  std::uint64_t host_bytes = 0;
  bool operator==(const Grant&) const = default;
};

/// The host wants somebody to carry the robot off, and to hold it for so long.
struct CarryOff {
  std::int64_t held_us = 0;
  bool operator==(const CarryOff&) const = default;
};

/// The host wants somebody to put a square box down, in the frame of the robot's start pose.
struct PutBox {
  std::int64_t x_mm = 0;  ///< Of its middle.
  std::int64_t y_mm = 0;
  std::int64_t side_mm = 0;
  bool operator==(const PutBox&) const = default;
};

/// The host wants no byte to pass for so long.
struct CutCable {
  std::int64_t for_us = 0;
  bool operator==(const CutCable&) const = default;
};

/// The host wants to be told where the robot truly is, whenever a grant is reached.
struct TellTruth {
  bool operator==(const TellTruth&) const = default;
};

/// The host wants the truth files and the end.
struct Quit {
  bool operator==(const Quit&) const = default;
};

/// The host has closed its end.
struct HostGone {
  bool operator==(const HostGone&) const = default;
};

/// A line that is none of the protocol's.
struct BadRequest {
  std::string line;
  bool operator==(const BadRequest&) const = default;
};

/// All that a host can ask, well or badly.
using LockstepRequest =
    std::variant<Grant, CarryOff, PutBox, CutCable, TellTruth, Quit, HostGone, BadRequest>;

/// What a line of the host says (docs/guides/lockstep.md); without its line end.
LockstepRequest parse_request(std::string_view line);

/// The device's end of the lockstep channel: a Unix-domain socket for one host. No call waits.
class LockstepServer {
 public:
  /// Listens on `socket`, which appears only when it can be connected to; `hello` is the line that
  /// the host gets first. Throws std::system_error.
  LockstepServer(std::filesystem::path socket, std::string hello);
  ~LockstepServer();
  LockstepServer(const LockstepServer&) = delete;
  LockstepServer& operator=(const LockstepServer&) = delete;

  /// The host's next request, if one has come.
  std::optional<LockstepRequest> take_request();
  /// `T_start_robot` only for a host that wants it.
  void send_reached(std::int64_t until_us,
                    std::uint64_t device_bytes,
                    const std::optional<geometry::Pose2>& T_start_robot = std::nullopt);
  void send_bye();

  /// Readable when `take_request` has something to do.
  int descriptor() const;

 private:
  void accept_host();
  void send_line(const std::string& line) const;

  std::filesystem::path socket_;
  std::string hello_;
  Descriptor listener_;
  Descriptor host_;
  std::string received_;
  bool ended_ = false;
};

}  // namespace echomap::runner
