// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "host/time/host_time.hpp"
#include "host/time/lower_hull.hpp"
#include "host/time/robot_time.hpp"

namespace echomap::time {

/// How the clocks are compared.
struct ClockSyncParams {
  using Duration = HostClock::duration;
  /// How far back telemetry and pings count: long against a beat of the robot's clock with the
  /// line's (20 s for 50 ppm at 1 ms), short against the drift of a resonator, about 10 ppm per
  /// kelvin.
  Duration window = std::chrono::seconds(60);
  /// Between two fits of the line.
  Duration fit_period = std::chrono::milliseconds(250);
  /// Largest rate error of a board: a resonator's 5000 ppm and what it drifts by heat.
  double max_rate_error_ppm = 6000.0;
  /// Whether telemetry's delays are random, as a radio's are. On a wire it keeps time with the
  /// line's transfers: where the clocks are nearly alike it waits equally long every time, which
  /// looks like a short and steady delay; there only pings count, which the host spreads.
  bool telemetry_waits_at_random = false;
  /// Pings meet the phases of the line's transfers in steps of this, microseconds: a byte at 115200
  /// baud. Half of it is uncertain however many pings there are.
  double phase_step_us = 87.0;
};

/// An instant of the robot on the host's clock.
struct HostEstimate {
  HostTime instant;
  /// The error is below this 9 times of 10 where the fastest bytes take as long to the robot as
  /// back, in microseconds.
  double uncertainty_us = 0.0;
  /// What is left where they do not: half of the fastest way there and back, in microseconds.
  double asymmetry_us = 0.0;
};

/// Places the robot's clock on the host's. What the robot has stamped arrives later and what the
/// host has sent was sent earlier than the robot's stamp says; two convex hulls, of arrivals from
/// above and of pings from below, leave a corridor. The line in its middle is the answer; its rate
/// is the most likely one (Moon, Skelly and Towsley 1999, there for one direction). It takes
/// instants and reads no clock.
class ClockSync {
 public:
  /// Throws std::invalid_argument where a window, period or rate error is not positive.
  explicit ClockSync(const ClockSyncParams& params = {});

  /// Telemetry stamped `stamp_us` has arrived. Not older than half a wrap (35.8 minutes) than the
  /// last stamp, as below.
  void add_telemetry(std::uint32_t stamp_us, HostTime arrived);
  /// A ping that was sent at `sent` found the robot's clock at `stamp_us`.
  void add_ping(HostTime sent, std::uint32_t stamp_us, HostTime answered);
  /// The robot was reset: all that was known of its clock is void.
  void restart();

  /// Where a stamp since the last restart lies on the host's clock; empty before the first ping was
  /// answered.
  std::optional<HostEstimate> host_time(std::uint32_t stamp_us) const;

  /// Of the last stamp, as in HostEstimate; empty as above.
  std::optional<double> uncertainty_us() const;

  /// How much faster than the host's clock the robot's runs; empty as above.
  std::optional<double> rate_error_ppm() const;

 private:
  /// host = host_us + rate * (robot - robot_us).
  struct Line {
    std::int64_t robot_us = 0;
    double host_us = 0.0;
    double rate = 1.0;
    double uncertainty_us = 0.0;    ///< At `robot_us`.
    double rate_uncertainty = 0.0;  ///< Microseconds in a microsecond.
    double asymmetry_us = 0.0;

    double uncertainty_us_at(RobotTime stamp) const;
  };

  void add_arrival(RobotTime stamp, HostTime arrived);
  void fit();
  double likely_rate(const LowerHull& arrivals, const LowerHull& sendings, double trust) const;
  double share_of_arrivals(double rate) const;
  double arrivals_excess_us(double rate) const;

  ClockSyncParams params_;
  RobotTimeUnwrapper unwrapper_;
  SlidingLowerHull arrivals_;  ///< All that count.
  SlidingLowerHull pongs_;     ///< Those arrivals that answer a ping.
  SlidingLowerHull sendings_;  ///< Upside down: lower is later.
  HostTime next_fit_;
  std::optional<Line> line_;
};

}  // namespace echomap::time
