// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hil_mock/line_faults/delay_model.hpp"
#include "host/robot_link/ping_sender.hpp"
#include "host/time/clock_sync.hpp"

// host/time/clock_sync over the delay models: 900 s of odometry at 50 Hz and of pings as RobotLink
// sends them. The shortest delays of both directions are equal; half of what they differ by on a
// real line comes on top.
namespace echomap::line_faults {
namespace {

using std::chrono::microseconds;
using time::HostTime;

constexpr std::int64_t kEndUs = 900'000'000;
constexpr std::int64_t kLockedAfterUs = 5'000'000;
/// Between two looks of the host at whether a ping is due.
constexpr double kPollUs = 1000.0;
constexpr std::int64_t kOdometryUs = 20'000;
/// Of the firmware's main loop.
constexpr double kLoopUs = 100.0;

struct Line {
  std::string name;
  LineDelays delays;
  double bound_us;
};

Line usb() { return {"usb", usb_line(), 200.0}; }
Line ftdi() { return {"ftdi", ftdi_line(), 200.0}; }
Line bluetooth() { return {"bluetooth", bluetooth_line(), 500.0}; }

world::NoiseStream noise(std::uint32_t seed) { return {seed, world::NoisePurpose::kLineDelays}; }

/// Errors of stamps at the moment when they arrive.
struct Errors {
  std::vector<double> all_us;
  std::vector<double> first_second_us;  ///< Of the second after `kLockedAfterUs`.
  std::size_t covered = 0;

  void note(std::int64_t now_us, double error_us, double uncertainty_us) {
    all_us.push_back(error_us);
    covered += error_us <= uncertainty_us ? 1 : 0;
    if (now_us < kLockedAfterUs + 1'000'000) {
      first_second_us.push_back(error_us);
    }
  }
};

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// One robot, one line, one host; events in the order of the host's clock.
class Run {
 public:
  Run(const Line& line, double rate_error_ppm, std::uint32_t seed, Errors& errors)
      : rate_(1.0 + rate_error_ppm * 1e-6),
        to_host_(line.delays.to_host, noise(3 * seed)),
        to_robot_(line.delays.to_robot, noise(3 * seed + 1)),
        loop_(noise(3 * seed + 2)),
        errors_(errors) {}

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
    const std::uint32_t token = pings_.take(at_us(now_us_), clock_.uncertainty_us());
    at(to_robot_.arrival_us(now_us_), [this, token] { answer_ping(token); });
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
  Errors& errors_;
  time::ClockSync clock_;
  robot_link::PingSender pings_{{}};
  std::multimap<std::int64_t, std::function<void()>> events_;
  std::int64_t now_us_ = 0;
};

Errors errors_of(const Line& line,
                 double rate_error_ppm,
                 std::uint32_t seeds = 6,
                 std::int64_t end_us = kEndUs) {
  Errors errors;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    Run(line, rate_error_ppm, seed, errors).run(end_us);
  }
  std::cout << line.name << ' ' << rate_error_ppm << " ppm: p50 " << quantile(errors.all_us, 0.5)
            << " us, p99 " << quantile(errors.all_us, 0.99) << " us, sixth second p99 "
            << quantile(errors.first_second_us, 0.99) << " us, covered "
            << 100.0 * static_cast<double>(errors.covered) /
                   static_cast<double>(errors.all_us.size())
            << " %\n";
  return errors;
}

class ClockAccuracy : public testing::TestWithParam<double> {
 protected:
  static void check(const Line& line) {
    const Errors errors = errors_of(line, GetParam());
    EXPECT_LE(quantile(errors.all_us, 0.99), line.bound_us);
    EXPECT_LE(quantile(errors.first_second_us, 0.99), line.bound_us);
    const auto count = static_cast<double>(errors.all_us.size());
    EXPECT_GE(static_cast<double>(errors.covered) / count, 0.9);
  }
};

TEST_P(ClockAccuracy, HoldsOnUsb) { check(usb()); }
TEST_P(ClockAccuracy, HoldsOnFtdi) { check(ftdi()); }
TEST_P(ClockAccuracy, HoldsOnBluetooth) { check(bluetooth()); }

TEST_P(ClockAccuracy, HoldsInTheSixthSecondOfThirtySeeds) {
  for (const Line& line : {usb(), ftdi(), bluetooth()}) {
    const Errors errors = errors_of(line, GetParam(), 30, kLockedAfterUs + 1'000'000);
    EXPECT_LE(quantile(errors.first_second_us, 0.99), line.bound_us) << line.name;
  }
}

TEST_P(ClockAccuracy, HoldsOnUsbWhereItsFramesBeatWithTheTelemetry) {
  Line line = usb();
  line.delays.to_host.poll_beats = line.delays.to_robot.poll_beats = true;
  EXPECT_LE(quantile(errors_of(line, GetParam()).all_us, 0.99), line.bound_us);
}

TEST(ClockAccuracyInABeat, ComesCloseOnFtdiWhereItsTimerBeatsWithTheTelemetry) {
  Line line = ftdi();
  line.delays.to_host.poll_beats = line.delays.to_robot.poll_beats = true;
  const Errors errors = errors_of(line, 50.0);
  EXPECT_LE(quantile(errors.all_us, 0.5), 20.0);
  EXPECT_LE(quantile(errors.all_us, 0.99), 600.0);
}

INSTANTIATE_TEST_SUITE_P(Rates, ClockAccuracy, testing::Values(50.0, -2000.0, 5000.0, -5000.0));

}  // namespace
}  // namespace echomap::line_faults
