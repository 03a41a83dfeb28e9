// SPDX-License-Identifier: MIT
#include "host/datasets/big_wheel_bot_log.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "host/geometry/angle.hpp"
#include "host/sensors/range_scan.hpp"
#include "tests/support/log_test.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::datasets {
namespace {

using geometry::radians;
using ::testing::HasSubstr;

class BigWheelBotLogTest : public tests::LogTest {
 protected:
  BigWheelBotLogTest() : LogTest("Garden.txt", open_big_wheel_bot_log) {}
};

TEST_F(BigWheelBotLogTest, YawIsTurnedFromClockwise) {
  const auto headings =
      tests::only<Heading>(read("0,0,-155,376,97,60,60,105,-98\n"
                                "0,0,180,376,97,60,60,105,-98\n"));
  EXPECT_DOUBLE_EQ(headings.at(0).heading_rad, radians(155.0));
  EXPECT_DOUBLE_EQ(headings.at(1).heading_rad, std::numbers::pi);
}

TEST_F(BigWheelBotLogTest, TicksAreThoseOfTheLine) {
  const auto wheels = tests::only<WheelIncrement>(read("4,-2,0,1,1,1,1,0,0\n4,-2,0,1,1,1,1,0,0\n"));
  ASSERT_EQ(wheels.size(), 2U);
  for (const auto& increment : wheels) {
    EXPECT_EQ(increment.left_m, 0.020);
    EXPECT_EQ(increment.right_m, -0.010);
    EXPECT_EQ(increment.stamp_s, std::nullopt);
  }
}

TEST_F(BigWheelBotLogTest, FiveMetresOfASonarAndSixtyCentimetresOfInfraredAreNoReturn) {
  const auto scans = tests::only<sensors::RangeScan>(read("0,0,0,499,500,59,60,0,0\n"));
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].beams,
            (std::vector<sensors::Beam>{{0.0, 4.99}, {std::numbers::pi, std::nullopt}}));
  EXPECT_EQ(scans[1].beams,
            (std::vector<sensors::Beam>{{radians(45.0), 0.59}, {radians(-45.0), std::nullopt}}));
}

TEST_F(BigWheelBotLogTest, ErrorsNameTheLine) {
  EXPECT_THAT(error_of("0,0,0,1,1,1,1,0,0\n1,2,3,4,5\n"), HasSubstr("Garden.txt:2: the left IR"));
}

TEST(RealBigWheelBotLogs, AreAsLongAsTheirReadmeSays) {
  struct Case {
    const char* file;
    std::size_t lines;
    double path_m;
  };
  for (const auto& [file, lines, path_m] : {Case{"Garden_04_04_20.txt", 1474, 67.9},
                                            Case{"Garden_10_04_20.txt", 1666, 71.2},
                                            Case{"Garden_15_03_20.txt", 864, 58.4},
                                            Case{"Garden_27_03_20_3.txt", 871, 62.2},
                                            Case{"Garden_small.txt", 424, 10.2}}) {
    const auto path = tests::real_data("bigwheelbot_hcsr04") / file;
    ECHOMAP_SKIP_WITHOUT(path);
    const auto wheels =
        tests::only<WheelIncrement>(tests::records_of(*open_big_wheel_bot_log(path)));
    EXPECT_EQ(wheels.size(), lines) << file;
    double found_m = 0.0;
    for (const auto& increment : wheels) {
      found_m += std::abs(increment.left_m + increment.right_m) / 2.0;
    }
    EXPECT_NEAR(found_m, path_m, 0.06) << file;
  }
}

}  // namespace
}  // namespace echomap::datasets
