// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/delay_model.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace echomap::line_faults {
namespace {

world::NoiseStream delay_noise(std::uint32_t seed) {
  return {seed, world::NoisePurpose::kLineDelays};
}

/// Sorted delays of frames that are sent 200 ms apart.
std::vector<std::int64_t> delays_us(const DelayParams& params) {
  DelayModel model(params, delay_noise(1));
  std::vector<std::int64_t> delays_us;
  for (std::int64_t sent_us = 0; sent_us < 2'000'000'000; sent_us += 200'003) {
    delays_us.push_back(model.arrival_us(sent_us) - sent_us);
  }
  std::ranges::sort(delays_us);
  return delays_us;
}

std::int64_t quantile(const std::vector<std::int64_t>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size()))];
}

TEST(DelayModel, NeverReorders) {
  for (const DelayParams& params : {usb_delays(), ftdi_delays(), bluetooth_delays()}) {
    DelayModel model(params, delay_noise(2));
    std::int64_t last_us = 0;
    for (std::int64_t sent_us = 0; sent_us < 10'000'000; sent_us += 500) {
      const std::int64_t arrival_us = model.arrival_us(sent_us);
      EXPECT_GE(arrival_us, sent_us);
      EXPECT_GE(arrival_us, last_us);
      last_us = arrival_us;
    }
  }
}

TEST(DelayModel, UsbAndFtdiWaitForTheirTransfers) {
  for (const bool beats : {false, true}) {
    DelayParams usb = usb_delays();
    usb.poll_beats = beats;
    EXPECT_NEAR(static_cast<double>(quantile(delays_us(usb), 0.5)), 500.0, 20.0);
    EXPECT_LE(quantile(delays_us(usb), 0.99), 1000);
    DelayParams ftdi = ftdi_delays();
    ftdi.poll_beats = beats;
    EXPECT_NEAR(static_cast<double>(quantile(delays_us(ftdi), 0.5)), 8000.0, 300.0);
    EXPECT_LE(quantile(delays_us(ftdi), 0.99), 16'000);
  }
}

TEST(DelayModel, BluetoothHasATailAndStalls) {
  const auto delays = delays_us(bluetooth_delays());
  EXPECT_GE(delays.front(), 8000);
  EXPECT_NEAR(static_cast<double>(quantile(delays, 0.5)), 8000.0 + 0.693 * 6000.0, 300.0);
  EXPECT_LT(quantile(delays, 0.97), 60'000);
  EXPECT_GT(quantile(delays, 0.99), 150'000);
}

TEST(DelayModel, AHostIsBusyNowAndThen) {
  const auto delays = delays_us(usb_delays());
  EXPECT_GT(delays.back(), 20'000);
  EXPECT_LE(delays.back(), 51'000);
}

TEST(DelayModel, RepeatsWithItsSeed) {
  DelayModel first(bluetooth_delays(), delay_noise(5));
  DelayModel second(bluetooth_delays(), delay_noise(5));
  for (std::int64_t sent_us = 0; sent_us < 1'000'000; sent_us += 1000) {
    EXPECT_EQ(first.arrival_us(sent_us), second.arrival_us(sent_us));
  }
}

}  // namespace
}  // namespace echomap::line_faults
