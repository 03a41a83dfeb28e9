// SPDX-License-Identifier: MIT
#include <cstdint>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/hil_mock/line_faults/clock_errors.hpp"
#include "tests/support/every_seed.hpp"

// host/time/clock_sync over the delay models; the table of docs/protocol.md.
namespace echomap::line_faults {
namespace {

constexpr std::int64_t kEndUs = 900'000'000;

struct Line {
  std::string name;
  LineDelays delays;
  double bound_us;
};

Line usb() { return {"usb", usb_line(), 200.0}; }
Line ftdi() { return {"ftdi", ftdi_line(), 200.0}; }
Line bluetooth() { return {"bluetooth", bluetooth_line(), 500.0}; }

ClockErrors errors_of(const Line& line,
                      double rate_error_ppm,
                      std::uint32_t seeds = 6,
                      std::int64_t end_us = kEndUs) {
  ClockErrors errors = measure_clock(line.delays, rate_error_ppm, seeds, end_us);
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
    const ClockErrors errors = errors_of(line, GetParam());
    EXPECT_LE(quantile(errors.all_us, 0.99), line.bound_us);
    const auto count = static_cast<double>(errors.all_us.size());
    EXPECT_GE(static_cast<double>(errors.covered) / count, 0.9);
  }
};

TEST_P(ClockAccuracy, HoldsOnUsb) { check(usb()); }
TEST_P(ClockAccuracy, HoldsOnFtdi) { check(ftdi()); }
TEST_P(ClockAccuracy, HoldsOnBluetooth) { check(bluetooth()); }

/// Nine in ten sessions; docs/protocol.md tells of the others.
TEST_P(ClockAccuracy, HoldsInTheSixthSecondOfNineInTenSessions) {
  for (const Line& line : {usb(), ftdi(), bluetooth()}) {
    const ClockErrors errors = errors_of(line, GetParam(), 30, kLockedAfterUs + 1'000'000);
    EXPECT_LE(quantile(errors.first_second_us, 0.9), line.bound_us) << line.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Rates, ClockAccuracy, testing::Values(50.0, -2000.0, 5000.0, -5000.0));

/// Transfers that keep their pace to the microsecond, and robots whose clock is as fast, nearly as
/// fast, or far from it; every seed has other phases.
class ClockAccuracyInABeat : public ClockAccuracy {
 protected:
  static void check_in_a_beat(Line line) {
    line.delays.to_host.poll_beats = line.delays.to_robot.poll_beats = true;
    const std::uint32_t seeds = tests::runs_every_seed() ? 30 : 10;
    const ClockErrors errors = errors_of(line, GetParam(), seeds, kEndUs / 3);
    EXPECT_LE(quantile(errors.all_us, 0.99), line.bound_us);
    EXPECT_LE(quantile(errors.first_second_us, 0.99), line.bound_us);
    const auto count = static_cast<double>(errors.all_us.size());
    EXPECT_GE(static_cast<double>(errors.covered) / count, 0.9);
  }
};

TEST_P(ClockAccuracyInABeat, HoldsOnUsb) { check_in_a_beat(usb()); }
TEST_P(ClockAccuracyInABeat, HoldsOnFtdi) { check_in_a_beat(ftdi()); }

INSTANTIATE_TEST_SUITE_P(
    Rates,
    ClockAccuracyInABeat,
    testing::Values(0.0, 10.0, -10.0, 20.0, -20.0, 50.0, -50.0, -2000.0, 5000.0, -5000.0));

}  // namespace
}  // namespace echomap::line_faults
