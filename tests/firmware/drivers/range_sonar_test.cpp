// SPDX-License-Identifier: MIT
#include "firmware/drivers/range_sonar.hpp"

#include <gtest/gtest.h>

#include "firmware/boards/native/native_board.hpp"
#include "firmware/drivers/sonar.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::drivers {
namespace {

using hal::RangeReading;

constexpr std::uint16_t kMaxEchoUs = 24000;

class RangeSonarTest : public testing::Test {
 protected:
  RangeSonarTest() { show(RangeReading::State::kRange, 1000); }
  ~RangeSonarTest() override { native::NativeBoard::instance().range_sensor.reset(); }

  static void show(RangeReading::State state, std::uint16_t range_mm) {
    native::NativeBoard::instance().range_sensor = RangeReading{state, range_mm, 100};
  }

  std::uint16_t flight_us = 0;
  RangeSonar sonar;
};

TEST_F(RangeSonarTest, AnswersNotBeforeAReadingIsSurelyNewerThanThePing) {
  sonar.ping(0xFFFFFF00U);
  EXPECT_FALSE(sonar.poll(0xFFFFFF00U + 99999U, kMaxEchoUs, flight_us));
  EXPECT_TRUE(sonar.poll(0xFFFFFF00U + 100000U, kMaxEchoUs, flight_us));
  EXPECT_FALSE(sonar.poll(0xFFFFFF00U + 100001U, kMaxEchoUs, flight_us));
}

TEST_F(RangeSonarTest, TakesTheReadingOfThatTimeAndNotOfThePing) {
  sonar.ping(0);
  show(RangeReading::State::kRange, 500);
  EXPECT_TRUE(sonar.poll(100000, kMaxEchoUs, flight_us));
  EXPECT_EQ(flight_us, 2914);  // 1 m at 343.2 m/s.
}

TEST_F(RangeSonarTest, RangesOfASensorComeBackToHalfAMillimetre) {
  for (std::uint16_t range_mm = 0; range_mm <= 2550; ++range_mm) {
    show(RangeReading::State::kRange, range_mm);
    sonar.ping(0);
    ASSERT_TRUE(sonar.poll(100000, kMaxEchoUs, flight_us));
    ASSERT_NEAR(flight_us * 343.2e-3 / 2, range_mm, 0.5);
  }
}

TEST_F(RangeSonarTest, NothingWithinReachAndEchoesBeyondTheLimitAreNoEcho) {
  show(RangeReading::State::kNothing, 0);
  sonar.ping(0);
  EXPECT_TRUE(sonar.poll(100000, kMaxEchoUs, flight_us));
  EXPECT_EQ(flight_us, protocol::kNoEcho);
  show(RangeReading::State::kRange, 1000);
  sonar.ping(0);
  EXPECT_TRUE(sonar.poll(100000, 5827, flight_us));
  EXPECT_EQ(flight_us, protocol::kNoEcho);
}

TEST_F(RangeSonarTest, SensorThatIsNotThereIsToldAtOnce) {
  show(RangeReading::State::kAbsent, 0);
  sonar.ping(0);
  EXPECT_TRUE(sonar.poll(1, kMaxEchoUs, flight_us));
  EXPECT_EQ(flight_us, protocol::kNoSonar);
}

TEST_F(RangeSonarTest, SonarOfABoardWithSuchASensorAsksItAndNoEchoPin) {
  Sonar either;
  EXPECT_TRUE(Sonar::ready());
  either.ping(0);
  EXPECT_TRUE(either.poll(100000, kMaxEchoUs, flight_us));
  EXPECT_EQ(flight_us, 5828);
}

}  // namespace
}  // namespace echomap::drivers
