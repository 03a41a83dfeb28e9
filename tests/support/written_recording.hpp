// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "host/geometry/angle.hpp"
#include "host/recording/session_recorder.hpp"
#include "host/session/robot_profile.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"

namespace echomap::tests {

/// A recording that is written message by message, as the session of a robot writes it.
class WrittenRecording {
 public:
  explicit WrittenRecording(const session::RobotProfile& profile)
      : recorder_({profile.geometry, {}, {}}) {
    recorder_.describe("robot.toml", profile.toml);
    recorder_.describe("session", {{"robot", profile.name}, {"slam", "multiscan"}});
    recorder_.begin_session(0);
    recorder_.add_event({recording::SessionEventKind::kLinkReady, protocol::kProtocolMinor});
  }

  recording::SessionRecorder& recorder() { return recorder_; }
  void pass(std::chrono::milliseconds time) { recorder_.set_time(now_ += time); }

  /// The robot says something, 5 ms after what it said before.
  template <class Message>
  void receive(const Message& message, bool is_used = true) {
    pass(std::chrono::milliseconds(5));
    const protocol::ByteSpan frame = encoder_.encode(message, seq_++);
    std::optional<std::uint32_t> stamp_us;
    if constexpr (requires { message.stamp_us; }) {
      stamp_us = message.stamp_us;
    }
    recorder_.add_received(std::span(frame.data, frame.size), is_used ? stamp_us : std::nullopt);
  }
  void add(recording::SessionEventKind kind, std::int64_t value = 0) {
    recorder_.add_event({kind, value});
  }

  /// A stop 6.7 cm farther in a square room whose walls are so far ahead and to the sides.
  void add_stop(double range_m) {
    constexpr double kSpeedOfSound = 343.2;
    ticks_ = static_cast<std::int16_t>(ticks_ + 470);
    receive(protocol::Odometry{stamp_us_ += 20'000, ticks_, ticks_, 0});
    add(recording::SessionEventKind::kBeginScan);
    for (int i = 0; i < 31; ++i) {
      const auto pan_cdeg = static_cast<std::int16_t>(573 * i - 8595);
      const double pan_rad = geometry::radians(0.01 * pan_cdeg);
      const double wall_m = range_m / std::max(std::cos(pan_rad), std::abs(std::sin(pan_rad)));
      const auto flight_us = static_cast<std::uint16_t>(2e6 * wall_m / kSpeedOfSound);
      receive(protocol::Echo{stamp_us_ += 50'000, pan_cdeg, flight_us, ticks_, ticks_});
    }
    add(recording::SessionEventKind::kEndScan);
    recorder_.flush();
  }

  /// Stops from here on are in chunks of their own.
  void begin(const std::filesystem::path& file) { recorder_.open(file); }
  void save(const std::filesystem::path& file) {
    if (recorder_.path().empty()) {
      begin(file);
    }
    if (!std::exchange(is_saved_, true)) {
      recorder_.describe_ending({{"outcome", "complete"}});
      recorder_.finish();
    }
  }

 private:
  recording::SessionRecorder recorder_;
  protocol::FrameEncoder encoder_;
  time::HostTime now_;
  std::uint8_t seq_ = 0;
  std::uint32_t stamp_us_ = 0;
  std::int16_t ticks_ = 0;
  bool is_saved_ = false;
};

}  // namespace echomap::tests
