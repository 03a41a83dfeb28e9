// SPDX-License-Identifier: MIT
#include "tests/hil_mock/line_faults/clock_errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "host/robot_link/ping_sender.hpp"
#include "host/robot_link/robot_link_params.hpp"
#include "host/time/clock_sync.hpp"

namespace echomap::line_faults {
namespace {

using std::chrono::microseconds;
using time::HostTime;

/// Between two looks of the host at whether a ping is due.
constexpr double kPollUs = 1000.0;
constexpr std::int64_t kOdometryUs = 20'000;
/// Of the firmware's main loop.
constexpr double kLoopUs = 100.0;
/// A byte to the robot, at 115200 baud.
constexpr double kByteUs = 86.8;

/// As the host sets the link for such a line.
robot_link::RobotLinkParams link_over(const LineDelays& line) {
  const bool is_radio = line.to_host.poll_us == 0;
  return is_radio ? robot_link::radio_link() : robot_link::wired_link(115200);
}

world::NoiseStream noise(std::uint32_t seed) { return {seed, world::NoisePurpose::kLineDelays}; }

/// One robot, one line, one host; events in the order of the host's clock.
class Run {
 public:
  Run(const LineDelays& line, double rate_error_ppm, std::uint32_t seed, ClockErrors& errors)
      : rate_(1.0 + rate_error_ppm * 1e-6),
        to_host_(line.to_host, noise(3 * seed)),
        to_robot_(line.to_robot, noise(3 * seed + 1)),
        loop_(noise(3 * seed + 2)),
        errors_(errors),
        clock_(link_over(line).clock),
        pings_(link_over(line).ping) {}

  void run(std::int64_t end_us) {
    send_odometry(kOdometryUs);
    pings_.restart(HostTime{});
    at(1000, [this] { send_ping(); });
    while (!events_.empty() && events_.begin()->first < end_us) {
      const auto event = std::move(events_.begin()->second);
      now_us_ = events_.begin()->first;
      events_.erase(events_.begin());
      event();
    }
  }

 private:
  std::int64_t loop_us() { return std::llround(loop_.uniform() * kLoopUs); }
  static HostTime at_us(std::int64_t instant_us) { return HostTime(microseconds(instant_us)); }
  std::uint32_t stamp_us(std::int64_t host_us) const {
    return static_cast<std::uint32_t>(std::llround(static_cast<double>(host_us) * rate_));
  }
  void at(std::int64_t instant_us, std::function<void()> event) {
    events_.emplace(instant_us, std::move(event));
  }

  void send_odometry(std::int64_t robot_us) {
    at(std::llround(static_cast<double>(robot_us) / rate_), [this, robot_us] {
      const auto stamp = static_cast<std::uint32_t>(robot_us);
      at(to_host_.arrival_us(now_us_ + loop_us()), [this, stamp] { take_odometry(stamp); });
      send_odometry(robot_us + kOdometryUs);
    });
  }

  void take_odometry(std::uint32_t stamp) {
    clock_.add_telemetry(stamp, at_us(now_us_));
    const auto estimate = clock_.host_time(stamp);
    if (estimate && now_us_ >= kLockedAfterUs) {
      const auto instant_us = static_cast<double>(estimate->instant.time_since_epoch().count());
      const double error_us = std::abs(instant_us - static_cast<double>(stamp) / rate_);
      errors_.note(now_us_, error_us, estimate->uncertainty_us);
    }
  }

  void send_ping() {
    const auto lead_us = std::llround(static_cast<double>(pings_.lead_bytes()) * kByteUs);
    const std::uint32_t token = pings_.take(at_us(now_us_), clock_.uncertainty_us());
    at(to_robot_.arrival_us(now_us_) + lead_us, [this, token] { answer_ping(token); });
    const std::int64_t due_us = pings_.next_due().time_since_epoch().count();
    at(due_us + std::llround(loop_.uniform() * kPollUs), [this] { send_ping(); });
  }

  void answer_ping(std::uint32_t token) {
    const std::uint32_t stamp = stamp_us(now_us_);
    at(to_host_.arrival_us(now_us_ + loop_us()), [this, token, stamp] {
      if (const auto sent = pings_.take_answer(token)) {
        clock_.add_ping(*sent, stamp, at_us(now_us_));
      }
    });
  }

  double rate_;
  DelayModel to_host_;
  DelayModel to_robot_;
  world::NoiseStream loop_;
  ClockErrors& errors_;
  time::ClockSync clock_;
  robot_link::PingSender pings_;
  std::multimap<std::int64_t, std::function<void()>> events_;
  std::int64_t now_us_ = 0;
};

}  // namespace

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

ClockErrors measure_clock(const LineDelays& line,
                          double rate_error_ppm,
                          std::uint32_t seeds,
                          std::int64_t end_us) {
  ClockErrors errors;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    Run(line, rate_error_ppm, seed, errors).run(end_us);
  }
  return errors;
}

}  // namespace echomap::line_faults
