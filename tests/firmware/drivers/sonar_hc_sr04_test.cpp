// SPDX-License-Identifier: MIT
#include "firmware/drivers/sonar_hc_sr04.hpp"

#include <gtest/gtest.h>

#include "protocol/telemetry_messages.hpp"

namespace echomap::drivers {
namespace {

constexpr std::uint16_t kMaxEchoUs = 24000;

/// Asks every millisecond from `ping_us` on; the time until the answer, or 0 within `limit_ms`.
std::uint32_t answered_after_us(SonarHcSr04& sonar, std::uint32_t ping_us, std::uint16_t& flight) {
  for (std::uint32_t us = 0; us < 100000; us += 1000) {
    if (sonar.poll(ping_us + us, kMaxEchoUs, flight)) {
      return us;
    }
  }
  return 0;
}

TEST(SonarHcSr04, SubtractsTheEdges) {
  SonarHcSr04 sonar;
  std::uint16_t flight_us = 0;
  sonar.ping(1000);
  EXPECT_FALSE(sonar.poll(1100, kMaxEchoUs, flight_us));
  sonar.on_echo_edge(true, 2920);
  EXPECT_FALSE(sonar.poll(1500, kMaxEchoUs, flight_us));
  sonar.on_echo_edge(false, 2920 + 2 * 5830);
  EXPECT_TRUE(sonar.poll(8000, kMaxEchoUs, flight_us));
  EXPECT_EQ(flight_us, 5830);
  EXPECT_FALSE(sonar.poll(9000, kMaxEchoUs, flight_us));
}

TEST(SonarHcSr04, SubtractsAcrossTheWrapOfTheClock) {
  SonarHcSr04 sonar;
  std::uint16_t flight_us = 0;
  sonar.ping(0xFFFFFF00U);
  sonar.on_echo_edge(true, 0xFFFFFFF0U);
  sonar.on_echo_edge(false, 0x00000010U);
  EXPECT_TRUE(sonar.poll(0x00000100U, kMaxEchoUs, flight_us));
  EXPECT_EQ(flight_us, 16);
}

TEST(SonarHcSr04, WhereNoPulseBeginsThereIsNoSonar) {
  SonarHcSr04 sonar;
  std::uint16_t flight_us = 0;
  sonar.ping(5000);
  const std::uint32_t after_us = answered_after_us(sonar, 5000, flight_us);
  EXPECT_GT(after_us, SonarHcSr04::kRiseTimeoutUs);
  EXPECT_LE(after_us, SonarHcSr04::kRiseTimeoutUs + 1000U);
  EXPECT_EQ(flight_us, protocol::kNoSonar);
}

TEST(SonarHcSr04, GivesUpOnAPulseThatDoesNotEnd) {
  SonarHcSr04 sonar;
  std::uint16_t flight_us = 0;
  sonar.ping(5000);
  sonar.on_echo_edge(true, 2 * 5460);
  const std::uint32_t after_us = answered_after_us(sonar, 5000, flight_us);
  EXPECT_GT(after_us, kMaxEchoUs);
  EXPECT_LE(after_us, kMaxEchoUs + SonarHcSr04::kRiseTimeoutUs + 1000U);
  EXPECT_EQ(flight_us, protocol::kNoEcho);
  sonar.on_echo_edge(false, 2 * 43460);
  EXPECT_FALSE(sonar.poll(50000, kMaxEchoUs, flight_us));
}

TEST(SonarHcSr04, EchoBeyondTheLimitCountsAsNone) {
  for (const std::uint32_t flight_us : {24000U, 24001U}) {
    SonarHcSr04 sonar;
    std::uint16_t answer = 0;
    sonar.ping(0);
    sonar.on_echo_edge(true, 1000);
    sonar.on_echo_edge(false, 1000 + 2 * flight_us);
    ASSERT_TRUE(sonar.poll(25000, kMaxEchoUs, answer));
    EXPECT_EQ(answer, flight_us <= kMaxEchoUs ? flight_us : protocol::kNoEcho);
  }
}

TEST(SonarHcSr04, EdgesThatNobodyAskedForAreNotAnEcho) {
  SonarHcSr04 sonar;
  std::uint16_t flight_us = 0;
  sonar.on_echo_edge(true, 100);
  sonar.on_echo_edge(false, 200);
  EXPECT_FALSE(sonar.poll(1000, kMaxEchoUs, flight_us));
  sonar.ping(2000);
  sonar.on_echo_edge(false, 4100);
  EXPECT_FALSE(sonar.poll(3000, kMaxEchoUs, flight_us));
}

}  // namespace
}  // namespace echomap::drivers
