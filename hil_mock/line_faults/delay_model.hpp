// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "hil_mock/world/noise.hpp"

namespace echomap::line_faults {

/// What delays bytes in one direction of a line. Shares are of frames, times microseconds.
struct DelayParams {
  std::int64_t shortest_us = 0;
  /// Bytes wait for the next of regular transfers; 0 where they do not wait.
  std::int64_t poll_us = 0;
  /// Whether those keep their pace to the microsecond, so that telemetry of a robot whose clock is
  /// nearly as fast waits nearly as long every time (a beat); else each wait is random.
  bool poll_beats = false;
  /// Mean of an exponential part.
  double exponential_us = 0.0;
  /// Retransmissions of a radio.
  double stall_share = 0.0;
  std::int64_t stall_us = 0;
  /// The host is busy for up to `host_stall_us`.
  double host_stall_share = 0.0;
  std::int64_t host_stall_us = 0;
};

/// A board with native USB or a 1 ms bridge: full-speed frames of 1 ms.
DelayParams usb_delays();
/// An FTDI bridge with its default latency timer of 16 ms. Only the way to the host waits for it.
DelayParams ftdi_delays();
/// Bluetooth serial port profile (HC-05): 8 ms, exponential 6 ms, 2 % stalls of 150 ms.
DelayParams bluetooth_delays();

/// Both directions of a line.
struct LineDelays {
  DelayParams to_robot;
  DelayParams to_host;
};
LineDelays usb_line();
LineDelays ftdi_line();
LineDelays bluetooth_line();

/// "usb", "ftdi" or "bluetooth". Throws std::invalid_argument for another name.
LineDelays line_delays(const std::string& name);

/// Seeded delays of one direction. Nothing overtakes: a byte that would arrive before an earlier
/// one arrives with it.
class DelayModel {
 public:
  DelayModel(const DelayParams& params, world::NoiseStream noise);

  /// When bytes sent at `sent_us` arrive, both on the host's clock; `sent_us` never goes back.
  std::int64_t arrival_us(std::int64_t sent_us);

 private:
  std::int64_t draw_delay_us();

  DelayParams params_;
  world::NoiseStream noise_;
  std::int64_t poll_phase_us_ = 0;
  std::int64_t last_arrival_us_ = 0;
};

}  // namespace echomap::line_faults
